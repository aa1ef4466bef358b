#include "common/program/lesson_entry.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/facts.h"

#include "trace.h"

namespace rt::lesson08
{

namespace
{
struct Lesson
{
    static constexpr int number = 8;
    template <class Real, class Recorder>
    using Tracer = lesson08::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{lessonFacts(8), renderLesson<Lesson>, inspectLesson<Lesson>};

} // namespace rt::lesson08
