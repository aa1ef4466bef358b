// Which known mistake a student has probably made: the mutant (tests/lessons/mutants.toml) that gives the same wrong answers.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/grade/candidate.h"

namespace rt::grade
{

/// Wrong answers to public questions of one exercise: which question -> the answer as text.
using Evidence = std::map<std::string, std::string>;

struct KnownMistake
{
    std::string id;                           ///< "06-no-squares"
    std::string mistake;                      ///< "the squares are missing, as printed"
    std::map<std::string, Evidence> evidence; ///< by exercise
};

/// "this looks like: n1 and n2 are swapped"; empty if no mistake explains the evidence. It is named only if all answers but
/// 1 in 20 are those of the mutant, and the same questions fail; numbers agree to five digits.
std::string likelyMistake(const std::string& exercise, const Evidence& evidence,
                          const std::vector<KnownMistake>& known);

/// The wrong answers of a candidate to the lesson's own cases, by exercise. Needs no lesson to compare with.
std::map<std::string, Evidence> ownCasesEvidence(const Candidate& candidate, int lesson);

/// For a hand-out without lessons and mutants: what each mutant answers to the lesson's own cases, as JSON. It gives no
/// solution away.
std::string mistakesJson(int lesson);
/// Reads what mistakesJson wrote. Throws std::runtime_error with one sentence.
std::vector<KnownMistake> mistakesFromJson(const std::string& json);

} // namespace rt::grade
