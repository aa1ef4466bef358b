// The program of a lesson: scene in; picture, ray tree or explanation out.
#pragma once

#include "lessons/program.h"

namespace rt
{

/// Runs the command line of one lesson and returns its exit code: 0 done, 2 bad input or usage, 130 interrupted.
int lessonMain(const LessonEntry& lesson, int argc, char** argv, const std::vector<ExtraOption>& extra = {});

/// The same with the smallest lesson that models all that the scene requires; says which one on standard error.
int renderMain(int argc, char** argv);

} // namespace rt
