// The lessons in double. (Until the one beside the wire's candidates is merged.)
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
Candidate of()
{
    return {.tracer = cases::makeSubject<double, Tracer<double, NoRecorder>, Tracer<double, TreeRecorder<double>>>()};
}

} // namespace

Candidate reference(int lesson)
{
    switch (lesson)
    {
    case 0:
        return {.geometry = cases::geometrySubject<lesson00::Geometry<double>>()};
    case 1:
        return of<lesson01::Tracer>();
    case 2:
        return of<lesson02::Tracer>();
    case 3:
        return of<lesson03::Tracer>();
    case 4:
        return of<lesson04::Tracer>();
    case 5:
        return of<lesson05::Tracer>();
    case 6:
        return of<lesson06::Tracer>();
    case 7:
        return of<lesson07::Tracer>();
    default:
        return of<lesson08::Tracer>();
    }
}

} // namespace rt::grade
