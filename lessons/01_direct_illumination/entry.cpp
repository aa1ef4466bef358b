#include "common/program/lesson_entry.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/facts.h"

#include "trace.h"

namespace rt::lesson01
{

namespace
{
struct Lesson
{
    static constexpr int number = 1;
    template <class Real, class Recorder>
    using Tracer = lesson01::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{lessonFacts(1), renderLesson<Lesson>, inspectLesson<Lesson>};

} // namespace rt::lesson01
