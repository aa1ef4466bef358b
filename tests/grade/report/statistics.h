// What a class of students has in common.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tests/grade/result.h"

namespace rt::grade
{

/// One class of cases over all who were graded.
struct ClassStatistics
{
    std::string exercise, name;
    bool hidden = false;
    int students = 0, full = 0; ///< who were asked; who earned all its points
    double share = 0;           ///< mean of points / most
    std::map<Outcome, int> outcomes;
};

struct Mistake
{
    std::string exercise, mistake;
    int students = 0;
};

/// By how many earned all points, the fewest first.
std::vector<ClassStatistics> classStatistics(std::span<const SubmissionResult> results);

/// Each counted once a student and exercise, the most common first.
std::vector<Mistake> commonMistakes(std::span<const SubmissionResult> results);

/// Graded students by their share of `most`: [0, 10) %, ..., [90, 100] %.
std::array<int, 10> histogram(std::span<const SubmissionResult> results, double most);

/// The ids of all exercises, in the order of the first submission that has them.
std::vector<std::string> exercisesOf(std::span<const SubmissionResult> results);

/// The points that could be earned: the most of any submission, for one that could not be graded has no classes.
double mostOf(std::span<const SubmissionResult> results);

} // namespace rt::grade
