// What the tests at the extremes share: the last lesson's tracer in every precision, and a recorder that keeps its paths
// in the tracer's own type.
#pragma once

#include <map>
#include <random>

#include <gtest/gtest.h>

#include "common/scene/render.h"
#include "lessons/08_phong/trace.h"
#include "tests/cases/scenes.h"
#include "tests/common/scaled_scene.h"

namespace rt::numerics
{

using cases::Build;
using V = Vec3<double>;
using Precisions = testing::Types<float, double, long double>; ///< the last is the reference of the others

template <std::floating_point Real>
inline constexpr Real eps = std::numeric_limits<Real>::epsilon();

/// A figure worth knowing: --gtest_output=xml shows it beside the test.
inline void note(const std::string& what, double measured)
{
    testing::Test::RecordProperty(what, fmt::format("{:.3g}", measured));
}

/// got = expected, up to `ulps` units in the last place of expected in Real. Notes the worst of the test.
template <std::floating_point Real>
testing::AssertionResult near(Real got, long double expected, double ulps)
{
    const double error = double(std::abs((long double)got - expected) / (eps<Real> * std::abs(expected)));
    static std::map<const testing::TestInfo*, double> worst;
    auto& most = worst[testing::UnitTest::GetInstance()->current_test_info()];
    if (error > most) note("worst_ulp", most = error);
    if (error <= ulps || (long double)got == expected) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "expected " << double(expected) << ", got " << double(got) << ": " << error
                                       << " ulp off, " << ulps << " may";
}

/// The largest component of a - b.
template <std::floating_point Real>
long double apart(const Vec3<Real>& a, const Vec3<long double>& b)
{
    return largestChannel(abs(Vec3<long double>(a) - b));
}

/// One ray of a path and what it met.
template <std::floating_point Real>
struct Step
{
    Ray<Real> ray;
    PrimitiveId on = noPrimitive;
    Vec3<Real> I{0}, N{0};
    Real t = 0, n1 = 1, n2 = 1;
};

/// Keeps every ray that is followed. A TreeRecorder keeps doubles, which would be too coarse a reference.
template <std::floating_point Real>
struct PathRecorder : NoRecorder
{
    std::vector<Step<Real>>* path = nullptr;

    void ray(const Ray<Real>& ray, const std::optional<Hit<Real>>& hit) const
    {
        path->push_back({ray});
        if (hit) path->back() = {ray, hit->I.on, hit->I, hit->N, hit->t, hit->n1, hit->n2};
    }
};

template <std::floating_point Real>
Vec3<Real> colorOf(const Scene<Real>& scene, const Ray<Real>& ray)
{
    lesson08::Tracer<Real> tracer{scene};
    return tracer.trace(ray);
}

/// All rays that lesson 08 follows, in its order.
template <std::floating_point Real>
std::vector<Step<Real>> pathOf(const Scene<Real>& scene, const Ray<Real>& ray)
{
    std::vector<Step<Real>> path;
    lesson08::Tracer<Real, PathRecorder<Real>> tracer{scene, {{}, &path}};
    tracer.trace(ray);
    return path;
}

/// Lesson 08's picture of the scene.
template <std::floating_point Real>
Image pictureOf(const SceneDescription& description)
{
    return render<lesson08::Tracer<Real>>(Scene<Real>(description), description.camera.width, description.camera.height,
                                          {});
}

inline Material<double> grey(double albedo)
{
    return {.name = "grey", .color = V(albedo)};
}

inline Material<double> mirrorOf(double albedo, double share = 1)
{
    return {.name = "mirror", .color = V(albedo), .mirror = share};
}

inline Material<double> glassOf(double ior, double outside = 1, double albedo = 1)
{
    return {.name = "glass", .color = V(albedo), .ior = ior, .iorOutside = outside};
}

inline Material<double> glossyOf(double albedo, double share, double exponent)
{
    return {.name = "glossy", .color = V(albedo), .glossy = share, .exponent = exponent};
}

/// Uniform random numbers and directions that are the same in every type.
struct Random
{
    std::mt19937 engine;

    explicit Random(unsigned seed) : engine(seed) {}
    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
    double power10(double low, double high) { return std::pow(10.0, in(low, high)); }
    bool chance(double share) { return in(0, 1) < share; }
    int below(int n) { return int(engine() % unsigned(n)); }
    V vector(double low, double high) { return {in(low, high), in(low, high), in(low, high)}; }
    V direction()
    {
        for (;;)
            if (const V v = vector(-1, 1); dot(v, v) <= 1 && dot(v, v) > 0.01) return glm::normalize(v);
    }
};

/// The whole scene elsewhere.
inline SceneDescription moved(SceneDescription scene, const V& by)
{
    scene.camera.eye += by;
    scene.camera.target += by;
    for (auto& sphere : scene.spheres) sphere.center += by;
    for (auto& plane : scene.planes) plane.point += by;
    for (auto& triangle : scene.triangles)
        for (auto& vertex : triangle.vertices) vertex += by;
    for (auto& light : scene.lights) light.position += by;
    return scene;
}

/// A closed convex mesh around `center`: an octahedron whose faces were split n times and blown up to a ball of radius r.
inline MeshDescription ballMesh(const V& center, double r, int splits)
{
    using Triangle = std::array<V, 3>;
    std::vector<Triangle> triangles;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) triangles.push_back({V(x, 0, 0), V(0, y, 0), V(0, 0, z)});
    for (; splits > 0; --splits)
    {
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : triangles)
        {
            const V ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = finer;
    }
    for (auto& triangle : triangles)
        for (auto& vertex : triangle) vertex = center + r * vertex;
    return {.file = "ball", .triangles = std::make_shared<const std::vector<Triangle>>(triangles)};
}

} // namespace rt::numerics
