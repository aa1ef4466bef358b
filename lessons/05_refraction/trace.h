// Lesson 05, refraction. Lecture: "Dielectrics", Snell's law and the transmitted vector.
#pragma once

#include "common/scene/lesson.h"

namespace rt::lesson05
{

template <std::floating_point Real, RayRecorder<Real> Recorder = NoRecorder>
struct Tracer
{
    using vec3 = Vec3<Real>;
    using Color = Vec3<Real>;
    using Ray = rt::Ray<Real>;
    using Point = rt::Point<Real>;
    using Light = rt::Light<Real>;
    using Hit = rt::Hit<Real>;

    const Scene<Real>& scene;
    Recorder rec = {};
    const int MAXDEPTH = scene.settings.maxDepth;

    // What does this ray see? Through glass, what the transmitted ray sees.
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
            const Color sky = scene.sky.color(ray.D);
            rec.own(sky);
            return sky;
        }
        const auto& [I, N, mat] = *hit;

        if (mat.isDielectric())
        {
            const Color through = glass(ray, *hit);
            rec.color(through);
            return through;
        }
        Color color = BLACK;
        const Real s = mat.mirror;
        if (s < 1) color = (1 - s) * (mat.color * directIllumination(I, N));
        rec.own(color);
        if (s > 0) color += s * (mat.color * trace(ray.spawn(reflected, I, reflect(ray.D, N), s)));

        rec.color(color);
        return color;
    }

    // At the boundary of two media the ray goes on in the other one, bent; if it cannot, all of it is reflected.
    Color glass(const Ray& ray, const Hit& hit)
    {
        const auto& [I, N, mat] = hit;
        // SOLUTION 05-glass
        const auto T = refract(ray.D, N, hit.n1, hit.n2);
        if (!T) return mat.color * trace(ray.spawn(reflected, I, reflect(ray.D, N)));
        return mat.color * trace(ray.spawn(transmitted, I, *T));
        // END
    }

    // The transmitted vector after Snell, n1 sin θ1 = n2 sin θ2; nothing at total internal reflection. N faces the ray.
    static std::optional<vec3> refract(const vec3& D, const vec3& N, Real n1, Real n2)
    {
        // SOLUTION 05-refract
        const Real cos1 = -dot(N, D);
        const Real k = cosSquared2(cos1, n1, n2);
        if (k < 0) return std::nullopt;
        return n1 / n2 * D + (n1 / n2 * cos1 - std::sqrt(k)) * N;
        // END
    }

    // k = cos²θ2 = 1 - (n1/n2)² (1 - cos²θ1). Negative: sin θ2 would exceed 1, there is no such angle.
    static Real cosSquared2(Real cos1, Real n1, Real n2)
    {
        // SOLUTION 05-k
        return 1 - (n1 / n2) * (n1 / n2) * (1 - cos1 * cos1);
        // END
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
};

} // namespace rt::lesson05
