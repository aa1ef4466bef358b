// Lesson 01, direct illumination. Lecture: "Whitted-style Ray Tracing, Pseudocode", first version.
#pragma once

#include "common/scene/lesson.h"

namespace rt::lesson01
{

template <std::floating_point Real, RayRecorder<Real> Recorder = NoRecorder>
struct Tracer
{
    using vec3 = Vec3<Real>;
    using Color = Vec3<Real>;
    using Ray = rt::Ray<Real>;
    using Point = rt::Point<Real>;
    using Light = rt::Light<Real>;
    // EXERCISE: using Sphere = rt::Sphere<Real>;
    // EXERCISE: using Plane = rt::Plane<Real>;

    const Scene<Real>& scene;
    Recorder rec = {};

    // What does this ray see?
    Color trace(const Ray& ray)
    {
        // IntersectScene: common/scene/scene.h asks each object through the formulas of common/base/shapes.h.
        // EXERCISE: const auto hit = scene.intersect(ray, *this);
        const auto hit = scene.intersect(ray);
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
        // SOLUTION 01-direct
        Color direct = BLACK;
        for (const Light& light : scene.lights)
        {
            vec3 L = light.position - I;
            const Real dist = length(L);
            if (dist * dist == 0) continue; // the lamp sits on the point: there is no direction to it
            L *= 1 / dist;
            if (!isVisible(I, L, dist, light)) continue;
            const Real attenuation = 1 / (dist * dist);
            direct += light.color * positive(dot(N, L)) * attenuation;
        }
        return direct;
        // END
    }

    // Is the way from I along L free until the lamp, and no further?
    bool isVisible(const Point& I, const vec3& L, Real dist, const Light& light)
    {
        // EXERCISE: // scene.occluded(I, L, distance, *this) asks your own formulas whether something is in the way.
        // EXERCISE: bool visible = false;
        // SOLUTION 01-visible
        const bool visible = !scene.occluded(I, L, dist);
        // END
        rec.shadow(light, I, L, dist, visible);
        return visible;
    }

    // EXERCISE-FROM common/base/shapes.h: intersectSphere intersectPlane
};

} // namespace rt::lesson01
