// The lessons in double, as candidates. Never linked into a student's program.
#include <fmt/format.h>

#include "lessons/00_geometry/geometry.h"
#include "lessons/01_direct_illumination/trace.h"
#include "lessons/02_mirrors/trace.h"
#include "lessons/03_partial_reflection/trace.h"
#include "lessons/04_hdr_sky/trace.h"
#include "lessons/05_refraction/trace.h"
#include "lessons/06_fresnel/trace.h"
#include "lessons/07_recursion_caps/trace.h"
#include "lessons/08_phong/trace.h"
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
template <class R, class Rec>
using Tracer1 = lesson01::Tracer<R, Rec>;
template <class R, class Rec>
using Tracer2 = lesson02::Tracer<R, Rec>;
template <class R, class Rec>
using Tracer3 = lesson03::Tracer<R, Rec>;
template <class R, class Rec>
using Tracer4 = lesson04::Tracer<R, Rec>;
template <class R, class Rec>
using Tracer5 = lesson05::Tracer<R, Rec>;
template <class R, class Rec>
using Tracer6 = lesson06::Tracer<R, Rec>;
template <class R, class Rec>
using Tracer7 = lesson07::Tracer<R, Rec>;
template <class R, class Rec>
using Tracer8 = lesson08::Tracer<R, Rec>;

} // namespace

Candidate reference(int lesson)
{
    using Make = cases::Subject (*)();
    static constexpr std::pair<int, Make> tracers[] = {
        {1, inDouble<Tracer1>}, {2, inDouble<Tracer2>}, {3, inDouble<Tracer3>}, {4, inDouble<Tracer4>},
        {5, inDouble<Tracer5>}, {6, inDouble<Tracer6>}, {7, inDouble<Tracer7>}, {8, inDouble<Tracer8>}};
    Candidate candidate;
    if (lesson == 0)
    {
        candidate.geometry = cases::geometrySubject<lesson00::Geometry<double>>();
        return candidate;
    }
    for (const auto& [number, make] : tracers)
        if (number == lesson)
        {
            candidate.tracer = make();
            return candidate;
        }
    throw std::invalid_argument(fmt::format("lesson {} has no exercises", lesson));
}

} // namespace rt::grade
