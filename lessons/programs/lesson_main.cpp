#include "lessons/programs/lesson_main.h"

#include <fmt/format.h>

#include "common/program/lesson_entry.h"
#include "lessons/programs/formulas.h"

namespace rt
{

int lessonMain(const LessonEntry& lesson, int argc, char** argv, const std::vector<ExtraOption>& extra)
{
    return programMain(lesson, fmt::format("lesson{:02}", lesson.number), "Lesson", lectureFormulas(), argc, argv,
                       extra);
}

} // namespace rt
