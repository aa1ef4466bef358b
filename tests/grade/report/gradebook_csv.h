// The class as a table for spreadsheets and course systems.
#pragma once

#include <span>
#include <string>

#include "tests/grade/result.h"

namespace rt::grade
{

/// One row a student: student, lesson, state, points, most, percent, the points of each exercise, sandbox, remarks. RFC
/// 4180 with CRLF, in UTF-8. A cell of foreign text that a spreadsheet would take for a formula begins with an apostrophe.
/// Who could not be graded has 0 points of as many as the others.
std::string gradebookCsv(std::span<const SubmissionResult> results);

} // namespace rt::grade
