// The program of a lesson: scene in; picture, ray tree or explanation out.
#pragma once

#include "lessons/programs/program_main.h"

namespace rt
{

/// Runs the command line of one lesson and returns its exit code (ExitCode in common/program/cli.h).
int lessonMain(const LessonEntry& lesson, int argc, char** argv, const std::vector<ExtraOption>& extra = {});

} // namespace rt
