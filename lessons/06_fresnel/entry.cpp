#include "common/program/lesson_entry.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/facts.h"

#include "trace.h"

namespace rt::lesson06
{

namespace
{
struct Lesson
{
    static constexpr int number = 6;
    template <class Real, class Recorder>
    using Tracer = lesson06::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{lessonFacts(6), renderLesson<Lesson>, inspectLesson<Lesson>};

} // namespace rt::lesson06
