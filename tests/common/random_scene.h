// Random scenes that use exactly the features that a lesson models.
#pragma once

#include <algorithm>
#include <random>

#include "common/features.h"

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
        if (i % 2 == 1 && has(Feature::mirror)) mat.mirror = 1;
        scene.materials.push_back(mat);
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
