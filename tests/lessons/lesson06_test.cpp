#include "lessons/06_fresnel/trace.h"
#include "solved06.h"
#include "tests/cases/cases.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    static constexpr int number = 6;
    template <class Real, class Recorder>
    using Tracer = lesson06::Tracer<Real, Recorder>;
};

[[maybe_unused]] const bool registered = registerLesson<Lesson, solved06::Tracer>("06");

} // namespace

} // namespace rt::cases
