// Whoever is asked: a student's process, a lesson, a mutant. Lesson 00 is functions of numbers, the others are tracers.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "tests/cases/lesson00_cases.h"
#include "tests/cases/subject.h"
#include "tests/grade/result.h"

namespace rt::grade
{

struct Candidate
{
    cases::Subject tracer = {};           ///< lessons 01 to 08; its functions are empty in lesson 00
    cases::GeometrySubject geometry = {}; ///< lesson 00; empty functions otherwise
    /// A hash of all answers since it was last called; two runs of an honest program give the same. Empty in our own process.
    std::function<std::uint64_t()> fingerprint = {};
};

/// A student's process ended, or answered nonsense, while it was asked. It is started anew for the next question.
struct Died : std::runtime_error
{
    Died(Outcome why, const std::string& sentence) : std::runtime_error(sentence), outcome(why) {}
    Outcome outcome;
};

/// Something of ours failed, as a box that cannot be started: no verdict about a student. It is no std::exception on purpose:
/// whoever catches what a student's code throws lets this one pass.
class GraderError
{
public:
    explicit GraderError(std::string why) : sentence(std::move(why)) {}
    const char* what() const { return sentence.c_str(); }

private:
    std::string sentence;
};

/// The lesson itself, in double: what the answers of a student are compared with. Lesson 00 to 08.
Candidate reference(int lesson);

} // namespace rt::grade
