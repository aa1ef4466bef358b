// Which known mistake a student has probably made: the mutant (tests/lessons/mutants.toml) that gives the same wrong answers.
#pragma once

#include <map>
#include <set>
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

struct WrongAnswers
{
    std::map<std::string, Evidence> evidence; ///< by exercise; only where something is wrong
    std::set<std::string> unfinished;         ///< exercises that have not been attempted, or that ask one that has not
};

/// By exercise: "n1 and n2 are swapped". Of the questions that the student or the mutant answers wrongly, all but 1 in 20 must be
/// answered alike (numbers to five digits). These must be at least three, or one of them must hold a number of five digits or
/// more. And the mutant must not fail in an exercise in which the student does not.
std::map<std::string, std::string> likelyMistakes(const WrongAnswers& wrong, const std::vector<KnownMistake>& known);

/// The wrong answers of a candidate to the lesson's own cases. Needs no lesson to compare with.
WrongAnswers ownCasesAnswers(const Candidate& candidate, int lesson);

/// For a hand-out without lessons and mutants: what each mutant answers to the lesson's own cases, as JSON. It gives no
/// solution away.
std::string mistakesJson(int lesson);
/// Reads what mistakesJson wrote. Throws std::runtime_error with one sentence.
std::vector<KnownMistake> mistakesFromJson(const std::string& json);

} // namespace rt::grade
