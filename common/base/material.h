// What a surface does with light.
#pragma once

#include <string>

#include "common/base/vec.h"

namespace rt
{

/// Plain data; the lessons decide what they model of it.
template <std::floating_point Real>
struct Material
{
    std::string name;
    Vec3<Real> color{1, 1, 1}; ///< absorption: multiplies everything that leaves the surface; each channel in [0, 1]
    Real mirror = 0;           ///< share s of pure specular reflection in [0, 1]; the rest is direct illumination
    Real ior = 0;              ///< index of refraction inside; 0: not a dielectric
    Real iorOutside = 1;       ///< index of refraction outside
    Real glossy = 0;           ///< f in [0, 1]: (1 - f)(N.L) + f (V.R)^exponent
    Real exponent = 1;         ///< alpha, at least 0

    bool isMirror() const { return mirror == 1; }
    bool isDielectric() const { return ior > 0; }
};

} // namespace rt
