#include "common/tree/tree_growth.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/base/ray_limit.h"
#include "common/scene/scene.h"

namespace rt
{

namespace
{

/// Objects whose surfaces split a ray, and those that send it on as a whole.
struct Surfaces
{
    int splitting = 0, mirrors = 0;
};

Surfaces surfacesOf(const SceneDescription& scene)
{
    Surfaces found;
    const auto add = [&](int material, int count) {
        const auto& mat = scene.materials[std::size_t(material)];
        if (mat.isDielectric() && mat.ior != mat.iorOutside)
            found.splitting += count;
        else if (mat.isDielectric() || mat.mirror > 0)
            found.mirrors += count;
    };
    constexpr int facing = 2; // parts of a mesh may face each other
    for (const auto& sphere : scene.spheres) add(sphere.material, 1);
    for (const auto& plane : scene.planes) add(plane.material, 1);
    for (const auto& triangle : scene.triangles) add(triangle.material, 1);
    for (const auto& mesh : scene.meshes) add(mesh.material, facing);
    return found;
}

bool has(const FeatureSet& models, Feature feature)
{
    return std::find(models.begin(), models.end(), feature) != models.end();
}

} // namespace

std::string growthWarning(const SceneDescription& scene, const FeatureSet& models)
{
    if (!has(models, Feature::fresnel) || scene.trace.fresnel == FresnelModel::none) return "";
    if (scene.trace.cutoff > 0 && has(models, Feature::policies)) return "";
    // One ball or plane alone: what leaves it does not come back, and inside one ray goes on at each depth.
    const auto surfaces = surfacesOf(scene);
    if (surfaces.splitting == 0 || surfaces.splitting + surfaces.mirrors < 2) return "";
    const int depth = scene.trace.maxDepth;
    const double deepest = std::ldexp(1.0, depth), lamps = double(scene.lights.size());
    if (2 * deepest - 1 + deepest * lamps <= double(rayLimit)) return "";
    return fmt::format(
        "{}: at depth {} a pixel can lead to 2^{} rays, since glass splits each in two; one that leads to more "
        "than {} is refused",
        scene.file, depth, depth, rayLimitText);
}

std::string cutoffWarning(const SceneDescription& scene, const FeatureSet& models)
{
    const double cutoff = scene.trace.cutoff;
    if (!(cutoff > 0) || !has(models, Feature::policies)) return "";
    const double brightest = Scene<double>(scene).brightest;
    if (brightest >= cutoff || brightest == 0) return "";
    return fmt::format("{}cutoff = {} is more than any ray can bring, which is at most {:.3g} here: no ray is traced",
                       scene.placeOf("trace.cutoff"), cutoff, brightest);
}

} // namespace rt
