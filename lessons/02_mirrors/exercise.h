// Exercise 02, mirrors. Lecture: "Reflected Vector", "Light Transport", pseudocode second version.
// Made from trace.h by make_exercises.py: the TODOs are yours.
#pragma once

#include "common/exercise.h"

namespace rt::exercise02
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

    const Scene<Real>& scene;
    Recorder rec = {};
    const int MAXDEPTH = scene.settings.maxDepth;

    // What does this ray see? A mirror shows what the reflected ray sees: no shadow ray, no N.L, but absorption.
    Color trace(const Ray& ray)
    {
        if (ray.depth > MAXDEPTH)
        {
            rec.capped(ray);
            return BLACK;
        }
        const auto hit = scene.intersect(ray);
        rec.ray(ray, hit);
        if (!hit) return BLACK;
        const auto& [I, N, mat] = *hit;

        Color color = BLACK;
        // TODO 02-mirror (3 points): What does a mirror show?
        // Slide: Reflections: Light Transport
        todo("02-mirror");

        rec.color(color);
        return color;
    }

    // Angle of incidence equals angle of reflection: D without its part along N, and that part turned round.
    static vec3 reflect(const vec3& D, const vec3& N)
    {
        // TODO 02-reflect (3 points): The reflected vector
        // Slide: Reflections: Reflected Vector
        todo("02-reflect");
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
};

} // namespace rt::exercise02
