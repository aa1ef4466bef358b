#include "lessons/08_phong/trace.h"
#include "solved08.h"
#include "tests/cases/cases.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    static constexpr int number = 8;
    template <class Real, class Recorder>
    using Tracer = lesson08::Tracer<Real, Recorder>;
};

[[maybe_unused]] const bool registered = registerLesson<Lesson, solved08::Tracer>("08");

} // namespace

} // namespace rt::cases
