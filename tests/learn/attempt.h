// One exercise file, compiled and asked all public cases in a process of its own.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/grade/candidate.h"
#include "tests/grade/questions/manifest.h"

namespace rt::grade
{

/// What came of one exercise.
struct Attempt
{
    Outcome outcome = Outcome::notRun; ///< passed: all its cases are right
    int cases = 0, passed = 0;
    std::string missing;     ///< the id of the exercise that still has its TODO, perhaps another one; empty: none
    std::string name, slide; ///< of the first case that fails: "Reflect: keeps the angle to the normal"
    Example example;         ///< of that case
    std::optional<PictureTriple> pictures; ///< of the first picture that is wrong
    std::string mistake;                   ///< "n1 and n2 are swapped"; empty: unknown
};

/// Runs the own cases of a lesson on a candidate: first those of the exercise `first`, then, as long as the candidate does not
/// die, the others', then the lesson's pictures, which count for the first. By the exercise's id; notRun: given up.
std::map<std::string, Attempt> runCases(const Candidate& candidate, const std::vector<Exercise>& exercises,
                                        const std::string& first);

/// "Reflect", "KeepsTheAngle" -> "Reflect: keeps the angle"
std::string caseName(const std::string& group, const std::string& name);

} // namespace rt::grade
