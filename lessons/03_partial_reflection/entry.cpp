#include "common/program/lesson_entry.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/facts.h"

#include "trace.h"

namespace rt::lesson03
{

namespace
{
struct Lesson
{
    static constexpr int number = 3;
    template <class Real, class Recorder>
    using Tracer = lesson03::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{lessonFacts(3), renderLesson<Lesson>, inspectLesson<Lesson>};

} // namespace rt::lesson03
