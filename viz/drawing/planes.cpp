#include "viz/drawing/planes.h"

#include <algorithm>
#include <cmath>
#include <execution>
#include <numeric>

#include "common/base/image.h"
#include "common/scene/scene.h"
#include "viz/drawing/mesh.h"

namespace rt::viz
{

namespace
{

/// So many questions whether a light is hidden are asked for one patch at most.
constexpr double mostShadowTests = 4e7;

double smooth(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

struct Painter
{
    const PlanePatch& patch;
    const SceneDescription& description;
    Scene<double> scene{description};
    const Plane<double>& plane = scene.planes[std::size_t(patch.plane)];
    PrimitiveId id = PrimitiveId(scene.spheres.size()) + patch.plane;
    vec3 N = unit(cross(patch.right, patch.forward));
    bool withShadows = true;

    vec3 light(const vec3& point) const
    {
        if (scene.lights.empty()) return vec3(0.6);
        vec3 sum(0.1);
        for (const auto& lamp : scene.lights)
        {
            vec3 L = lamp.position - point;
            const double dist = length(L), cosine = dot(N, L) / dist;
            if (!(cosine > 0)) continue;
            L /= dist;
            if (withShadows && scene.occluded({point, id}, L, dist)) continue;
            sum += lamp.color * cosine / (dist * dist);
        }
        return sum;
    }

    /// The mean colour of the checker over a cell of the patch picture.
    vec3 albedo(double u, double v, double step) const
    {
        vec3 sum(0);
        constexpr int n = 3;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                sum += scene
                           .materials[std::size_t(plane.materialAt(
                               patch.at(u + step * ((i + 0.5) / n - 0.5), v + step * ((j + 0.5) / n - 0.5))))]
                           .color;
        return sum / double(n * n);
    }

    Rgba at(double u, double v, double step, const vec3& lightHere) const
    {
        const double edge = std::hypot(2 * u - 1, 2 * v - 1), alpha = 1 - smooth((edge - 0.55) / 0.45);
        if (alpha <= 0) return {0, 0, 0, 0};
        const vec3 color = albedo(u, v, step);
        if (patch.seeThrough)
        {
            const vec3 silver = color * vec3(0.30, 0.38, 0.48);
            return Rgba{toSrgb8(silver.x), toSrgb8(silver.y), toSrgb8(silver.z)}.withAlpha(0.42 * alpha);
        }
        const vec3 lit = color * lightHere;
        const auto screen = [](double x) { return toSrgb8(0.9 * x / (1 + 0.35 * x)); };
        return Rgba{screen(lit.x), screen(lit.y), screen(lit.z)}.withAlpha(alpha);
    }
};

/// Keeps the part of the patch on that side of an opaque plane on which the eye is (Sutherland and Hodgman).
void cut(PlanePatch& patch, const SceneDescription& scene, const PlaneDescription& by)
{
    if (scene.materials[std::size_t(by.material)].isDielectric()) return;
    vec3 N = unit(by.normal);
    if (dot(scene.camera.eye - by.point, N) < 0) N = -N;
    const auto height = [&](const std::array<double, 2>& uv) { return dot(patch.at(uv[0], uv[1]) - by.point, N); };
    std::vector<std::array<double, 2>> kept;
    for (std::size_t i = 0; i < patch.outline.size(); ++i)
    {
        const auto &from = patch.outline[i], &to = patch.outline[(i + 1) % patch.outline.size()];
        const double a = height(from), b = height(to);
        if (a >= 0) kept.push_back(from);
        if ((a < 0) == (b < 0)) continue;
        const double t = a / (a - b);
        kept.push_back({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
    }
    patch.outline = kept;
}

} // namespace

std::vector<PlanePatch> planePatches(const SceneDescription& scene, const Extent& shown)
{
    std::vector<PlanePatch> patches;
    const vec3 up = unit(scene.camera.up);
    for (std::size_t i = 0; i < scene.planes.size(); ++i)
    {
        const auto& plane = scene.planes[i];
        const auto& material = scene.materials[std::size_t(plane.material)];
        vec3 N = unit(plane.normal);
        const vec3 centre = shown.centre - dot(shown.centre - plane.point, N) * N;
        if (dot(scene.camera.eye - plane.point, N) < 0) N = -N;
        const auto [u, v] = across(N);
        const double half = 1.5 * shown.radius;
        PlanePatch patch;
        patch.plane = int(i);
        patch.right = 2 * half * u;
        patch.forward = 2 * half * v;
        patch.corner = centre - half * u - half * v;
        patch.seeThrough = material.isMirror() || material.isDielectric();
        patch.isFloor = dot(N, up) > 0.7;
        for (std::size_t j = 0; j < scene.planes.size(); ++j)
            if (j != i) cut(patch, scene, scene.planes[j]);
        if (isFinite(patch.corner) && patch.outline.size() >= 3) patches.push_back(patch);
    }
    return patches;
}

PatchPicture paintPatch(const PlanePatch& patch, const SceneDescription& scene, int side)
{
    Painter painter{patch, scene};
    const double primitives = double(scene.spheres.size() + scene.planes.size() + scene.triangles.size());
    painter.withShadows = double(side) * side * double(scene.lights.size()) * primitives <= mostShadowTests;
    const auto index = [side](int i, int j) { return std::size_t(j) * std::size_t(side) + std::size_t(i); };
    const auto cells = std::size_t(side) * std::size_t(side);
    std::vector<vec3> light(patch.seeThrough ? 0 : cells);
    std::vector<int> rows(static_cast<std::size_t>(side));
    std::iota(rows.begin(), rows.end(), 0);
    const auto forEach = [&](const auto& work) {
        std::for_each(std::execution::par, rows.begin(), rows.end(), [&](int j) {
            for (int i = 0; i < side; ++i) work(i, j, (i + 0.5) / side, (j + 0.5) / side);
        });
    };
    if (!patch.seeThrough)
        forEach([&](int i, int j, double u, double v) {
            if (std::hypot(2 * u - 1, 2 * v - 1) < 1.02) light[index(i, j)] = painter.light(patch.at(u, v));
        });

    // The mean over the neighbours softens the edges of shadows, which are sharper than the cells are small.
    const auto soft = [&](int i, int j) {
        if (light.empty()) return vec3(0);
        vec3 sum(0);
        for (const int dj : {-1, 0, 1})
            for (const int di : {-1, 0, 1})
                sum += light[index(std::clamp(i + di, 0, side - 1), std::clamp(j + dj, 0, side - 1))];
        return sum / 9.0;
    };
    PatchPicture picture{side, std::vector<Rgba>(cells)};
    forEach([&](int i, int j, double u, double v) {
        picture.pixels[index(i, j)] = painter.at(u, v, 1.0 / side, soft(i, j));
    });
    return picture;
}

} // namespace rt::viz
