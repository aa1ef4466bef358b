// Small helpers of the cases: to set up a scene, and to look at a picture of it.
#pragma once

#include <numbers>

#include "common/files/picture_file.h"
#include "common/files/scene_file.h"
#include "tests/cases/check.h"
#include "tests/cases/subject.h"

namespace rt::cases
{

inline constexpr double degree = std::numbers::pi / 180;

/// A scene of the project, small enough for a golden picture.
inline SceneDescription smallScene(const std::string& relative)
{
    SceneDescription scene = loadScene(std::string(RAYTREE_SOURCE_DIR) + "/" + relative);
    scene.camera.width = 64;
    scene.camera.height = 48;
    return scene;
}

/// Builds scenes in one expression: Build().floor(0).light({0, 2, 0}, 8).scene.
struct Build
{
    SceneDescription scene;

    Build& material(const Material<double>& material)
    {
        scene.materials.push_back(material);
        return *this;
    }
    /// The objects that follow have the last material, or a white diffuse one if there is none.
    int last()
    {
        if (scene.materials.empty()) scene.materials.push_back({.name = "white"});
        return int(scene.materials.size()) - 1;
    }
    Build& plane(const V& point, const V& normal)
    {
        const int mat = last();
        scene.planes.push_back({.point = point, .normal = normal, .material = mat});
        return *this;
    }
    Build& floor() { return plane({0, 0, 0}, {0, 1, 0}); }
    Build& sphere(const V& center, double radius)
    {
        const int mat = last();
        scene.spheres.push_back({center, radius, mat});
        return *this;
    }
    Build& triangle(const V& a, const V& b, const V& c)
    {
        const int mat = last();
        scene.triangles.push_back({{a, b, c}, mat});
        return *this;
    }
    Build& light(const V& position, const V& color)
    {
        scene.lights.push_back({position, color});
        return *this;
    }
    Build& light(const V& position, double grey) { return light(position, V(grey)); }
    Build& sky(const V& color)
    {
        scene.sky.present = true;
        scene.sky.color = color;
        return *this;
    }
    Build& fresnel(FresnelModel model)
    {
        scene.trace.fresnel = model;
        return *this;
    }
    Build& depth(int maxDepth)
    {
        scene.trace.maxDepth = maxDepth;
        return *this;
    }
};

/// Compares the subject's 64x48 picture of a scene with the stored one.
inline void checkGolden(Check& check, const Subject& subject, const std::string& scene, const std::string& golden)
{
    const Image expected = readImage(std::string(RAYTREE_SOURCE_DIR) + "/tests/cases/golden/" + golden);
    const Image got = subject.picture(smallScene(scene));
    // The stored floats keep 24 bits. In float, a pixel on an edge may fall on its other side: at most 1 in 100.
    const bool single = subject.epsilon > 1e-10;
    const Comparison result = compare(got, expected, single ? 1e-4 : 1e-7, single ? 1e-3 : 1e-6);
    check.that(golden + ": same size as the stored picture", result.sameSize);
    const int allowed = single ? int(expected.pixels.size() / 100) : 0;
    check.that(fmt::format("{}: {} pixels differ from the stored picture, worst at ({}, {}) by {:.3g}; {} may", golden,
                           result.wrong, result.x, result.y, result.worst, allowed),
               result.wrong <= allowed);
}

} // namespace rt::cases
