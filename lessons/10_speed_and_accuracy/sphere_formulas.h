// Where a ray meets a sphere, three ways. The first two are exhibits: they lose the digits that decide.
#pragma once

#include <array>
#include <optional>

#include "common/base/shapes.h"

namespace rt::lesson10
{

template <std::floating_point Real>
using Roots = std::optional<std::array<Real, 2>>; // ascending; empty on a miss

// Exhibit: the schoolbook's (-b ± sqrt(b² - 4ac)) / 2a. Far away b² and 4ac agree in nearly all digits, and what is left
// when they are subtracted is rounding; where b and the square root nearly cancel, so does the nearer root.
struct Naive
{
    template <std::floating_point Real>
    static Roots<Real> roots(const Ray<Real>& ray, const Sphere<Real>& sphere)
    {
        const Vec3<Real> oc = ray.O - sphere.C;
        const Real a = dot(ray.D, ray.D), b = 2 * dot(ray.D, oc), c = dot(oc, oc) - sphere.r * sphere.r;
        const Real discriminant = b * b - 4 * a * c;
        if (!(discriminant >= 0)) return std::nullopt;
        const Real root = std::sqrt(discriminant);
        return {{(-b - root) / (2 * a), (-b + root) / (2 * a)}};
    }
};

// Exhibit: q = -(b + sign(b) sqrt(...)) mends the roots (Press et al., Numerical Recipes, 5.6), not the discriminant.
struct QForm
{
    template <std::floating_point Real>
    static Roots<Real> roots(const Ray<Real>& ray, const Sphere<Real>& sphere)
    {
        const Vec3<Real> oc = ray.O - sphere.C;
        const Real b = dot(oc, ray.D), c = dot(oc, oc) - sphere.r * sphere.r;
        const Real discriminant = b * b - c;
        if (!(discriminant >= 0)) return std::nullopt;
        const Real q = -(b + std::copysign(std::sqrt(discriminant), b));
        return {{std::min(q, c / q), std::max(q, c / q)}};
    }
};

// The cure, as in common/base/shapes.h: the discriminant from the part of O - C at right angles to D. `Wide` is the type that it
// computes in, if that is wider than the ray's own: double is what the course does for float.
template <std::floating_point Wide>
struct Haines
{
    template <std::floating_point Real>
    static Roots<Real> roots(const Ray<Real>& ray, const Sphere<Real>& sphere)
    {
        using Inner = decltype(Real() + Wide());
        const Vec3<Inner> D(ray.D);
        const Vec3<Inner> oc = Vec3<Inner>(ray.O) - Vec3<Inner>(sphere.C);
        const Inner r = sphere.r, b = dot(oc, D);
        const Vec3<Inner> l = oc - b * D;
        const Inner discriminant = r * r - dot(l, l);
        if (!(discriminant >= 0)) return std::nullopt;
        const Inner c = dot(oc, oc) - r * r, q = -(b + std::copysign(std::sqrt(discriminant), b));
        return {{Real(std::min(q, c / q)), Real(std::max(q, c / q))}};
    }
};

} // namespace rt::lesson10
