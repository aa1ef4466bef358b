// Lesson 04, HDR sky. Lecture: "Reflecting a HDR Sky".
#pragma once

#include "common/scene/lesson.h"

namespace rt::lesson04
{

template <std::floating_point Real, RayRecorder<Real> Recorder = NoRecorder>
struct Tracer
{
    using vec3 = Vec3<Real>;
    using Color = Vec3<Real>;
    using Ray = rt::Ray<Real>;
    using Point = rt::Point<Real>;
    using Light = rt::Light<Real>;
    // EXERCISE: using vec2 = std::array<Real, 2>;
    // EXERCISE: static constexpr Real PI = SkyFormulas<Real>::PI;

    const Scene<Real>& scene;
    Recorder rec = {};
    const int MAXDEPTH = scene.settings.maxDepth;

    // What does this ray see? If nothing else, the sky; and what it brings is not clamped: a dark mirror may be bright.
    Color trace(const Ray& ray)
    {
        if (ray.depth > MAXDEPTH)
        {
            rec.capped(ray);
            return BLACK;
        }
        const auto hit = scene.intersect(ray);
        rec.ray(ray, hit);
        if (!hit)
        {
            // EXERCISE: Color sky = BLACK;
            // SOLUTION 04-miss
            const Color sky = scene.sky.color(ray.D);
            // END
            rec.own(sky);
            return sky;
        }
        const auto& [I, N, mat] = *hit;

        Color color = BLACK;
        const Real s = mat.mirror;
        if (s < 1) color = (1 - s) * (mat.color * directIllumination(I, N));
        rec.own(color);
        if (s > 0) color += s * (mat.color * trace(ray.spawn(reflected, I, reflect(ray.D, N), s)));

        rec.color(color);
        return color;
    }

    // Angle of incidence equals angle of reflection: D without its part along N, and that part turned round.
    static vec3 reflect(const vec3& D, const vec3& N)
    {
        const vec3 A = dot(D, N) * N;
        const vec3 B = D - A;
        return B - A; // R = D - 2(D.N)N
    }

    // The light that arrives at I: each lamp that is visible from there, weakened by angle and distance.
    Color directIllumination(const Point& I, const vec3& N)
    {
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
    }

    // Is the way from I along L free until the lamp, and no further?
    bool isVisible(const Point& I, const vec3& L, Real dist, const Light& light)
    {
        const bool visible = !scene.occluded(I, L, dist);
        rec.shadow(light, I, L, dist, visible);
        return visible;
    }

    // EXERCISE-FROM common/scene/sky.h: latLong
};

} // namespace rt::lesson04
