#include "lessons/01_direct_illumination/trace.h"
#include "solved01.h"
#include "tests/cases/cases.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    static constexpr int number = 1;
    template <class Real, class Recorder>
    using Tracer = lesson01::Tracer<Real, Recorder>;
};

[[maybe_unused]] const bool registered = registerLesson<Lesson, solved01::Tracer>("01");

} // namespace

} // namespace rt::cases
