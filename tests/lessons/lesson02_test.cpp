#include "lessons/02_mirrors/trace.h"
#include "solved02.h"
#include "tests/cases/cases.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    static constexpr int number = 2;
    template <class Real, class Recorder>
    using Tracer = lesson02::Tracer<Real, Recorder>;
};

[[maybe_unused]] const bool registered = registerLesson<Lesson, solved02::Tracer>("02");

} // namespace

} // namespace rt::cases
