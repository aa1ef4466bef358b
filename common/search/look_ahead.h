// What camera rays meet, found for several at once, before a lesson asks for it: a lane is a ray. The formulas of shapes.h,
// step by step the same, so with the same bits.
#pragma once

#include "common/base/hit.h"
#include "common/base/shapes.h"
#include "common/search/lanes.h"

namespace rt
{

/// Is it worth it, and possible, in this scalar type? float would have to meet spheres in double.
template <std::floating_point Real>
inline constexpr bool looksAhead = hasLanes<Real>&& std::is_same_v<Real, Wide<Real>>;

/// A ray, and what it meets. Whoever asks with another O or D, to the last bit, asks the scene anew.
template <std::floating_point Real>
struct Ahead
{
    Vec3<Real> O{0, 0, 0}, D{0, 0, 0};
    std::optional<Hit<Real>> hit{};

    bool isFor(const Ray<Real>& ray) const
    {
        return std::memcmp(&O, &ray.O, sizeof O) == 0 && std::memcmp(&D, &ray.D, sizeof D) == 0;
    }
};

template <std::floating_point Real, Instructions set>
struct LaneRays
{
    static constexpr int lanes = laneCount<Real, set>;
    using Lanes = rt::Lanes<Real, set>;
    using Ids = decltype(Lanes{} < 0); ///< integers as wide as Real

    Lanes O[3], D[3];
    Lanes nearest = Lanes{} + infinity<Real>;
    Ids id = Ids{} + noPrimitive;

    explicit LaneRays(const Ahead<Real>* rays)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            Real o[lanes], d[lanes];
            for (int k = 0; k < lanes; ++k) o[k] = rays[k].O[axis], d[k] = rays[k].D[axis];
            std::memcpy(&O[axis], o, sizeof o);
            std::memcpy(&D[axis], d, sizeof d);
        }
    }

    /// In the order of ids: of equal distances the first stays.
    template <class Shape>
    [[gnu::always_inline]] void meet(const Shape& shape, PrimitiveId its)
    {
        Lanes t;
        if (!distances(shape, t)) return;
        const Ids nearer = (t > 0) & (t < nearest);
        nearest = nearer ? t : nearest;
        id = nearer ? Ids{} + its : id;
    }

private:
    /// Sets t to where each lane meets the shape, if that is > 0; false: none does.
    [[gnu::always_inline]] bool distances(const Sphere<Real>& sphere, Lanes& t) const
    {
        // SOLUTION 01-sphere
        const Real squaredRadius = sphere.r * sphere.r;
        const Lanes x = O[0] - sphere.C.x, y = O[1] - sphere.C.y, z = O[2] - sphere.C.z;
        const Lanes b = x * D[0] + y * D[1] + z * D[2];
        const Lanes lx = x - b * D[0], ly = y - b * D[1], lz = z - b * D[2];
        const Lanes discriminant = squaredRadius - (lx * lx + ly * ly + lz * lz);
        if (!bitsOf(discriminant >= 0)) return false;
        const Lanes c = x * x + y * y + z * z - squaredRadius;
        Real roots[lanes]; // NaN where there is none: that is neither > 0 nor nearer
        std::memcpy(roots, &discriminant, sizeof roots);
        for (int k = 0; k < lanes; ++k) roots[k] = std::sqrt(roots[k]);
        Lanes root;
        std::memcpy(&root, roots, sizeof root);
        root = Ids(b) < 0 ? -root : root; // b's sign bit: that of -0, too
        const Lanes q = -(b + root), other = c / q;
        const Lanes t1 = other < q ? other : q, t2 = q < other ? other : q;
        t = t1 > 0 ? t1 : t2;
        return true;
        // END
    }

    [[gnu::always_inline]] bool distances(const Plane<Real>& plane, Lanes& t) const
    {
        // SOLUTION 01-plane
        const Vec3<Real>&P = plane.P, &N = plane.N;
        const Lanes height = (P.x - O[0]) * N.x + (P.y - O[1]) * N.y + (P.z - O[2]) * N.z;
        t = height / (D[0] * N.x + D[1] * N.y + D[2] * N.z);
        return true;
        // END
    }
};

} // namespace rt
