// results.json: what Gradescope reads, and in it all that reads a result back: to resume, to merge, for reports of a criterion.
#pragma once

#include <string>

#include "tests/grade/result.h"

namespace rt::grade
{

/// When Gradescope shows students the criteria of hidden cases (of which there is a name, points and a likely mistake).
enum class HiddenTests
{
    visible,
    afterPublished, ///< with the grades
    never           ///< Gradescope then does not show the sum either
};

/// The file's text, in ASCII. `score` (only where no criterion is hidden from the student for now), `tests` and `output` are for the
/// student and rounded; `extra_data` is exact, for
/// programs and instructors, and alone has what the student's program printed. Pictures are left out. Foreign text is
/// repaired, of everything but the student's name the first 4 KiB are kept. A field that is not finite where a number
/// must be throws std::runtime_error.
std::string resultsJson(const SubmissionResult& result, HiddenTests hidden = HiddenTests::afterPublished);

/// The result that resultsJson wrote, without the pixels of its pictures. Throws std::runtime_error with one sentence
/// that names the field if anything in it is missing, unknown, of another type or out of range.
SubmissionResult resultFromJson(const std::string& text);

/// resultFromJson of a file; the sentence then names the file.
SubmissionResult readResult(const std::string& path);

} // namespace rt::grade
