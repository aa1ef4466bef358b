// A scene with the choices of this lesson: what lesson 10's Tracer calls `scene`.
#pragma once

#include "common/scene/scene.h"

#include "leaving.h"
#include "sphere_formulas.h"

namespace rt::lesson10
{

/// What Scene::intersect asks for: the sphere by one of the formulas, the plane as in the course, and hits beyond tMin only.
/// Triangles have one formula, and tMin does not apply to them.
template <std::floating_point Real, class Formula>
struct Meets
{
    Real tMin = 0;

    std::optional<Real> intersectSphere(const Ray<Real>& ray, const Sphere<Real>& sphere) const
    {
        const auto roots = Formula::roots(ray, sphere);
        if (!roots) return std::nullopt;
        const auto [t1, t2] = *roots;
        if (t1 > tMin) return t1;
        if (t2 > tMin) return t2;
        return std::nullopt;
    }

    std::optional<Real> intersectPlane(const Ray<Real>& ray, const Plane<Real>& plane) const
    {
        const auto t = Shapes<Real>::intersectPlane(ray, plane);
        return t && *t > tMin ? t : std::nullopt;
    }
};

template <std::floating_point RealType, class Formula, class Leaving>
struct World : Scene<RealType>
{
    using Real = RealType;

    bool wrongAngle; ///< Schlick's approximation with the angle of incidence, whichever medium the ray comes from

    World(const SceneDescription& description, bool schlickWithWrongAngle)
        : Scene<Real>(description), wrongAngle(schlickWithWrongAngle)
    {
    }

    auto intersect(const Ray<Real>& ray) const
    {
        return Scene<Real>::intersect(ray, meets());
    }

    bool occluded(const Point<Real>& I, const Vec3<Real>& L, Real distance) const
    {
        return Scene<Real>::occluded(I, L, distance, meets());
    }

    /// The start of a ray that leaves I on the side of N.
    decltype(auto) leave(const Point<Real>& I, const Vec3<Real>& N) const
    {
        return Leaving::leave(I, N);
    }

    /// Exhibit: from glass into air the transmitted angle is the larger one, and it is the one that counts.
    static Real schlickWithIncidentAngle(Real cos1, Real n1, Real n2)
    {
        if (n1 == n2) return 0;
        const Real R0 = (n1 - n2) / (n1 + n2) * (n1 - n2) / (n1 + n2), x = 1 - cos1;
        return R0 + (1 - R0) * x * x * x * x * x;
    }

private:
    static Meets<Real, Formula> meets()
    {
        return {Leaving::template tMin<Real>};
    }
};

} // namespace rt::lesson10
