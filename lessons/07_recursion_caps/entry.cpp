#include "common/program/lesson_entry.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/facts.h"

#include "trace.h"

namespace rt::lesson07
{

namespace
{
struct Lesson
{
    static constexpr int number = 7;
    template <class Real, class Recorder>
    using Tracer = lesson07::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{lessonFacts(7), renderLesson<Lesson>, inspectLesson<Lesson>};

} // namespace rt::lesson07
