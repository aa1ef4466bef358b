// How far a student has come: a small file in the project's folder.
#pragma once

#include <map>
#include <string>

namespace rt::grade
{

enum class Standing
{
    notAttempted,
    wrong,
    right
};

struct Progress
{
    std::string current;                       ///< id of the exercise that was last worked on; empty: none yet
    std::map<std::string, Standing> exercises; ///< by id; what is missing has not been attempted

    Standing of(const std::string& id) const;
};

/// A file that is missing gives nothing done. One that cannot be read is renamed to `path`.broken, and `notice` says so in one
/// sentence; nothing done then, too.
Progress loadProgress(const std::string& path, std::string& notice);

/// Whole or not at all. Throws std::runtime_error with one sentence.
void saveProgress(const std::string& path, const Progress& progress);

} // namespace rt::grade
