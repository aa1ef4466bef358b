// The one include of a lesson: the scene with its two questions, the ray, and names that the slides use.
#pragma once

#include "common/base/todo.h"
#include "common/scene/recorder.h"
#include "common/scene/scene.h"

namespace rt
{

/// BLACK converts to the black of whichever scalar type a lesson runs in.
inline constexpr struct Black
{
    template <std::floating_point Real>
    constexpr operator Vec3<Real>() const
    {
        return Vec3<Real>(0, 0, 0);
    }
} BLACK;

/// max(0, x), and 0 for NaN: light from behind a surface does not subtract.
template <std::floating_point Real>
constexpr Real positive(Real x)
{
    return x > 0 ? x : 0;
}

} // namespace rt
