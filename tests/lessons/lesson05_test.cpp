#include "lessons/05_refraction/trace.h"
#include "solved05.h"
#include "tests/cases/cases.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    static constexpr int number = 5;
    template <class Real, class Recorder>
    using Tracer = lesson05::Tracer<Real, Recorder>;
};

[[maybe_unused]] const bool registered = registerLesson<Lesson, solved05::Tracer>("05");

} // namespace

} // namespace rt::cases
