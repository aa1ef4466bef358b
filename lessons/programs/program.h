// What the programs of lessons and exercises, and `render`, have in common.
#pragma once

#include "common/program/cli.h"
#include "common/tree/explain.h"
#include "lessons/programs/facts.h"

namespace rt
{

struct LessonOptions : TraceOptions
{
    std::string out;
    std::string tree;
    bool explain = false;
    bool force = false;

    bool wantsTree() const
    {
        return hasProbe() || !tree.empty() || explain;
    }
};

void addLessonOptions(CommandLine& app, LessonOptions& options);

/// Examples for the help.
void footer(CommandLine& app, const std::string& command);

/// Prints the tree and writes the picture, as the options ask. Returns the exit code.
int run(const LessonEntry& lesson, const SceneDescription& scene, const LessonOptions& options,
        const std::string& command, const LectureFormulas& formulas);

} // namespace rt
