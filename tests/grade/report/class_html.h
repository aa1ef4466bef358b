// The page of a class, for the instructor.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "tests/grade/result.h"

namespace rt::grade
{

/// Where the pages of a student are, relative to the page of the class; "" if there is none.
struct PageLinks
{
    std::function<std::string(const std::string&student)> student, instructor;
};

/// How hard each class of cases was, how the points are spread, which mistakes are common, and all students.
std::string classHtml(std::span<const SubmissionResult> results, const PageLinks& links = {});

} // namespace rt::grade
