// Lesson 10, speed and accuracy: lesson 08 in a world that can be told to choose badly. Lecture: none, but every slide's code
// has to choose. World is the scene and three choices: where a ray meets a sphere, where the next ray starts, and what is
// Schlick's angle. With the good ones the picture has the bits of lesson 08.
#pragma once

#include "common/scene/lesson.h"

namespace rt::lesson10
{

template <std::floating_point Real, class World, RayRecorder<Real> Recorder = NoRecorder>
struct Tracer
{
    using vec3 = Vec3<Real>;
    using Color = Vec3<Real>;
    using Ray = rt::Ray<Real>;
    using Point = rt::Point<Real>;
    using Light = rt::Light<Real>;
    using Hit = rt::Hit<Real>;
    using Material = rt::Material<Real>;

    const World& scene;
    Recorder rec = {};
    const int MAXDEPTH = scene.settings.maxDepth;

    // What does this ray see? Glossy surfaces show the lamps as highlights, and nothing else.
    Color trace(const Ray& ray)
    {
        if (ray.depth > MAXDEPTH) return atCap(ray);
        if (ray.energy * scene.brightest < scene.settings.cutoff)
        {
            rec.cutoff(ray);
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
        if (s < 1) color = (1 - s) * (mat.color * directIllumination(I, N, -ray.D, mat));
        rec.own(color);
        if (s > 0) color += s * (mat.color * trace(ray.spawn(reflected, scene.leave(I, N), reflect(ray.D, N), s)));

        rec.color(color);
        return color;
    }

    // What stands in for a ray that is too deep: the scene file names the policy.
    Color atCap(const Ray& ray)
    {
        Color color = BLACK;
        if (scene.settings.atCap != AtCap::black) color = scene.sky.color(ray.D);
        const auto hit = scene.settings.atCap == AtCap::direct ? scene.intersect(ray) : std::nullopt;
        if (hit)
        {
            rec.ray(ray, hit);
            color = hit->mat.color * directIllumination(hit->I, hit->N, -ray.D, hit->mat);
            rec.color(color);
            return color;
        }
        rec.capped(ray, color);
        return color;
    }

    // At the boundary of two media light splits: the share Fr is reflected, the rest Ft = 1 - Fr is transmitted.
    Color glass(const Ray& ray, const Hit& hit)
    {
        const auto& [I, N, mat] = hit;
        const auto T = refract(ray.D, N, hit.n1, hit.n2);
        const Real Fr = T ? reflectance(-dot(N, ray.D), hit.n1, hit.n2) : 1;
        rec.fresnel(Fr);
        Color color = BLACK;
        const Real Ft = 1 - Fr;
        if (Fr > 0) color += Fr * (mat.color * trace(ray.spawn(reflected, scene.leave(I, N), reflect(ray.D, N), Fr)));
        if (Ft > 0) color += Ft * (mat.color * trace(ray.spawn(transmitted, scene.leave(I, -N), *T, Ft)));
        return color;
    }

    // The scene file names the model; `none` transmits everything, as lesson 05 did.
    Real reflectance(Real cos1, Real n1, Real n2)
    {
        if (scene.wrongAngle) return scene.schlickWithIncidentAngle(cos1, n1, n2);
        if (scene.settings.fresnel == FresnelModel::none) return 0;
        return scene.settings.fresnel == FresnelModel::schlick ? schlick(cos1, n1, n2) : fresnel(cos1, n1, n2);
    }

    // The Fresnel equations for unpolarised light: the mean of the squares for the two polarisations.
    static Real fresnel(Real cos1, Real n1, Real n2)
    {
        const Real k = cosSquared2(cos1, n1, n2);
        if (n1 == n2) return 0;
        if (k < 0) return 1;
        const Real cos2 = std::sqrt(k);
        const Real rs = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
        const Real rp = (n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1);
        return (rs * rs + rp * rp) / 2;
    }

    // Schlick's approximation, with the larger of the two angles: the one in the thinner medium.
    static Real schlick(Real cos1, Real n1, Real n2)
    {
        const Real k = cosSquared2(cos1, n1, n2);
        if (n1 == n2) return 0;
        if (k < 0) return 1;
        const Real R0 = (n1 - n2) / (n1 + n2) * (n1 - n2) / (n1 + n2);
        const Real x = 1 - (n1 > n2 ? std::sqrt(k) : cos1);
        return R0 + (1 - R0) * x * x * x * x * x;
    }

    // The transmitted vector after Snell, n1 sin θ1 = n2 sin θ2; nothing at total internal reflection. N faces the ray.
    static std::optional<vec3> refract(const vec3& D, const vec3& N, Real n1, Real n2)
    {
        const Real cos1 = -dot(N, D);
        const Real k = cosSquared2(cos1, n1, n2);
        if (k < 0) return std::nullopt;
        return n1 / n2 * D + (n1 / n2 * cos1 - std::sqrt(k)) * N;
    }

    // k = cos²θ2 = 1 - (n1/n2)² (1 - cos²θ1). Negative: sin θ2 would exceed 1, there is no such angle.
    static Real cosSquared2(Real cos1, Real n1, Real n2)
    {
        return 1 - (n1 / n2) * (n1 / n2) * (1 - cos1 * cos1);
    }

    // Angle of incidence equals angle of reflection: D without its part along N, and that part turned round.
    static vec3 reflect(const vec3& D, const vec3& N)
    {
        const vec3 A = dot(D, N) * N;
        const vec3 B = D - A;
        return B - A; // R = D - 2(D.N)N
    }

    // The light that arrives at I: each lamp that is visible from there, weakened by angle and distance.
    Color directIllumination(const Point& I, const vec3& N, const vec3& V, const Material& mat)
    {
        Color direct = BLACK;
        for (const Light& light : scene.lights)
        {
            vec3 L = light.position - I;
            const Real dist = length(L);
            if (dist * dist == 0) continue; // the lamp sits on the point: there is no direction to it
            L *= 1 / dist;
            if (!isVisible(scene.leave(I, N), L, dist, light)) continue;
            const Real attenuation = 1 / (dist * dist);
            const Color filter = scene.shadowTint(I, L, dist); // white, unless shadow_through_glass = "tint"
            direct += filter * light.color * phong(L, N, V, mat) * attenuation;
        }
        return direct;
    }

    // (1 - f)(N.L) + f (V.R)^alpha: part diffuse, part glossy. V points back along the ray that arrived here.
    static Real phong(const vec3& L, const vec3& N, const vec3& V, const Material& mat)
    {
        const Real f = mat.glossy, NL = dot(N, L);
        if (f == 0 || !(NL > 0)) return positive(NL);
        const vec3 R = 2 * NL * N - L;
        const Real VR = std::min(Real(1), positive(dot(V, R))); // rounding may lift a cosine above 1
        return (1 - f) * NL + f * portable::pow(VR, mat.exponent);
    }

    // Is the way from I along L free until the lamp, and no further?
    bool isVisible(const Point& I, const vec3& L, Real dist, const Light& light)
    {
        const bool visible = !scene.occluded(I, L, dist);
        rec.shadow(light, I, L, dist, visible);
        return visible;
    }
};

} // namespace rt::lesson10
