#include "common/program/lesson_entry.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/facts.h"

#include "trace.h"

namespace rt::lesson05
{

namespace
{
struct Lesson
{
    static constexpr int number = 5;
    template <class Real, class Recorder>
    using Tracer = lesson05::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{lessonFacts(5), renderLesson<Lesson>, inspectLesson<Lesson>};

} // namespace rt::lesson05
