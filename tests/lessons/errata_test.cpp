// Where the slides print something else than what is right: each test computes the printed form, shows that it is wrong, and
// holds the lesson to what is right. slides-notes/errata.md names these tests.
#include <gtest/gtest.h>

#include "lessons/00_geometry/geometry.h"
#include "lessons/01_direct_illumination/trace.h"
#include "lessons/04_hdr_sky/trace.h"
#include "lessons/05_refraction/trace.h"
#include "lessons/06_fresnel/trace.h"
#include "lessons/08_phong/trace.h"
#include "tests/cases/scenes.h"

namespace rt::cases
{

namespace
{

constexpr double PI = SkyFormulas<double>::PI;
constexpr double degree = PI / 180;
const V up(0, 1, 0);

/// A ray that arrives at a floor at this angle to the normal.
V arriving(double angle)
{
    return {std::sin(angle), -std::cos(angle), 0};
}

template <class Tracer>
V color(const SceneDescription& description, const V& origin, const V& direction)
{
    const Scene<double> scene(description);
    Tracer tracer{scene};
    return tracer.trace(rayOf<double>(origin, direction));
}

using Refraction = lesson05::Tracer<double>;
using Glass = lesson06::Tracer<double>;
using Shading = lesson08::Tracer<double>;

TEST(Errata, FresnelNeedsBothTermsAndTheirSquares)
{
    const auto amplitude = [](double cos1, double n1, double n2) {
        const double ratio = n1 / n2, cos2 = std::sqrt(1 - ratio * ratio * (1 - cos1 * cos1));
        return std::abs((n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2));
    };
    const auto printed = [&](double cos1) { return (amplitude(cos1, 1, 1.5) + amplitude(cos1, 1, 1.5)) / 2; };
    const auto oneTermSquared = [&](double cos1) { return amplitude(cos1, 1, 1.5) * amplitude(cos1, 1, 1.5); };

    EXPECT_NEAR(printed(1), 0.2, 1e-12);
    EXPECT_NEAR(Glass::fresnel(1, 1, 1.5), 0.04, 1e-12);
    // With its squares the printed term is right straight on, and wrong at a slant.
    EXPECT_NEAR(oneTermSquared(1), 0.04, 1e-12);
    EXPECT_NEAR(oneTermSquared(0.5), 0.177, 1e-3);
    EXPECT_NEAR(Glass::fresnel(0.5, 1, 1.5), 0.08918671280221278, 1e-12);
}

/// The largest angle, in degrees, at which lesson 05 still transmits from n1 to n2.
double criticalAngleOfTheLesson(double n1, double n2)
{
    double transmits = 0, reflects = 90;
    for (int i = 0; i < 60; ++i)
    {
        const double middle = (transmits + reflects) / 2;
        (Refraction::refract(arriving(middle * degree), up, n1, n2) ? transmits : reflects) = middle;
    }
    return transmits;
}

TEST(Errata, CriticalAngleDoesNotAskForAngle2)
{
    const auto printed = [](double n1, double n2, double angle2) {
        return std::asin(n2 / n1 * std::sin(angle2 * degree)) / degree;
    };
    EXPECT_NEAR(criticalAngleOfTheLesson(1.5, 1), 41.810314895778598, 1e-6);
    for (const double angle2 : {0.0, 30.0, 60.0, 80.0}) EXPECT_LT(printed(1.5, 1, angle2), 41.1);
    EXPECT_NEAR(printed(1.5, 1, 90), 41.810314895778598, 1e-9); // right for this angle 2 only
    // Into the denser medium there is none, and the lesson transmits at every angle.
    EXPECT_TRUE(Refraction::refract(arriving(89.9 * degree), up, 1, 1.5).has_value());
}

TEST(Errata, TotalInternalReflectionBeginsAtN2OverN1)
{
    // sin1 <= n²/n1, whichever n is meant, lets all light at 70 degrees pass from glass into water.
    const double sin1 = std::sin(70 * degree), n1 = 1.5, n2 = 1.333;
    EXPECT_LE(sin1, n2 * n2 / n1);
    EXPECT_LE(sin1, n1 * n1 / n1);
    EXPECT_GT(sin1, n2 / n1);
    EXPECT_FALSE(Refraction::refract(arriving(70 * degree), up, n1, n2).has_value());
    EXPECT_NEAR(criticalAngleOfTheLesson(n1, n2), 62.70617607933242, 1e-6);
}

TEST(Errata, KHasTheSquareOfTheCosine)
{
    const auto withCosineOfSquare = [](double angle, double ratio) {
        return 1 - ratio * ratio * (1 - std::cos(angle * angle));
    };
    const auto withoutSquare = [](double angle, double ratio) { return 1 - ratio * ratio * (1 - std::cos(angle)); };
    struct Oracle
    {
        double degrees, n1, n2, k;
    };
    for (const auto& [degrees, n1, n2, k] : {Oracle{45, 1, 1.5, 7.0 / 9}, {60, 1, 2, 0.8125}, {30, 1.5, 1, 0.4375}})
    {
        const double angle = degrees * degree;
        EXPECT_GT(std::abs(withCosineOfSquare(angle, n1 / n2) - k), 0.02);
        EXPECT_GT(std::abs(withoutSquare(angle, n1 / n2) - k), 0.02);
        EXPECT_NEAR(Refraction::cosSquared2(std::cos(angle), n1, n2), k, 1e-12);
        EXPECT_NEAR(Glass::cosSquared2(std::cos(angle), n1, n2), k, 1e-12);
    }
}

TEST(Errata, SchlickTakesTheLargerAngle)
{
    const auto printed = [](double cosine, double n1, double n2) {
        const double R0 = std::pow((n1 - n2) / (n1 + n2), 2);
        return R0 + (1 - R0) * std::pow(1 - cosine, 5);
    };
    const double cos1 = std::cos(40 * degree);
    EXPECT_NEAR(printed(cos1, 1.5, 1), 0.0407, 1e-4);
    EXPECT_NEAR(Glass::schlick(cos1, 1.5, 1), 0.2456, 1e-4);
    EXPECT_NEAR(Glass::fresnel(cos1, 1.5, 1), 0.2453, 1e-4);
    // Beyond the critical angle, and between equal media.
    EXPECT_LT(printed(std::cos(45 * degree), 1.5, 1), 0.05);
    EXPECT_EQ(Glass::schlick(std::cos(45 * degree), 1.5, 1), 1);
    EXPECT_GT(printed(0.5, 1.5, 1.5), 0.03);
    EXPECT_EQ(Glass::schlick(0.5, 1.5, 1.5), 0);
}

TEST(Errata, DirectLightIsNeverNegative)
{
    // One lamp above the floor brings 1, one below it, with the printed dot(N, L), would take 2 away.
    const auto scene = Build().floor().light({0, 2, 0}, 4).light({0, -1, 0}, 2).scene;
    const double printed = 4 * dot(up, V(0, 1, 0)) / 4 + 2 * dot(up, V(0, -1, 0)) / 1;
    EXPECT_EQ(printed, -1);
    EXPECT_NEAR(color<lesson01::Tracer<double>>(scene, {1, 1, 0}, {-1, -1, 0}).x, 1, 1e-12);
    EXPECT_NEAR(color<Glass>(scene, {1, 1, 0}, {-1, -1, 0}).x, 1, 1e-12);
    EXPECT_NEAR(color<Shading>(scene, {1, 1, 0}, {-1, -1, 0}).x, 1, 1e-12);
}

TEST(Errata, ShadowRaysStopAtTheLamp)
{
    const auto description = Build().floor().light({0, 2, 0}, 4).sphere({0, 4, 0}, 1).scene;
    const Scene<double> scene(description);
    const auto hit = scene.intersect(rayOf<double>({1, 1, 0}, {-1, -1, 0}));
    ASSERT_TRUE(hit.has_value());
    EXPECT_TRUE(scene.occluded(hit->I, up, infinity<double>)); // a shadow ray without an end
    EXPECT_FALSE(scene.occluded(hit->I, up, 2));
    EXPECT_NEAR(color<lesson01::Tracer<double>>(description, {1, 1, 0}, {-1, -1, 0}).x, 1, 1e-12);
    EXPECT_NEAR(color<Shading>(description, {1, 1, 0}, {-1, -1, 0}).x, 1, 1e-12);
}

/// (V.R)^alpha of lesson 08: all gloss.
double highlight(const V& L, const V& view, double exponent)
{
    Material<double> mat;
    mat.glossy = 1;
    mat.exponent = exponent;
    return Shading::phong(unit(L), up, unit(view), mat);
}

TEST(Errata, PhongMirrorsALThatLeavesTheSurface)
{
    const auto printed = [](const V& light, const V& view, double exponent) {
        const V L = unit(light), R = L - 2 * dot(L, up) * up;
        return std::pow(positive(dot(unit(view), R)), exponent);
    };
    // Lamp and eye at 45 degrees on opposite sides: the middle of the highlight.
    EXPECT_EQ(printed({1, 1, 0}, {-1, 1, 0}, 8), 0);
    EXPECT_NEAR(highlight({1, 1, 0}, {-1, 1, 0}, 8), 1, 1e-12);
    // Both low and on the same side: nothing is mirrored that way.
    EXPECT_GT(printed({1, 0.2, 0}, {1, 0.1, 0}, 8), 0.6);
    EXPECT_EQ(highlight({1, 0.2, 0}, {1, 0.1, 0}, 8), 0);
}

TEST(Errata, HighlightsCarryLightFalloffAndShadow)
{
    // The printed formula knows the lamp's direction only: it is 1 in the middle of the highlight, whatever the lamp.
    const double printed = 1;
    const auto floor = [](double distance, double brightness) {
        return Build()
            .material({.name = "g", .glossy = 1, .exponent = 4})
            .floor()
            .light(distance * unit(V(1, 1, 0)), brightness);
    };
    const auto seen = [](Build build) { return color<Shading>(build.scene, {-2, 2, 0}, {1, -1, 0}).x; };
    EXPECT_NEAR(seen(floor(2, 4)), printed, 1e-12);
    EXPECT_NEAR(seen(floor(2, 8)), 2, 1e-12);
    EXPECT_NEAR(seen(floor(4, 4)), 0.25, 1e-12);
    EXPECT_EQ(seen(floor(4, 4).sphere({1, 1, 0}, 0.25)), 0);
}

TEST(Errata, HighlightsNeedTheLampInFront)
{
    const V L = unit(V(1, -0.1, 0)), view = unit(V(-1, 0.1, 0)), R = 2 * dot(up, L) * up - L;
    EXPECT_GT(std::pow(dot(view, R), 8), 0.8); // the printed formula has no N.L in its second term
    EXPECT_EQ(highlight(L, view, 8), 0);
}

TEST(Errata, AMissShowsTheSky)
{
    const auto scene = Build().sky({0.25, 0.5, 2}).scene;
    const V printed = BLACK;
    EXPECT_NE(color<lesson04::Tracer<double>>(scene, {0, 0, 0}, {1, 2, 3}), printed);
    EXPECT_EQ(color<lesson04::Tracer<double>>(scene, {0, 0, 0}, {1, 2, 3}), V(0.25, 0.5, 2));
    EXPECT_EQ(color<Shading>(scene, {0, 0, 0}, {1, 2, 3}), V(0.25, 0.5, 2));
}

TEST(Errata, RadianceMayGrowDeeperInTheTree)
{
    const auto description =
        Build().sky(V(100)).material({.name = "bowling", .color = V(0.01), .mirror = 1}).sphere({0, 0, 0}, 1).scene;
    const Scene<double> scene(description);
    RayTree tree;
    lesson04::Tracer<double, TreeRecorder<double>> tracer{scene, TreeRecorder<double>(tree, scene)};
    tracer.trace(rayOf<double>({0, 0, 3}, {0, 0, -1}));
    ASSERT_EQ(tree.nodes.size(), 2u);
    const bool printed = tree.nodes[1].radiance.x <= tree.nodes[0].radiance.x; // "energy does not increase deeper"
    EXPECT_FALSE(printed);
    EXPECT_NEAR(tree.nodes[0].radiance.x, 1, 1e-12);
    EXPECT_EQ(tree.nodes[1].radiance.x, 100);
    EXPECT_LT(tree.nodes[1].throughput.x, tree.nodes[0].throughput.x); // what is true

    // So a cutoff that asks for the throughput alone would lose the sun.
    auto dim = description;
    dim.trace.cutoff = 0.5;
    EXPECT_NEAR(color<Shading>(dim, {0, 0, 3}, {0, 0, -1}).x, 1, 1e-12);
}

TEST(Errata, TheAverageThroughputMayGrowDeeperInTheTree)
{
    // Water over a mirror, in a sky. The weak reflection at the water ends in the sky, the strong ray goes on alone.
    const auto description = Build()
                                 .sky(V(1))
                                 .depth(6)
                                 .material({.name = "water", .ior = 1.333})
                                 .floor()
                                 .material({.name = "mirror", .mirror = 1})
                                 .plane({0, -1, 0}, {0, 1, 0})
                                 .scene;
    const Scene<double> scene(description);
    RayTree tree;
    lesson06::Tracer<double, TreeRecorder<double>> tracer{scene, TreeRecorder<double>(tree, scene)};
    tracer.trace(rayOf<double>({0, 1, 0}, {1, -2, 0}));
    std::vector<double> sums(7, 0), counts(7, 0);
    for (const auto& node : tree.nodes)
    {
        sums.at(std::size_t(node.depth)) += node.throughput.x;
        counts.at(std::size_t(node.depth)) += 1;
        if (node.parent < 0) continue;
        EXPECT_LE(node.throughput.x, tree.nodes[std::size_t(node.parent)].throughput.x); // what is true
    }
    for (std::size_t depth = 1; depth < sums.size(); ++depth) EXPECT_LE(sums[depth], sums[depth - 1] * (1 + 1e-12));
    ASSERT_EQ(counts[1], 2);
    ASSERT_EQ(counts[2], 1);
    const bool printed = sums[2] / counts[2] <= sums[1] / counts[1]; // "the average ... decreases with depth"
    EXPECT_FALSE(printed);
    EXPECT_NEAR(sums[1] / counts[1], 0.5, 1e-12);
    EXPECT_GT(sums[2] / counts[2], 0.9);
}

TEST(Errata, ALineIn3DHasMoreThanTwoUnitNormals)
{
    using Geometry = lesson00::Geometry<double>;
    const auto line = Geometry::parametricForm({-4, 1, 1}, {2, 2, 5});
    const V D = unit(line.D), first = unit(Geometry::normals(line).first);
    std::vector<V> different; // the printed two are n and -n
    for (int angle = 0; angle < 360; angle += 45)
    {
        const V N = Geometry::unitNormal(line, angle * degree);
        EXPECT_NEAR(dot(N, D), 0, 1e-12);
        EXPECT_NEAR(length(N), 1, 1e-12);
        bool known = length(N - first) < 0.1 || length(N + first) < 0.1;
        for (const V& other : different) known = known || length(N - other) < 0.1;
        if (!known) different.push_back(N);
    }
    EXPECT_EQ(different.size(), 6u);
}

} // namespace

} // namespace rt::cases
