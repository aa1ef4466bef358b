// What cases run on, and small helpers to set up a scene and ask it for a colour, a tree or a picture.
#pragma once

#include <concepts>

#include "common/lesson_entry.h"
#include "common/scene_file.h"
#include "tests/lessons/check.h"

namespace rt::cases
{

using V = Vec3<double>;

/// A lesson in one precision. `Lesson::Tracer<Real, Recorder>` is its tracer.
template <class Lesson, std::floating_point Scalar>
struct LessonSubject
{
    using Real = Scalar;
    using Plain = typename Lesson::template Tracer<Real, NoRecorder>;
    using Recorded = typename Lesson::template Tracer<Real, TreeRecorder<Real>>;
    using Formulas = Shapes<Real>;
};

/// An exercise. Its tracer may bring its own formulas for shapes.
template <class Tracer>
struct ExerciseSubject
{
    using Real = double;
    using Plain = Tracer;
    using Recorded = Tracer;
    static constexpr bool ownFormulas = requires { &Tracer::intersectSphere; };
    using Formulas = std::conditional_t<ownFormulas, Tracer, Shapes<double>>;
};

/// `ulps` units in the last place of 1, in the subject's precision.
template <class Subject>
constexpr double ulps(double count)
{
    return count * double(std::numeric_limits<typename Subject::Real>::epsilon());
}

template <class Subject>
Ray<typename Subject::Real> rayOf(const V& origin, const V& direction)
{
    using Real = typename Subject::Real;
    return {.O = Vec3<Real>(origin), .D = unit(Vec3<Real>(direction))};
}

/// What the subject sees along the ray.
template <class Subject>
V colorOf(const SceneDescription& description, const V& origin, const V& direction)
{
    const Scene<typename Subject::Real> scene(description);
    typename Subject::Plain tracer{scene};
    return V(tracer.trace(rayOf<Subject>(origin, direction)));
}

template <class Subject>
RayTree treeOf(const SceneDescription& description, const V& origin, const V& direction)
{
    const Scene<typename Subject::Real> scene(description);
    RayTree tree;
    tree.maxDepth = description.trace.maxDepth;
    typename Subject::Recorded tracer{scene, TreeRecorder<typename Subject::Real>(tree, scene)};
    tracer.trace(rayOf<Subject>(origin, direction));
    return tree;
}

template <class Subject>
Image pictureOf(const SceneDescription& description)
{
    const Scene<typename Subject::Real> scene(description);
    return render<typename Subject::Plain>(scene, description.camera.width, description.camera.height, {});
}

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
    Build& depth(int maxDepth)
    {
        scene.trace.maxDepth = maxDepth;
        return *this;
    }
};

/// Compares the subject's 64x48 picture of a scene with the stored one.
template <class Subject>
void checkGolden(Check& check, const std::string& scene, const std::string& golden)
{
    const Image expected = readImage(std::string(RAYTREE_SOURCE_DIR) + "/tests/lessons/golden/" + golden);
    const Image got = pictureOf<Subject>(smallScene(scene));
    // The stored floats keep 24 bits. In float, a pixel on an edge may fall on its other side: at most 1 in 100.
    constexpr bool single = std::same_as<typename Subject::Real, float>;
    const Comparison result = compare(got, expected, single ? 1e-4 : 1e-7, single ? 1e-3 : 1e-6);
    check.that(golden + ": same size as the stored picture", result.sameSize);
    const int allowed = single ? int(expected.pixels.size() / 100) : 0;
    check.that(fmt::format("{}: {} pixels differ from the stored picture, worst at ({}, {}) by {:.3g}; {} may", golden,
                           result.wrong, result.x, result.y, result.worst, allowed),
               result.wrong <= allowed);
}

} // namespace rt::cases
