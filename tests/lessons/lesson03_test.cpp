#include "lessons/03_partial_reflection/trace.h"
#include "solved03.h"
#include "tests/cases/cases.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    static constexpr int number = 3;
    template <class Real, class Recorder>
    using Tracer = lesson03::Tracer<Real, Recorder>;
};

[[maybe_unused]] const bool registered = registerLesson<Lesson, solved03::Tracer>("03");

} // namespace

} // namespace rt::cases
