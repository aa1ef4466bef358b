// A pinhole camera.
#pragma once

#include <numbers>

#include "common/base/portable.h"
#include "common/base/ray.h"
#include "common/scene/scene_description.h"

namespace rt
{

/// f = unit(target - eye), r = unit(f x up), u = r x f. Throws UnfitNumber if a number does not fit Real.
template <std::floating_point Real>
class Camera
{
public:
    explicit Camera(const CameraDescription& description)
        : eye(narrow<Real>(description.eye, "camera.eye")), width(description.width), height(description.height)
    {
        // In float, eye and target may round to the same point.
        using Vec = Vec3<Wide<Real>>;
        forward = Vec3<Real>(unit(Vec(description.target) - Vec(description.eye)));
        right = unit(cross(forward, Vec3<Real>(unit(Vec(description.up)))));
        above = cross(right, forward);
        const Real degree = std::numbers::pi_v<Real> / 180;
        halfHeight = portable::tan(Real(description.verticalFov) * degree / 2);
        if (!(halfHeight > 0)) // rounded to 0, or to 180 degrees
            throw UnfitNumber("camera.vertical_fov",
                              "camera.vertical_fov = " + shortestDigits(description.verticalFov) +
                                  " does not fit the tracer's scalar type");
    }

    /// The ray through the point (x, y) of the picture: x in [0, width] to the right, y in [0, height] down; the centre
    /// of pixel (px, py) is (px + 0.5, py + 0.5).
    Ray<Real> ray(Real x, Real y) const
    {
        const Real h = (2 * x / Real(width) - 1) * halfHeight * Real(width) / Real(height);
        const Real v = (1 - 2 * y / Real(height)) * halfHeight;
        return {.O = eye, .D = unit(forward + h * right + v * above)};
    }

private:
    Vec3<Real> eye, forward, right, above;
    Real halfHeight;
    int width, height;
};

} // namespace rt
