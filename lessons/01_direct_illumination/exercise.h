// Exercise 01, direct illumination. Lecture: "Whitted-style Ray Tracing, Pseudocode", first version.
// Made from trace.h by make_exercises.py: the TODOs are yours.
#pragma once

#include "common/exercise.h"

namespace rt::exercise01
{

using Real = double;
using Recorder = TreeRecorder<Real>;

struct Tracer
{
    using vec3 = Vec3<Real>;
    using Color = Vec3<Real>;
    using Ray = rt::Ray<Real>;
    using Point = rt::Point<Real>;
    using Light = rt::Light<Real>;
    using Sphere = rt::Sphere<Real>;
    using Plane = rt::Plane<Real>;

    const Scene<Real>& scene;
    Recorder rec = {};

    // What does this ray see?
    Color trace(const Ray& ray)
    {
        // IntersectScene: common/scene/scene.h asks each object through the formulas of common/base/shapes.h.
        const auto hit = scene.intersect(ray, *this);
        rec.ray(ray, hit);
        if (!hit) return BLACK;
        const auto& [I, N, mat] = *hit;

        Color color = mat.color * directIllumination(I, N);

        rec.color(color);
        return color;
    }

    // The light that arrives at I: each lamp that is visible from there, weakened by angle and distance.
    Color directIllumination(const Point& I, const vec3& N)
    {
        // TODO 01-direct (4 points): How much light arrives at I?
        // Slide: Whitted-style Ray Tracing, Pseudocode: DirectIllumination
        todo("01-direct");
    }

    // Is the way from I along L free until the lamp, and no further?
    bool isVisible(const Point& I, const vec3& L, Real dist, const Light& light)
    {
        // scene.occluded(I, L, distance, *this) asks your own formulas whether something is in the way.
        bool visible = false;
        // TODO 01-visible (2 points): Is the light visible from I?
        // Slide: Whitted-style Ray Tracing, Pseudocode: implement IsVisible
        todo("01-visible");
        rec.shadow(light, I, L, dist, visible);
        return visible;
    }

    // Where does the ray meet the sphere? The smallest t > 0 with |O + tD - C| = r, or nothing. D has length 1.
    static std::optional<Real> intersectSphere(const Ray& ray, const Sphere& sphere)
    {
        // TODO 01-sphere (4 points): Where does the ray meet the sphere?
        // Slide: Whitted-style Ray Tracing, Pseudocode: implement IntersectScene
        todo("01-sphere");
    }

    // Where does the ray meet the plane? The t > 0 with (O + tD - P).N = 0, or nothing: also for a ray along the plane.
    static std::optional<Real> intersectPlane(const Ray& ray, const Plane& plane)
    {
        // TODO 01-plane (2 points): Where does the ray meet the plane?
        // Slide: Whitted-style Ray Tracing, Pseudocode: implement IntersectScene
        todo("01-plane");
    }
};

} // namespace rt::exercise01
