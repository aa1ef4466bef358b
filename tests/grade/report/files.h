// Where the reports of a class stand below one folder, and writing them. Every file is written whole or not at all.
#pragma once

#include <span>
#include <string>

#include "tests/grade/report/results_json.h"

namespace rt::grade
{

/// OUT/reports/NAME.html: the student's page.
std::string reportPath(const std::string& out, const std::string& student);
/// OUT/instructor/NAME.html: never below the folder that is handed to students.
std::string instructorPath(const std::string& out, const std::string& student);
/// OUT/results/NAME/results.json
std::string resultPath(const std::string& out, const std::string& student);

/// Both pages and then results.json, which says that all three are there. Makes the folders. Throws std::runtime_error.
void writeReports(const std::string& out, const SubmissionResult& result,
                  HiddenTests hidden = HiddenTests::afterPublished);

/// Those pages for the instructor that do not exist, without pictures: results that were read back have none.
void writeMissingInstructorPages(const std::string& out, std::span<const SubmissionResult> results);

/// gradebook.csv, junit.xml and class.html, in the order of the results; the page links to those pages that exist.
void writeClass(const std::string& out, std::span<const SubmissionResult> results);

} // namespace rt::grade
