// The entry of an exercise program: the same options as the lesson's.
#pragma once

#include "common/lesson_entry.h"

namespace rt
{

/// An entry like the lesson's, with the student's tracer in it.
template <int number, class Tracer>
LessonEntry exerciseEntry(const LessonEntry& lesson, const char* source)
{
    LessonEntry entry = lesson;
    entry.source = source;
    entry.render = renderExercise<Tracer>;
    entry.inspect = inspectExercise<number, Tracer>;
    return entry;
}

} // namespace rt
