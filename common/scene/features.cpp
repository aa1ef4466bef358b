#include "common/scene/features.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace rt
{

const char* name(Feature feature)
{
    constexpr const char* names[] = {"direct illumination",
                                     "mirrors",
                                     "partial reflection",
                                     "a sky",
                                     "refraction",
                                     "Fresnel reflection",
                                     "cutoff and cap policies",
                                     "glossy highlights"};
    return names[int(feature)];
}

std::vector<Requirement> required(const SceneDescription& scene)
{
    std::set<int> used;
    for (const auto& sphere : scene.spheres) used.insert(sphere.material);
    for (const auto& plane : scene.planes) used.insert(plane.material);
    for (const auto& triangle : scene.triangles) used.insert(triangle.material);
    for (const auto& mesh : scene.meshes) used.insert(mesh.material);

    std::vector<Requirement> found;
    const auto need = [&](Feature feature, std::string because) {
        const auto same = [&](const Requirement& r) { return r.feature == feature; };
        if (std::none_of(found.begin(), found.end(), same)) found.push_back({feature, std::move(because)});
    };
    bool branches = false;
    for (const int index : used)
    {
        const auto& mat = scene.materials[std::size_t(index)];
        branches = branches || mat.mirror > 0 || mat.isDielectric();
        if (mat.isMirror()) need(Feature::mirror, fmt::format("material '{}' is a mirror (mirror = 1)", mat.name));
        if (mat.mirror > 0 && mat.mirror < 1)
            need(Feature::partial,
                 fmt::format("material '{}' is a partial mirror (mirror = {})", mat.name, mat.mirror));
        if (mat.isDielectric())
        {
            need(Feature::refraction, fmt::format("material '{}' is a dielectric (ior = {})", mat.name, mat.ior));
            if (scene.trace.fresnel != FresnelModel::none)
                need(Feature::fresnel, fmt::format("material '{}' reflects and transmits", mat.name));
        }
        if (mat.glossy > 0)
            need(Feature::phong, fmt::format("material '{}' is glossy (glossy = {})", mat.name, mat.glossy));
    }
    if (!scene.lights.empty() && !used.empty()) need(Feature::direct, "it has lights");
    if (scene.sky.image || scene.sky.zenith || scene.sky.sun || scene.sky.color != Vec3<double>(0))
        need(Feature::sky, "it has a [sky]");
    if (branches && scene.trace.cutoff > 0) need(Feature::policies, "[trace] sets a cutoff");
    if (branches && scene.trace.atCap != AtCap::black) need(Feature::policies, "[trace] sets at_cap");
    const bool dielectric = std::any_of(used.begin(), used.end(),
                                        [&](int index) { return scene.materials[std::size_t(index)].isDielectric(); });
    if (dielectric && !scene.lights.empty() && scene.trace.shadowThroughGlass == ShadowThroughGlass::tint)
        need(Feature::policies, "[trace] sets shadow_through_glass");
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.feature < b.feature; });
    return found;
}

std::vector<Requirement> missing(const std::vector<Requirement>& requirements, const FeatureSet& models)
{
    std::vector<Requirement> absent;
    for (const auto& requirement : requirements)
        if (std::find(models.begin(), models.end(), requirement.feature) == models.end()) absent.push_back(requirement);
    return absent;
}

} // namespace rt
