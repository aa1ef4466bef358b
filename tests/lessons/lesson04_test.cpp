#include "lessons/04_hdr_sky/trace.h"
#include "solved04.h"
#include "tests/cases/cases.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    static constexpr int number = 4;
    template <class Real, class Recorder>
    using Tracer = lesson04::Tracer<Real, Recorder>;
};

[[maybe_unused]] const bool registered = registerLesson<Lesson, solved04::Tracer>("04");

} // namespace

} // namespace rt::cases
