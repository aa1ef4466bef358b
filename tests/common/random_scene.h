// Random scenes that use exactly the features that a lesson models.
#pragma once

#include <algorithm>
#include <random>

#include "common/scene/features.h"

namespace rt
{

inline SceneDescription randomScene(unsigned seed, const FeatureSet& models)
{
    std::mt19937 engine(seed);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    const auto has = [&](Feature feature) { return std::find(models.begin(), models.end(), feature) != models.end(); };
    const auto vector = [&](double low, double high) {
        return Vec3<double>(in(low, high), in(low, high), in(low, high));
    };

    SceneDescription scene;
    scene.file = "random" + std::to_string(seed) + ".toml";
    scene.camera = {.eye = {in(-1, 1), in(1, 3), in(5, 8)}, .target = vector(-0.5, 1), .width = 32, .height = 24};
    scene.trace.maxDepth = 1 + int(seed % 6);
    for (int i = 0; i < 5; ++i)
    {
        Material<double> mat{.name = "m" + std::to_string(i), .color = vector(0.1, 1)};
        if (i == 1 && has(Feature::mirror)) mat.mirror = 1;
        if (i == 2 && has(Feature::partial)) mat.mirror = in(0.1, 0.9);
        if (i == 3 && has(Feature::refraction)) mat.ior = in(1.1, 2);
        if (i == 4 && has(Feature::phong)) mat.glossy = in(0.2, 1), mat.exponent = in(1, 100);
        scene.materials.push_back(mat);
    }
    if (has(Feature::sky))
    {
        scene.sky.present = true;
        scene.sky.color = vector(0, 2);
        scene.sky.zenith = vector(0, 2);
        scene.sky.sun = Sun{.direction = vector(-1, 1), .color = vector(10, 100), .size = in(2, 30)};
    }
    if (!has(Feature::fresnel))
        scene.trace.fresnel = FresnelModel::none;
    else if (seed % 3 == 0)
        scene.trace.fresnel = FresnelModel::schlick;
    if (has(Feature::policies))
    {
        scene.trace.cutoff = seed % 2 ? in(0, 0.1) : 0;
        scene.trace.atCap = AtCap(seed % 3);
        scene.trace.shadowThroughGlass = ShadowThroughGlass(seed / 2 % 2);
    }
    for (int i = 0; i < 6; ++i) scene.spheres.push_back({vector(-2, 2), in(0.2, 1.2), i % 5});
    scene.planes.push_back({.point = {0, -1, 0},
                            .normal = {in(-0.2, 0.2), 1, in(-0.2, 0.2)},
                            .material = 0,
                            .hasChecker = true,
                            .checkerColor = vector(0, 1),
                            .checkerSize = in(0.3, 2)});
    for (int i = 0; i < 3; ++i) scene.triangles.push_back({{vector(-3, 3), vector(-3, 3), vector(-3, 3)}, i});
    for (int i = 0; i < 3; ++i) scene.lights.push_back({vector(-6, 6), vector(5, 40)});
    return scene;
}

} // namespace rt
