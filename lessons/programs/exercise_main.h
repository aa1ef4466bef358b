// The program of an exercise.
#pragma once

namespace rt
{

struct LessonEntry;
struct LectureFormulas;

/// Like lessonMain, without any lesson's code; --real does not apply, exercises run in double.
int exerciseMain(const LessonEntry& exercise, const LectureFormulas& formulas, int argc, char** argv);

} // namespace rt
