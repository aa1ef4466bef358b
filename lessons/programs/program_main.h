// The program of one lesson or exercise. Without CLI11's header, which takes longer to compile than a lesson.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rt
{

struct LessonEntry;
struct LectureFormulas;

/// An option that only one lesson has: `run` gets its value and replaces everything else that the program does.
struct ExtraOption
{
    const char* name;
    const char* type;
    const char* help;
    std::function<void(const std::string&)> run;
};

/// The command line of a lesson or an exercise; `what` is "Lesson" or "Exercise".
int programMain(const LessonEntry& lesson, const std::string& program, const char* what,
                const LectureFormulas& formulas, int argc, char** argv, const std::vector<ExtraOption>& extra = {});

} // namespace rt
