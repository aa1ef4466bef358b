// The shapes and where a ray meets them. No epsilon anywhere: DESIGN.md, "Numerics", says why none is needed.
#pragma once

#include <optional>

#include "common/base/ray.h"

namespace rt
{

template <std::floating_point Real>
struct Sphere
{
    Vec3<Real> C{0, 0, 0};
    Real r = 1; ///< > 0
    int material = 0;
};

/// An infinite plane, with an optional checker of two materials.
template <std::floating_point Real>
struct Plane
{
    Vec3<Real> P{0, 0, 0}; ///< any point of the plane
    Vec3<Real> N{0, 1, 0}; ///< unit length
    int material = 0;
    int checkerMaterial = -1; ///< of the odd cells; -1: no checker
    Real checkerSize = 1;     ///< side of a cell, > 0
    Vec3<Real> U{1, 0, 0};    ///< the checker's axes, unit vectors in the plane
    Vec3<Real> V{0, 0, 1};

    /// The material at point I of the plane: even cells floor(u / size) + floor(v / size) have the first one.
    int materialAt(const Vec3<Real>& I) const
    {
        if (checkerMaterial < 0) return material;
        const Real cell = std::floor(dot(I, U) / checkerSize) + std::floor(dot(I, V) / checkerSize);
        const Real half = cell / 2; // exact; and no number if the cell is none
        return half - std::floor(half) == 0 ? material : checkerMaterial;
    }
};

template <std::floating_point Real>
struct Triangle
{
    Vec3<Real> a{0, 0, 0}, b{0, 0, 0}, c{0, 0, 0};
    Vec3<Real> N{0, 0, 0}; ///< unit(cross(b - a, c - a))
    int material = 0;
};

/// Where rays meet shapes: the distances t > 0 along a ray, empty on a miss. Exercise 01 replaces the first two.
template <std::floating_point Real>
struct Shapes
{
    using vec3 = Vec3<Real>;
    using Ray = rt::Ray<Real>;
    using Sphere = rt::Sphere<Real>;
    using Plane = rt::Plane<Real>;
    using Triangle = rt::Triangle<Real>;

    /// Where does the ray meet the sphere? The smallest t > 0 with |O + tD - C| = r, or nothing. D has length 1.
    static std::optional<Real> intersectSphere(const Ray& ray, const Sphere& sphere)
    {
        // SOLUTION 01-sphere
        // Haines et al., "Precision Improvements for Ray/Sphere Intersection" (Ray Tracing Gems, ch. 7): the discriminant
        // from the part of O - C at right angles to D, and the second root from the first, so that nothing cancels.
        // float computes this one function in double: that is what keeps a planet's horizon smooth.
        using Wide = decltype(Real() + double());
        const Vec3<Wide> D(ray.D);
        const Vec3<Wide> oc = Vec3<Wide>(ray.O) - Vec3<Wide>(sphere.C);
        const Wide r = sphere.r;
        const Wide b = dot(oc, D);
        const Vec3<Wide> l = oc - b * D;
        const Wide discriminant = r * r - dot(l, l);
        if (!(discriminant >= 0)) return std::nullopt;
        const Wide c = dot(oc, oc) - r * r;
        const Wide q = -(b + std::copysign(std::sqrt(discriminant), b));
        const Real t1 = Real(std::min(q, c / q)), t2 = Real(std::max(q, c / q));
        if (t1 > 0) return t1;
        if (t2 > 0) return t2;
        return std::nullopt;
        // END
    }

    /// Where does the ray meet the plane? The t > 0 with (O + tD - P).N = 0, or nothing: also for a ray along the plane.
    static std::optional<Real> intersectPlane(const Ray& ray, const Plane& plane)
    {
        // SOLUTION 01-plane
        const Real t = dot(plane.P - ray.O, plane.N) / dot(ray.D, plane.N);
        if (t > 0 && t < infinity<Real>) return t;
        return std::nullopt;
        // END
    }

    /// A ray that starts on the sphere meets it again only at the other end of the chord, if it goes inwards:
    /// of the roots 0 and -2 D.(O - C), the first is known and dropped by name, not by size.
    static std::optional<Real> leaveSphere(const Ray& ray, const Sphere& sphere)
    {
        const Real t = -2 * dot(ray.D, ray.O - sphere.C);
        if (t > 0) return t;
        return std::nullopt;
    }

