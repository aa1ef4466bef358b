// The class as JUnit XML, which most servers that run tests can show.
#pragma once

#include <span>
#include <string>

#include "tests/grade/result.h"

namespace rt::grade
{

/// A testsuite a student, a testcase a class of cases. A class without full marks is a failure with the feedback that
/// the student may see; a submission that could not be graded is one error. What programs printed is not in it.
std::string junitXml(std::span<const SubmissionResult> results);

} // namespace rt::grade
