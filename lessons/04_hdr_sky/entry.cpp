#include "common/program/lesson_entry.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/facts.h"

#include "trace.h"

namespace rt::lesson04
{

namespace
{
struct Lesson
{
    static constexpr int number = 4;
    template <class Real, class Recorder>
    using Tracer = lesson04::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{lessonFacts(4), renderLesson<Lesson>, inspectLesson<Lesson>};

} // namespace rt::lesson04
