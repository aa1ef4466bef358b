#include "lessons/programs/exercise_main.h"

#include <fmt/format.h>

#include "common/program/lesson_entry.h"
#include "lessons/programs/program_main.h"

namespace rt
{

int exerciseMain(const LessonEntry& exercise, const LectureFormulas& formulas, int argc, char** argv)
{
    return programMain(exercise, fmt::format("exercise{:02}", exercise.number), "Exercise", formulas, argc, argv);
}

} // namespace rt
