// The lessons in double, as candidates. Never linked into a student's program.
#include <fmt/format.h>

#include "lessons/00_geometry/geometry.h"
#include "lessons/list.h"
#include "lessons/traces.h"
#include "tests/grade/candidate.h"

namespace rt::grade
{

namespace
{

template <template <class, class> class Tracer>
cases::Subject inDouble()
{
    return cases::makeSubject<double, Tracer<double, NoRecorder>, Tracer<double, TreeRecorder<double>>>();
}

// GCC 12 does not take a constrained template for an unconstrained parameter, hence the aliases.
#define RAYTREE_ALIAS(number, NN)                                                                                      \
    template <class R, class Rec>                                                                                      \
    using Tracer##NN = lesson##NN::Tracer<R, Rec>;
RAYTREE_FOR_EACH_LESSON(RAYTREE_ALIAS)
#undef RAYTREE_ALIAS

} // namespace

Candidate reference(int lesson)
{
    Candidate candidate;
    if (lesson == 0)
    {
        candidate.geometry = cases::geometrySubject<lesson00::Geometry<double>>();
        return candidate;
    }
#define RAYTREE_CASE(number, NN)                                                                                       \
    if (lesson == number) candidate.tracer = inDouble<Tracer##NN>();
    RAYTREE_FOR_EACH_LESSON(RAYTREE_CASE)
#undef RAYTREE_CASE
    if (candidate.tracer.color) return candidate;
    throw std::invalid_argument(fmt::format("lesson {} has no exercises", lesson));
}

} // namespace rt::grade
