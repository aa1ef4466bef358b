// A ray of the ray tree, and the point on a surface from which the next one starts.
#pragma once

#include <cstdint>

#include "common/base/vec.h"

namespace rt
{

/// Which object a ray leaves or hits: spheres first, then planes, then triangles, each in the order of the scene file.
using PrimitiveId = std::int32_t;
inline constexpr PrimitiveId noPrimitive = -1;

enum class RayKind
{
    camera,
    reflected,
    transmitted
};
inline constexpr RayKind reflected = RayKind::reflected;
inline constexpr RayKind transmitted = RayKind::transmitted;

/// A point that knows the primitive it lies on. Rays that start here need no epsilon: they remember what they leave.
template <std::floating_point Real>
struct Point : Vec3<Real>
{
    PrimitiveId on = noPrimitive;
    Real albedo = 1; ///< largest channel of the surface's colour
};

template <std::floating_point Real>
struct Ahead;

/// P(t) = O + t D for t > 0.
template <std::floating_point Real>
struct Ray
{
    Vec3<Real> O{0, 0, 0};
    Vec3<Real> D{0, 0, 0}; ///< unit length
    RayKind kind = RayKind::camera;
    int depth = 0;                  ///< the camera ray has depth 0
    Real weight = 1;                ///< its share of what its parent returns, in [0, 1]
    Real energy = 1;                ///< at least the largest channel of the throughput from here to the pixel
    PrimitiveId from = noPrimitive; ///< the primitive that O lies on

    const Ahead<Real>* ahead = nullptr; ///< look_ahead.h: what was found for it already

    /// The next ray of the tree: starts at I, one level deeper, and brings `nextWeight` of its parent's colour, tinted by
    /// the colour of the surface. `direction` need not have unit length.
    Ray spawn(RayKind nextKind, const Point<Real>& I, const Vec3<Real>& direction, Real nextWeight = 1) const
    {
        return {I, unit(direction), nextKind, depth + 1, nextWeight, energy * nextWeight * I.albedo, I.on};
    }
};

} // namespace rt
