// What `learn` knows: the exercises, how far the student is, and what came of the file when it was last run.
#pragma once

#include <string>
#include <vector>

#include "tests/learn/attempt.h"
#include "tests/learn/progress.h"

namespace rt::grade
{

/// What came of one exercise file.
struct LessonRun
{
    bool compiled = false;
    std::string reason;                      ///< why not, in one sentence
    std::vector<std::string> errors;         ///< "exercise.h:48:9: error: ..."
    std::vector<std::string> remarks;        ///< "glm::reflect is used"
    std::map<std::string, Attempt> attempts; ///< by the exercise's id
    std::string text;                        ///< what the student's code printed
};

struct Session
{
    std::vector<Exercise> exercises; ///< of all lessons that are here, in order
    Progress progress;
    std::string stateFile;
    std::string file; ///< stands in for the exercise.h of its lesson; empty: the project's own

    const Exercise& current() const;
    /// Null if there is none of that id.
    const Exercise* find(const std::string& id) const;
    /// The one after or before it in the manifest; null at the end.
    const Exercise* neighbour(const std::string& id, int step) const;
    /// The first that is not right: after `id` if there is one, else from the start; null if all are right.
    const Exercise* nextToDo(const std::string& id) const;
    std::vector<Exercise> lesson(int number) const;
    std::string fileOf(int lesson) const;
};

/// The project's exercises and progress; `notice`: see loadProgress. Throws std::runtime_error.
Session openSession(const std::string& stateFile, std::string& notice);

/// Compiles the lesson's file and runs its cases, those of the exercise `first` before the others. Throws std::runtime_error if
/// that is not the student's fault, as without a compiler.
LessonRun runLesson(const Session& session, int lesson, const std::string& first);

/// Notes in the progress what came of it, and saves it.
void note(Session& session, const LessonRun& run);

/// The line of todo("id") in a file's text, from 1; 0: it is not there any more.
int todoLine(const std::string& text, const std::string& id);

/// Is this a hand-out, without the viewer and the lessons?
bool isHandout();

/// A file of the project as a student would type it.
std::string shortened(const std::string& path);

} // namespace rt::grade
