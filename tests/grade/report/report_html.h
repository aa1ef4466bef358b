// The pages of one submission.
#pragma once

#include <string>

#include "tests/grade/result.h"

namespace rt::grade
{

/// For the student: points, what went wrong and where to look. Of hidden cases the name, points and a likely mistake.
/// What the student's program printed is not in it: it may have printed the hidden questions.
std::string reportHtml(const SubmissionResult& result);

/// For the instructor: the same, and what the program printed, the box, the times, the keys and all counts.
std::string instructorHtml(const SubmissionResult& result);

} // namespace rt::grade
