// Results that were made apart - by Gradescope, a matrix of jobs, an array of Slurm, shards - as one class.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/grade/result.h"

namespace rt::grade
{

/// All results.json below the given folders, and the given files, sorted by path, each once. Throws std::runtime_error if
/// a path does not exist or a folder has none.
std::vector<std::string> findResults(const std::vector<std::string>& paths);

/// The results of those files, by student. Throws std::runtime_error with one sentence that names two files if they are
/// of two lessons, of two versions of grader, lesson data or secret, or differ though they are of the same student
/// (the times may differ).
std::vector<SubmissionResult> readClass(std::span<const std::string> files);

} // namespace rt::grade
