// What cases run on. A student's process has one of these too: core headers and the standard library only, and nothing
// that holds a solution but the formulas of shapes.h and sky.h, which it gets without.
#pragma once

#include <functional>

#include "common/scene/pixel.h"
#include "common/tree/tree_recorder.h"

namespace rt::cases
{

using V = Vec3<double>;

/// A lesson in some precision, a solved exercise, a student's, or a mutant, behind one face: cases are compiled once and
/// know nothing of types. Functions that the subject does not have are empty. All may throw NotAttempted.
struct Subject
{
    double epsilon = 0; ///< of its scalar type
    std::function<V(const SceneDescription&, const V& origin, const V& direction)> color;
    std::function<RayTree(const SceneDescription&, const V& origin, const V& direction)> tree;
    std::function<Image(const SceneDescription&)> picture;
    std::function<double(const V& origin, const V& direction, const V& center, double radius)>
        toSphere; ///< t, -1: miss
    std::function<double(const V& origin, const V& direction, const V& point, const V& normal)> toPlane;
    std::function<V(const V& D, const V& N)> reflect;
    std::function<std::array<double, 2>(const V& D)> latLong;
    std::function<std::optional<V>(const V& D, const V& N, double n1, double n2)> refract;
    std::function<double(double cos1, double n1, double n2)> cosSquared2, fresnel, schlick;
    std::function<double(const V& L, const V& N, const V& view, double glossy, double exponent)> phong;

    /// `count` units in the last place of 1, in its precision.
    double ulps(double count) const { return count * epsilon; }
};

template <std::floating_point Real>
Ray<Real> rayOf(const V& origin, const V& direction)
{
    return {.O = Vec3<Real>(origin), .D = unit(Vec3<Real>(direction))};
}

/// The subject that traces with Plain (no recording) and Recorded. An exercise has one type for both, and may bring its
/// own formulas for shapes.
template <std::floating_point Real, class Plain, class Recorded>
Subject makeSubject()
{
    Subject subject;
    subject.epsilon = double(std::numeric_limits<Real>::epsilon());
    subject.color = [](const SceneDescription& description, const V& origin, const V& direction) {
        const Scene<Real> scene(description);
        Plain tracer{scene};
        return V(tracer.trace(rayOf<Real>(origin, direction)));
    };
    subject.tree = [](const SceneDescription& description, const V& origin, const V& direction) {
        const Scene<Real> scene(description);
        RayTree tree;
        tree.maxDepth = description.trace.maxDepth;
        Recorded tracer{scene, TreeRecorder<Real>(tree, scene)};
        tracer.trace(rayOf<Real>(origin, direction));
        return tree;
    };
    subject.picture = [](const SceneDescription& description) {
        return renderAlone<Plain>(Scene<Real>(description), description.camera.width, description.camera.height);
    };
    constexpr bool ownShapes = requires
    {
        &Plain::intersectSphere;
    };
    using Formulas = std::conditional_t<ownShapes, Plain, Shapes<Real>>;
    subject.toSphere = [](const V& origin, const V& direction, const V& center, double radius) {
        const Sphere<Real> sphere{Vec3<Real>(center), Real(radius), 0};
        return double(Formulas::intersectSphere(rayOf<Real>(origin, direction), sphere).value_or(-1));
    };
    subject.toPlane = [](const V& origin, const V& direction, const V& point, const V& normal) {
        const Plane<Real> plane{.P = Vec3<Real>(point), .N = unit(Vec3<Real>(normal))};
        return double(Formulas::intersectPlane(rayOf<Real>(origin, direction), plane).value_or(-1));
    };
    if constexpr (requires { &Plain::reflect; })
        subject.reflect = [](const V& D, const V& N) {
            return V(Plain::reflect(unit(Vec3<Real>(D)), unit(Vec3<Real>(N))));
        };
    constexpr bool ownSky = requires
    {
        &Plain::latLong;
    };
    using SkyOf = std::conditional_t<ownSky, Plain, SkyFormulas<Real>>;
    subject.latLong = [](const V& D) {
        const auto [u, v] = SkyOf::latLong(unit(Vec3<Real>(D)));
        return std::array{double(u), double(v)};
    };
    if constexpr (requires { &Plain::refract; })
    {
        subject.refract = [](const V& D, const V& N, double n1, double n2) -> std::optional<V> {
            const auto T = Plain::refract(unit(Vec3<Real>(D)), unit(Vec3<Real>(N)), Real(n1), Real(n2));
            return T ? std::optional<V>(V(*T)) : std::nullopt;
        };
        subject.cosSquared2 = [](double cos1, double n1, double n2) {
            return double(Plain::cosSquared2(Real(cos1), Real(n1), Real(n2)));
        };
    }
    if constexpr (requires { &Plain::fresnel; })
    {
        subject.fresnel = [](double cos1, double n1, double n2) {
            return double(Plain::fresnel(Real(cos1), Real(n1), Real(n2)));
        };
        subject.schlick = [](double cos1, double n1, double n2) {
            return double(Plain::schlick(Real(cos1), Real(n1), Real(n2)));
        };
    }
    if constexpr (requires { &Plain::phong; })
        subject.phong = [](const V& L, const V& N, const V& view, double glossy, double exponent) {
            Material<Real> mat;
            mat.glossy = Real(glossy);
            mat.exponent = Real(exponent);
            return double(Plain::phong(unit(Vec3<Real>(L)), unit(Vec3<Real>(N)), unit(Vec3<Real>(view)), mat));
        };
    return subject;
}

/// `Lesson::Tracer<Real, Recorder>` is its tracer.
template <class Lesson, std::floating_point Real>
Subject lessonSubject()
{
    return makeSubject<Real, typename Lesson::template Tracer<Real, NoRecorder>,
                       typename Lesson::template Tracer<Real, TreeRecorder<Real>>>();
}

template <class Tracer>
Subject exerciseSubject()
{
    return makeSubject<double, Tracer, Tracer>();
}

} // namespace rt::cases
