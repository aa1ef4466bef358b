#include "lessons/07_recursion_caps/trace.h"
#include "solved07.h"
#include "tests/cases/cases.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    static constexpr int number = 7;
    template <class Real, class Recorder>
    using Tracer = lesson07::Tracer<Real, Recorder>;
};

[[maybe_unused]] const bool registered = registerLesson<Lesson, solved07::Tracer>("07");

} // namespace

} // namespace rt::cases
