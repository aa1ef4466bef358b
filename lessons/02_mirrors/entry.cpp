#include "common/program/lesson_entry.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/facts.h"

#include "trace.h"

namespace rt::lesson02
{

namespace
{
struct Lesson
{
    static constexpr int number = 2;
    template <class Real, class Recorder>
    using Tracer = lesson02::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{lessonFacts(2), renderLesson<Lesson>, inspectLesson<Lesson>};

} // namespace rt::lesson02
