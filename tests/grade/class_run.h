// Grading a class: every submission of a folder, several at a time, resumable.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "tests/grade/grade_one.h"
#include "tests/grade/report/results_json.h"

namespace rt::grade
{

/// Which part of the class: submissions are sorted by name, and part i of n takes those whose place is i - 1 modulo n.
struct Shard
{
    int part = 1, of = 1;
};

struct ClassSetting
{
    Setting setting;
    std::string out; ///< folder of the results
    int jobs = 1;
    bool resume = false; ///< results whose key has not changed are kept
    Shard shard;
    HiddenTests hidden = HiddenTests::afterPublished;
};

/// One more submission is done.
struct ClassProgress
{
    std::size_t done = 0, of = 0;
    const SubmissionResult* result = nullptr;
    bool kept = false; ///< it was there already
};

struct ClassRun
{
    std::size_t of = 0;                    ///< submissions in this part of the class
    std::vector<SubmissionResult> results; ///< in the order of the submissions; those that were interrupted are missing
    int graded = 0, kept = 0;
    bool interrupted = false, graderErrors = false;
};

/// How many of them are in the part.
std::size_t countOf(const std::vector<Submission>& all, const Shard& shard);

/// Grades the submissions and writes the reports of each (report/files.h). A submission that makes the grader itself fail becomes State::graderError and stops nobody.
/// Calls `report` from any thread, but one at a time. When `stop` becomes true the submissions in work are given up:
/// nothing of them is written. Throws std::runtime_error with one sentence if nothing can be graded at all.
ClassRun gradeClass(const std::vector<Submission>& submissions, const ClassSetting& setting,
                    const std::atomic<bool>& stop, const std::function<void(const ClassProgress&)>& report);

} // namespace rt::grade
