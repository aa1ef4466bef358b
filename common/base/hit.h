// What a ray found.
#pragma once

#include <tuple>

#include "common/base/material.h"
#include "common/base/ray.h"

namespace rt
{

/// A lesson takes the first three apart as the slides do: `const auto& [I, N, mat] = *hit;`
template <std::floating_point Real>
struct Hit
{
    Point<Real> I;             ///< the intersection point; it knows its primitive
    Vec3<Real> N;              ///< unit normal on the side that the ray comes from: dot(D, N) <= 0
    const Material<Real>& mat; ///< of the surface at I, checker included
    Real t;                    ///< distance along the ray, > 0
    bool inside;               ///< the ray arrived on the inner side: the outward normal is -N
    Real n1, n2;               ///< index of refraction before and behind the surface, seen along the ray; 1 if opaque

    Vec3<Real> outwardNormal() const { return inside ? -N : N; }
};

template <std::size_t index, std::floating_point Real>
const auto& get(const Hit<Real>& hit)
{
    if constexpr (index == 0)
        return hit.I;
    else if constexpr (index == 1)
        return hit.N;
    else
        return hit.mat;
}

} // namespace rt

// The tuple protocol, so that a structured binding sees I, N and mat and not the bookkeeping.
template <class Real>
struct std::tuple_size<rt::Hit<Real>> : std::integral_constant<std::size_t, 3>
{
};
template <std::size_t index, class Real>
struct std::tuple_element<index, rt::Hit<Real>>
{
    using type = std::remove_reference_t<decltype(rt::get<index>(std::declval<const rt::Hit<Real>&>()))>;
};