    /// Woop, Benthin, Wald: "Watertight Ray/Triangle Intersection" (JCGT 2013). Both sides are visible; a ray through a
    /// shared edge never slips between its two triangles.
    static std::optional<Real> intersectTriangle(const Ray& ray, const Triangle& triangle)
    {
        const Crossing line(ray, triangle);
        if (!line.isInside()) return std::nullopt;
        const Real t = line.distance();
        if (t > 0 && t < infinity<Real> && isNear(ray.O + t * ray.D, ray.O, triangle)) return t;
        return std::nullopt;
    }

    /// a b - c d where the products nearly agree, of the right sign: each is a rounded product and what was rounded off it
    /// (Dekker, "A floating-point technique for extending the available precision", 1971; no instruction for it is needed).
    [[gnu::noinline]] static Real exactDifference(Real a, Real b, Real c, Real d)
    {
        const auto error = [](Real x, Real y, Real product) {
            constexpr Real splitter = Real((std::int64_t(1) << (std::numeric_limits<Real>::digits + 1) / 2) + 1);
            const auto upper = [](Real v) {
                const Real far = splitter * v;
                return far - (far - v);
            };
            const Real x1 = upper(x), x2 = x - x1, y1 = upper(y), y2 = y - y1;
            return ((x1 * y1 - product) + x1 * y2 + x2 * y1) + x2 * y2;
        };
        const Real first = a * b, second = c * d;
        return (first - second) + (error(a, b, first) - error(c, d, second));
    }

    /// Where the line of a ray, before its origin too, crosses the plane of a triangle.
    struct Crossing
    {
        using Wide = rt::Wide<Real>;
        Wide u, v, w; ///< on which side of the edges bc, ca and ab; within the triangle none differs
        Real az, bz, cz, shearZ;

        Crossing(const Ray& ray, const Triangle& triangle)
        {
            const vec3 size = abs(ray.D);
            const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
            int x = (z + 1) % 3, y = (x + 1) % 3;
            if (ray.D[z] < 0) std::swap(x, y);
            const Real shearX = ray.D[x] / ray.D[z], shearY = ray.D[y] / ray.D[z];
            shearZ = 1 / ray.D[z];

            const vec3 A = triangle.a - ray.O, B = triangle.b - ray.O, C = triangle.c - ray.O;
            const Real ax = A[x] - shearX * A[z], ay = A[y] - shearY * A[z];
            const Real bx = B[x] - shearX * B[z], by = B[y] - shearY * B[z];
            const Real cx = C[x] - shearX * C[z], cy = C[y] - shearY * C[z];

            // float decides edges in double, as the paper asks; there the products are exact. Other types make their
            // products exact where rounding might turn the sign: else a ray at a corner may be beside all that meet there.
            const auto edge = [](Real px, Real py, Real qx, Real qy) {
                const Wide first = Wide(px) * Wide(qy), second = Wide(py) * Wide(qx), difference = first - second;
                if constexpr (std::is_same_v<Real, Wide>)
                    if (!(std::abs(difference) >
                          std::numeric_limits<Real>::epsilon() * (std::abs(first) + std::abs(second)))) [[unlikely]]
                        return exactDifference(px, qy, py, qx);
                return difference;
            };
            u = edge(cx, cy, bx, by);
            v = edge(ax, ay, cx, cy);
            w = edge(bx, by, ax, ay);
            az = A[z];
            bz = B[z];
            cz = C[z];
        }

        bool isInside() const { return !((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) && u + v + w != 0; }

        /// Along the ray; negative behind its origin.
        Real distance() const
        {
            return Real((u * (shearZ * az) + v * (shearZ * bz) + w * (shearZ * cz)) / (u + v + w));
        }
    };

    /// How far a triangle's hit point may be from its box, as a share of the sum of the coordinates that it comes from. In
    /// float edges are exact and only coordinates are rounded; else a ray that all but lies in the plane gets inexact ones.
    static constexpr Real triangleError =
        std::numeric_limits<Real>::epsilon() *
        (std::is_same_v<Real, float> ? 32 : std::int64_t(1) << std::numeric_limits<Real>::digits / 2);

    /// For a ray in the triangle's plane u, v and w are nothing but rounding, and may agree however far it passes by.
    static bool isNear(const vec3& P, const vec3& O, const Triangle& triangle)
    {
        const auto& [a, b, c, N, material] = triangle;
        const vec3 sum = abs(O) + abs(a) + abs(b) + abs(c);
        const Real error = triangleError * (sum.x + sum.y + sum.z);
        const vec3 low = min(min(a, b), c) - error, high = max(max(a, b), c) + error;
        return P.x >= low.x && P.y >= low.y && P.z >= low.z && P.x <= high.x && P.y <= high.y && P.z <= high.z;
    }
};

} // namespace rt
