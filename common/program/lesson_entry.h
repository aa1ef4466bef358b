// A lesson as the programs, the viewer and the tests see it: its facts and two functions.
#pragma once

#include <array>
#include <string>
#include <variant>

#include "common/program/lesson_facts.h"
#include "common/scene/render.h"
#include "common/tree/ray_tree.h"
#include "common/tree/tree_recorder.h"

namespace rt
{

enum class Precision
{
    floating,
    doubled,
    longDouble
};

const char* name(Precision precision); ///< "float", "double", "long-double"

/// A ray in world space; the direction need not have unit length.
struct GivenRay
{
    Vec3<double> origin{0, 0, 0}, direction{0, 0, -1};
};

/// Whose tree is wanted: pixel (x, y) of the scene's picture, or one ray.
using Probe = std::variant<std::array<int, 2>, GivenRay>;

struct LessonEntry : LessonFacts
{
    using Stop = const std::atomic<bool>*;

    Image (*render)(const SceneDescription&, Precision, const RenderOptions&);
    RayTree (*traceTree)(const SceneDescription&, Precision, const Probe&, Stop);

    /// Throws TooManyRays, and Stopped once `stop` is set.
    RayTree inspect(const SceneDescription& description, Precision precision, const Probe& probe,
                    Stop stop = nullptr) const
    {
        return traceTree(description, precision, probe, stop);
    }
};

namespace detail
{

/// Calls visit with a zero of the scalar type.
template <class Visit>
auto withPrecision(Precision precision, Visit&& visit)
{
    if (precision == Precision::floating) return visit(0.0F);
    if (precision == Precision::longDouble) return visit(0.0L);
    return visit(0.0);
}

template <std::floating_point Real>
Ray<Real> probeRay(const Scene<Real>& scene, const Probe& probe)
{
    if (const auto* pixel = std::get_if<std::array<int, 2>>(&probe))
        return scene.camera.ray(Real((*pixel)[0]) + Real(0.5), Real((*pixel)[1]) + Real(0.5));
    const auto& given = std::get<GivenRay>(probe);
    // To about length 1 by a power of two, so that it fits any type; no bit of the unit vector depends on it.
    const auto size = abs(given.direction);
    const int exponent = std::ilogb(largestChannel(size));
    Vec3<double> direction;
    for (int axis = 0; axis < 3; ++axis) direction[axis] = std::ldexp(given.direction[axis], -exponent);
    return {.O = narrow<Real>(given.origin, "the ray's origin"), .D = unit(Vec3<Real>(direction))};
}

template <class Tracer, std::floating_point Real>
void traceInto(RayTree& tree, const Scene<Real>& scene, const Probe& probe, const std::atomic<bool>* stop)
{
    const TraceLimit limit(stop);
    Tracer tracer{scene, TreeRecorder<Real>(tree, scene)};
    try
    {
        tracer.trace(probeRay(scene, probe));
    }
    catch (const NotAttempted&)
    {
        // The tree as far as it got: an exercise is worth looking at before it is finished.
    }
    catch (const TooManyRays&)
    {
        throw TooManyRays(tree.pixel ? pixelText((*tree.pixel)[0], (*tree.pixel)[1]) : "the ray", tree.maxDepth);
    }
}

inline RayTree emptyTree(int lesson, const SceneDescription& scene, const char* real, const Probe& probe)
{
    RayTree tree;
    tree.lesson = lesson;
    tree.scene = scene.file;
    tree.real = real;
    if (const auto* pixel = std::get_if<std::array<int, 2>>(&probe)) tree.pixel = *pixel;
    tree.maxDepth = scene.trace.maxDepth;
    return tree;
}

} // namespace detail

/// `Lesson::Tracer<Real, Recorder>` in every precision. Lesson also has `static constexpr int number`.
template <class Lesson>
Image renderLesson(const SceneDescription& description, Precision precision, const RenderOptions& options)
{
    return detail::withPrecision(precision, [&](auto zero) {
        using Real = decltype(zero);
        const Scene<Real> scene(description);
        return render<typename Lesson::template Tracer<Real, NoRecorder>>(scene, description.camera.width,
                                                                          description.camera.height, options);
    });
}

template <class Lesson>
RayTree inspectLesson(const SceneDescription& description, Precision precision, const Probe& probe,
                      const std::atomic<bool>* stop = nullptr)
{
    return detail::withPrecision(precision, [&](auto zero) {
        using Real = decltype(zero);
        const Scene<Real> scene(description);
        RayTree tree = detail::emptyTree(Lesson::number, description, name(precision), probe);
        detail::traceInto<typename Lesson::template Tracer<Real, TreeRecorder<Real>>>(tree, scene, probe, stop);
        return tree;
    });
}

/// An exercise has no template line: it runs in double, with a recorder that may be off.
template <class Tracer>
Image renderExercise(const SceneDescription& description, Precision, const RenderOptions& options)
{
    const Scene<double> scene(description);
    return render<Tracer>(scene, description.camera.width, description.camera.height, options);
}

template <int number, class Tracer>
RayTree inspectExercise(const SceneDescription& description, Precision, const Probe& probe,
                        const std::atomic<bool>* stop)
{
    const Scene<double> scene(description);
    RayTree tree = detail::emptyTree(number, description, name(Precision::doubled), probe);
    detail::traceInto<Tracer>(tree, scene, probe, stop);
    return tree;
}

} // namespace rt
