// The program of an exercise.
#pragma once

#include "lessons/program.h"

namespace rt
{

/// Like lessonMain, without any lesson's code; --real does not apply, exercises run in double.
int exerciseMain(const LessonEntry& exercise, const LectureFormulas& formulas, int argc, char** argv);

} // namespace rt
