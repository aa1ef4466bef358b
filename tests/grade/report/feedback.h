// What is said about a result, in words: all reports say the same. Plain text, cleaned, not yet escaped.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/grade/result.h"

namespace rt::grade
{

/// Full marks were earned: what is not true of any other criterion is feedback worth reading.
bool isFull(const CriterionResult& one);

/// "2.5", "10": at most two decimals.
std::string pointsText(double points);

/// "06-fresnel: into glass", with ", hidden cases" if they are.
std::string criterionName(const CriterionResult& one);

/// How a criterion ended, for the student, line by line. Of hidden cases only a likely mistake.
std::vector<std::string> criterionFeedback(const CriterionResult& one);

/// How far the submission came, for the student: "Graded: 7.5 of 10 points." or the state and the reason.
std::string stateSentence(const SubmissionResult& result);

/// One exercise of a submission: the sums over its criteria, in the order of the first of each.
struct ExercisePoints
{
    std::string exercise;
    double points = 0, most = 0;
};
std::vector<ExercisePoints> pointsByExercise(std::span<const CriterionResult> criteria);

} // namespace rt::grade
