// Which file of a submission is graded, and what is refused. DESIGN.md, "The package".
#pragma once

#include <string>
#include <vector>

#include "tests/grade/result.h"

namespace rt::grade
{

struct Submission
{
    std::string student; ///< the entry's name without its ending: foreign text
    std::string path;    ///< a folder, an archive or a file
};

/// Each entry of the directory is one student's, by name; what cannot be opened too, so that nobody vanishes. Only what systems
/// leave (.DS_Store, .git) is passed over. Throws std::runtime_error if the directory cannot be read or two entries that can be
/// opened (a folder, .zip, .tar, .tar.gz, .tgz, .h or .h.txt) name the same student.
std::vector<Submission> listSubmissions(const std::string& directory);

/// The student that an entry belongs to: its last name, of files without the ending.
std::string studentOf(const std::string& path);

struct Taken
{
    State state = State::missing;     ///< graded: `text` is to be graded; else missing or refused
    std::string reason;               ///< one sentence without a full stop, if not; foreign text may stand in it
    std::string text;                 ///< UTF-8 with LF
    std::vector<std::string> remarks; ///< foreign text may stand in them
};

/// The lesson's exercise.h: `exercise.h` that says it is the lesson's, `exerciseNN.h`, `NN_name/exercise.h` or
/// `lessons/NN_name/exercise.h`, or any of them one folder deeper; without those, what downloads make of its name, at any depth;
/// without that, a header that says it is the lesson's. A folder may hold it in an archive. Follows no links, starts nothing,
/// writes nothing; reads at most 64 MiB a search. Never throws for what a student may have handed in.
Taken takeExercise(const Submission& submission, int lesson);

} // namespace rt::grade
