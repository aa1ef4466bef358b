// Lesson 09, limitations: a path tracer in one page. Lecture: "Limitations of Whitted-style".
// Where lesson 08 follows every branch of the ray tree, a path takes one of them at random; so it can also afford the
// branches that lesson 08 leaves out. One path is a guess; the mean of many is the picture.
#pragma once

#include <random>

#include "common/scene/lesson.h"

namespace rt::lesson09
{

// What the reference models beyond lesson 08; the scene's own policies for caps and Fresnel are left out.
struct Beyond
{
    double lightRadius = 0.25; // > 0: a point light becomes a glowing sphere of this radius
    int bounces = 0;           // how often a path may leave a diffuse surface; 0 is direct light only
    bool lobes = false;        // glossy surfaces reflect whatever is there; else only lamps, as in lesson 08
};

// Units. The lecture has no 1/pi in its diffuse surface, so 1/pi stands before the integral over all directions instead:
//     colour(I) = mat.color * 1/pi * integral of L(w) phong(w) dw
// A sphere of radius r and radiance light.color / r² fills pi r²/dist² of the directions at I, far away. It then brings
// 1/pi * light.color / r² * pi r²/dist² = light.color / dist²: the lesson's point light.
struct Reference
{
    using Real = double;
    using vec3 = Vec3<Real>;
    using Color = Vec3<Real>;
    using Ray = rt::Ray<Real>;
    using Point = rt::Point<Real>;
    using Light = rt::Light<Real>;
    using Hit = rt::Hit<Real>;

    const Scene<Real>& scene;
    const Beyond beyond;
    std::mt19937_64 generator; // one for each pixel, seeded with its number
    const int MAXDEPTH = scene.settings.maxDepth;

    Color trace(const Ray& ray)
    {
        return follow(ray, beyond.bounces, true);
    }

    // What does one path along this ray bring? The point that it leaves may have asked for the lamps already: then a lamp
    // that the path meets by chance is not counted again. Behind glass or a mirror it is, and that is a caustic.
    Color follow(const Ray& ray, int bounces, bool countLamps)
    {
        if (ray.depth > MAXDEPTH) return BLACK;
        const auto hit = scene.intersect(ray);
        Color color = BLACK;
        if (countLamps) color = glow(ray, hit ? hit->t : infinity<Real>);
        if (!hit) return color + scene.sky.color(ray.D);
        const auto& [I, N, mat] = *hit;

        // Each branch is taken as often as its weight says (Fr, s, f), so the weight itself is not multiplied again.
        if (mat.isDielectric()) return color + mat.color * follow(glass(ray, *hit), bounces, true);
        if (random() < mat.mirror)
            return color + mat.color * follow(ray.spawn(reflected, I, reflect(ray.D, N)), bounces, true);
        if (beyond.lobes && random() < mat.glossy)
        {
            // cos^alpha around the mirror's direction: alpha -> infinity is the partial mirror of lesson 03.
            const vec3 R = around(reflect(ray.D, N), 1 - std::pow(random(), 1 / (mat.exponent + 1)));
            if (!(dot(N, R) > 0)) return color; // into the surface: lost
            return color + mat.color * follow(ray.spawn(reflected, I, R), bounces, true);
        }
        const Real f = beyond.lobes ? 0 : mat.glossy;
        color += mat.color * direct(I, N, -ray.D, f, mat.exponent);
        if (bounces == 0) return color;
        // Directions as frequent as their N.L: that and 1/pi cancel, and the light that comes back counts as it is.
        const vec3 L = around(N, 1 - std::sqrt(1 - random()));
        return color + (1 - f) * (mat.color * follow(ray.spawn(reflected, I, L), bounces - 1, false));
    }

    // Lesson 08's direct light, from a random point of each lamp instead of its middle: some are hidden, some are not.
    Color direct(const Point& I, const vec3& N, const vec3& V, Real f, Real alpha)
    {
        Color sum = BLACK;
        const Real r = beyond.lightRadius;
        for (const Light& light : scene.lights)
        {
            const vec3 C = light.position - I;
            const Real dist = length(C);
            if (dist * dist == 0) continue;
            // The lamp fills the cone of directions whose cosine to C is at least 1 - v; from inside, all of them.
            const Real sinSquared = r * r / (dist * dist);
            const Real v = dist > r ? sinSquared / (1 + std::sqrt(1 - sinSquared)) : 2;
            const vec3 L = unit(around(C / dist, random() * v));
            const Real t = Shapes<Real>::intersectSphere({.O = I, .D = L}, {light.position, r}).value_or(dist);
            if (scene.occluded(I, L, t)) continue;
            const Color filter = scene.shadowTint(I, L, t);
            sum += filter * (light.color / (r * r)) * phong(L, N, V, f, alpha) * (2 * v); // the cone's 2 pi v, over pi
        }
        return sum;
    }

    // The lamps between the ray's origin and its hit. They glow, but stop no ray.
    Color glow(const Ray& ray, Real nearest)
    {
        Color sum = BLACK;
        const Real r = beyond.lightRadius;
        for (const Light& light : scene.lights)
        {
            const auto t = Shapes<Real>::intersectSphere(ray, {light.position, r});
            if (t && *t < nearest) sum += light.color / (r * r);
        }
        return sum;
    }

    static Real phong(const vec3& L, const vec3& N, const vec3& V, Real f, Real alpha)
    {
        const Real NL = dot(N, L);
        if (f == 0 || !(NL > 0)) return positive(NL);
        return (1 - f) * NL + f * std::pow(positive(dot(V, 2 * NL * N - L)), alpha);
    }

    // Reflected with probability Fr, else transmitted: Snell and the Fresnel equations of lessons 05 and 06.
    Ray glass(const Ray& ray, const Hit& hit)
    {
        const auto& [I, N, mat] = hit;
        const Real n1 = hit.n1, n2 = hit.n2, cos1 = -dot(N, ray.D);
        const Real k = 1 - (n1 / n2) * (n1 / n2) * (1 - cos1 * cos1);
        const Real cos2 = std::sqrt(positive(k));
        const Real rs = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
        const Real rp = (n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1);
        if (k < 0 || random() < (rs * rs + rp * rp) / 2) return ray.spawn(reflected, I, reflect(ray.D, N));
        return ray.spawn(transmitted, I, n1 / n2 * ray.D + (n1 / n2 * cos1 - cos2) * N);
    }

    static vec3 reflect(const vec3& D, const vec3& N)
    {
        return D - 2 * dot(D, N) * N;
    }

    // A direction whose cosine to the axis is 1 - v, turned about the axis at random.
    vec3 around(const vec3& axis, Real v)
    {
        const Real angle = 2 * SkyFormulas<Real>::PI * random(), sin = std::sqrt(v * (2 - v));
        const vec3 U = unit(cross(std::abs(axis.x) < 0.5 ? vec3(1, 0, 0) : vec3(0, 1, 0), axis));
        return sin * (std::cos(angle) * U + std::sin(angle) * cross(axis, U)) + (1 - v) * axis;
    }

    // Uniform in [0, 1).
    Real random()
    {
        return Real(generator() >> 11) * 0x1p-53;
    }
};

} // namespace rt::lesson09
