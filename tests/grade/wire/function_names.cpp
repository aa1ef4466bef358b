// Which functions the exercise of a lesson has. The lessons themselves, which know it too (reference.cpp), are neither in `learn`
// nor in a hand-out.
#include "tests/grade/candidate.h"

namespace rt::grade
{

namespace
{

/// There, and never called: a remote candidate replaces it.
template <class R, class... Args>
void mark(std::function<R(Args...)>& function)
{
    function = [](Args...) -> R { throw std::logic_error("`learn` has no lessons"); };
}

} // namespace

Candidate reference(int lesson)
{
    Candidate candidate;
    auto& t = candidate.tracer;
    auto& g = candidate.geometry;
    if (lesson == 0)
    {
        mark(g.slopeIntercept), mark(g.yAt), mark(g.implicitForm), mark(g.normals2), mark(g.distanceToOrigin);
        mark(g.withUnitNormal), mark(g.segmentLength), mark(g.parametricForm), mark(g.normals3), mark(g.unitNormal);
        return candidate;
    }
    mark(t.color), mark(t.tree), mark(t.picture), mark(t.toSphere), mark(t.toPlane), mark(t.latLong);
    if (lesson >= 2) mark(t.reflect);
    if (lesson >= 5) mark(t.refract), mark(t.cosSquared2);
    if (lesson >= 6) mark(t.fresnel), mark(t.schlick);
    if (lesson >= 8) mark(t.phong);
    return candidate;
}

} // namespace rt::grade
