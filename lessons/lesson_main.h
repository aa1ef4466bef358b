// The program of a lesson: scene in; picture, ray tree or explanation out.
#pragma once

#include "common/lesson_entry.h"

namespace rt
{

/// An option that only one lesson has: `run` gets its value and replaces everything else that the program does.
struct ExtraOption
{
    const char* name;
    const char* type;
    const char* help;
    std::function<void(const std::string&)> run;
};

/// Runs the command line of one lesson and returns its exit code: 0 done, 2 bad input or usage, 130 interrupted.
int lessonMain(const LessonEntry& lesson, int argc, char** argv, const std::vector<ExtraOption>& extra = {});

/// The same for an exercise; --real does not apply, exercises run in double.
int exerciseMain(const LessonEntry& exercise, int argc, char** argv);

/// The same with the smallest lesson that models all that the scene requires; says which one on standard error.
int renderMain(int argc, char** argv);

} // namespace rt
