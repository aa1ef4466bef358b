// How the next ray leaves the surface that it starts on, five ways. All but the last are exhibits.
#pragma once

#include "common/base/ray.h"

namespace rt::lesson10
{

// Exhibit: nothing is done. The point lies a little beside the surface, and the ray may meet the surface again at once.
struct AnyPositive
{
    template <std::floating_point Real>
    static constexpr Real tMin = 0;

    template <std::floating_point Real>
    static Point<Real> leave(Point<Real> I, const Vec3<Real>&)
    {
        I.on = noPrimitive;
        return I;
    }
};

// Exhibit: hits nearer than a fixed length do not count. It is too long in small scenes, and too short in large ones.
struct FixedTMin : AnyPositive
{
    template <std::floating_point Real>
    static constexpr Real tMin = Real(1e-4);
};

// Exhibit: the start is moved by a fixed length along the normal, N on the side where the ray goes.
struct NormalOffset : AnyPositive
{
    template <std::floating_point Real>
    static Point<Real> leave(Point<Real> I, const Vec3<Real>& N)
    {
        I += Real(1e-4) * N;
        I.on = noPrimitive;
        return I;
    }
};

// Exhibit: the same by a length that grows with the coordinates. Fine at the origin, a leap far from it.
struct RelativeOffset : AnyPositive
{
    template <std::floating_point Real>
    static Point<Real> leave(Point<Real> I, const Vec3<Real>& N)
    {
        const Vec3<Real> size = abs(Vec3<Real>(I));
        I += Real(1e-4) * std::max({size.x, size.y, size.z}) * N;
        I.on = noPrimitive;
        return I;
    }
};

// The cure, and the course's way: the ray carries the primitive that it leaves, and no length is needed.
struct Exclusion
{
    template <std::floating_point Real>
    static constexpr Real tMin = 0;

    template <std::floating_point Real>
    static const Point<Real>& leave(const Point<Real>& I, const Vec3<Real>&)
    {
        return I;
    }
};

} // namespace rt::lesson10
