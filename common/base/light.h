// Point lights.
#pragma once

#include "common/base/vec.h"

namespace rt
{

/// Sends `color` in every direction; what arrives falls off with 1 / distance².
template <std::floating_point Real>
struct Light
{
    Vec3<Real> position{0, 0, 0};
    Vec3<Real> color{0, 0, 0}; ///< linear RGB at distance 1, at least 0, unbounded
};

} // namespace rt
