// The reference against closed forms: a wrong reference would teach wrong things about lesson 08.
#include "common/files/text_file.h"
#include "lessons/09_limitations/reference.h"

#include <map>

#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/09_limitations/pairs.h"
#include "lessons/programs/entries.h"
#include "tests/common/random_scene.h"

namespace rt::lesson09
{

namespace
{

using vec3 = Vec3<double>;

/// A scene without lamps, sky and things, in which paths may be long.
SceneDescription nothing()
{
    SceneDescription scene;
    scene.trace.maxDepth = 64;
    return scene;
}

int addMaterial(SceneDescription& scene, const Material<double>& material)
{
    scene.materials.push_back(material);
    return int(scene.materials.size()) - 1;
}

/// The plane y = 0.
void addFloor(SceneDescription& scene, const Material<double>& material)
{
    scene.planes.push_back({.point = {0, 0, 0}, .normal = {0, 1, 0}, .material = addMaterial(scene, material)});
}

void addSphere(SceneDescription& scene, const vec3& center, double radius, const Material<double>& material)
{
    scene.spheres.push_back({center, radius, addMaterial(scene, material)});
}

void addSky(SceneDescription& scene, const vec3& color)
{
    scene.sky.present = true;
    scene.sky.color = color;
}

Ray<double> towards(const vec3& from, const vec3& to)
{
    return {.O = from, .D = unit(to - from)};
}

/// Straight down onto the floor at (x, 0, z), from below all lamps.
Ray<double> onto(double x, double z)
{
    return towards({x, 0.1, z}, {x, 0, z});
}

/// The mean of many paths, of the red channel, and how far from the truth it may be: one standard deviation.
struct Mean
{
    double value = 0, error = 0;
};

Mean mean(const SceneDescription& description, const Beyond& beyond, const Ray<double>& ray, int paths,
          unsigned seed = 1)
{
    const Scene<double> scene(description);
    Reference reference{scene, beyond, std::mt19937_64(seed)};
    double sum = 0, squares = 0;
    for (int i = 0; i < paths; ++i)
    {
        const double value = reference.trace(ray).x;
        sum += value;
        squares += value * value;
    }
    const double m = sum / paths;
    return {m, std::sqrt(std::max(0.0, squares / paths - m * m) / paths)};
}

/// Near the closed form, and so certain of it that a factor of two would be noticed many times over.
void expectNear(const Mean& got, double expected)
{
    EXPECT_NEAR(got.value, expected, 4.5 * got.error + 1e-9 * std::abs(expected));
    EXPECT_LT(got.error, 0.02 * expected);
}

// ---- lamps ---------------------------------------------------------------------------------------------------------

TEST(Reference, AWholeLampBringsThePointLightsFormulaAtAnyRadius)
{
    auto scene = nothing();
    addFloor(scene, {.name = "", .color = {0.5, 0.5, 0.5}});
    scene.lights.push_back({{1, 2, -1}, {12, 12, 12}});
    const double distSquared = 6, NL = 2 / std::sqrt(6);
    for (const double radius : {1e-6, 1e-3, 0.3, 1.0, 1.9})
        expectNear(mean(scene, {.lightRadius = radius}, onto(0, 0), 20000), 0.5 * 12 * NL / distSquared);
}

TEST(Reference, ALampHasTheRadianceColorOverRadiusSquared)
{
    auto scene = nothing();
    scene.lights.push_back({{0, 0, -5}, {3, 3, 3}});
    EXPECT_DOUBLE_EQ(mean(scene, {.lightRadius = 0.5}, towards({0, 0, 0}, {0, 0, -1}), 1).value, 12);
    EXPECT_EQ(mean(scene, {.lightRadius = 0.5}, towards({0, 0, 0}, {0, 0.6, -5}), 1).value, 0);
    addSphere(scene, {0, 0, -2}, 1, {.name = "", .color = {0, 0, 0}});
    EXPECT_EQ(mean(scene, {.lightRadius = 0.5}, towards({0, 0, 0}, {0, 0, -1}), 1).value, 0) << "it is hidden";
}

TEST(Reference, InsideALampLightComesFromEverywhere)
{
    auto scene = nothing();
    addFloor(scene, {.name = "", .color = {0.5, 0.5, 0.5}});
    scene.lights.push_back({{0.1, 0.2, 0}, {8, 8, 8}});
    expectNear(mean(scene, {.lightRadius = 2}, onto(0, 0), 40000), 0.5 * 8 / 4.0);
}

/// Lesson 08's picture is the expected one where a path has one way to go, and the mean picture is where it has several.
TEST(Reference, TinyLampsAndNoBouncesAreLesson08)
{
    const FeatureSet models = {Feature::direct,     Feature::mirror,  Feature::partial, Feature::sky,
                               Feature::refraction, Feature::fresnel, Feature::phong};
    for (unsigned seed = 1; seed <= 6; ++seed)
    {
        SceneDescription scene = randomScene(seed, models);
        scene.trace.fresnel = FresnelModel::exact;
        scene.sky.sun.reset(); // so bright and so small that chance decides
        const Image lesson = lesson08::entry.render(scene, Precision::doubled, {});
        double difference = 0, variance = 0;
        int certain = 0, wrong = 0;
        const Scene<double> forCamera(scene);
        for (int y = 0; y < lesson.height; ++y)
            for (int x = 0; x < lesson.width; ++x)
            {
                const auto ray = forCamera.camera.ray(x + 0.5, y + 0.5);
                const Mean got = mean(scene, {.lightRadius = 1e-4}, ray, 64, unsigned(y * lesson.width + x));
                const double expected = lesson.at(x, y).x;
                difference += got.value - expected;
                variance += got.error * got.error;
                if (got.error > 1e-4) continue;
                ++certain;
                wrong += !(std::abs(got.value - expected) <= 1e-3);
            }
        EXPECT_GT(certain, 200) << "scene " << seed;
        EXPECT_LE(wrong, certain / 50) << "scene " << seed; // where a rare branch was never taken
        EXPECT_LE(std::abs(difference), 4.5 * std::sqrt(variance) + 0.5) << "scene " << seed;
    }
}

TEST(Reference, TintedShadowsAreLesson08s)
{
    auto scene = nothing();
    scene.trace.shadowThroughGlass = ShadowThroughGlass::tint;
    addFloor(scene, {});
    addSphere(scene, {0, 2, 0}, 0.5, {.name = "", .color = {0.5, 0.5, 0.5}, .ior = 1.5});
    scene.lights.push_back({{0, 4, 0}, {16, 16, 16}});
    expectNear(mean(scene, {.lightRadius = 1e-3}, onto(0, 0), 1000), 0.25);
}

// ---- shadows -------------------------------------------------------------------------------------------------------

/// Half of the sky is covered at height 2, the lamp hangs at height 4: the light at (x, 0, 0) as a share of the whole.
Mean penumbra(double x, double radius, int paths, unsigned seed = 1)
{
    auto scene = nothing();
    addFloor(scene, {});
    const int black = addMaterial(scene, {.name = "", .color = {0, 0, 0}});
    scene.triangles.push_back({{vec3(0, 2, -1000), vec3(0, 2, 1000), vec3(-1000, 2, 0)}, black});
    scene.lights.push_back({{0, 4, 0}, {16, 16, 16}});
    Mean got = mean(scene, {.lightRadius = radius}, onto(x, 0), paths, seed);
    const double distSquared = 16 + x * x, whole = 16 * 4 / std::sqrt(distSquared) / distSquared;
    return {got.value / whole, got.error / whole};
}

TEST(Reference, APenumbraIsTheVisibleShareOfTheLampsDisc)
{
    const double radius = 0.5;
    Mean before;
    for (double x = -0.7; x < 0.75; x += 0.1)
    {
        const Mean got = penumbra(x, radius, 4000);
        const double a = std::clamp(-x / radius, -1.0, 1.0);
        EXPECT_NEAR(got.value, (std::acos(a) - a * std::sqrt(1 - a * a)) / SkyFormulas<double>::PI, 0.03) << x;
        EXPECT_GE(got.value, before.value - 4.5 * (got.error + before.error)) << x;
        before = got;
    }
    EXPECT_EQ(penumbra(-0.7, radius, 1000).value, 0);
    EXPECT_NEAR(penumbra(0.7, radius, 1000).value, 1, 0.01);
    expectNear(penumbra(0, radius, 20000), 0.5);
}

TEST(Reference, ErrorsFallWithTheRootOfTheNumberOfPaths)
{
    const auto rootMeanSquare = [](int paths) {
        double squares = 0;
        for (unsigned seed = 0; seed < 300; ++seed) squares += std::pow(penumbra(0, 0.5, paths, seed).value - 0.5, 2);
        return std::sqrt(squares / 300);
    };
    const double ratio = rootMeanSquare(16) / rootMeanSquare(256);
    EXPECT_GT(ratio, 3.2);
    EXPECT_LT(ratio, 5);
}

// ---- indirect light ------------------------------------------------------------------------------------------------

TEST(Reference, AWhiteSceneUnderAWhiteSkyIsWhite)
{
    auto scene = nothing();
    addSky(scene, {1, 1, 1});
    addFloor(scene, {});
    addSphere(scene, {0, 1, 0}, 1, {});
    const Beyond beyond{.bounces = 1000};
    for (const auto& target : {vec3(0.3, 1.5, 0), vec3(0.2, 0.1, 1), vec3(1, 0, 0.4), vec3(0, 5, 0)})
        EXPECT_NEAR(mean(scene, beyond, towards({1, 3, 6}, target), 2000).value, 1, 1e-12);
}

TEST(Reference, AGreyBallUnderASkyHasTheProductOfTheColours)
{
    auto scene = nothing();
    addSky(scene, {2, 2, 2});
    addSphere(scene, {0, 0, -3}, 1, {.name = "", .color = {0.3, 0.3, 0.3}});
    EXPECT_NEAR(mean(scene, {.bounces = 1}, towards({0, 0, 0}, {0.2, 0.1, -3}), 10).value, 0.6, 1e-12);
    EXPECT_EQ(mean(scene, {.bounces = 0}, towards({0, 0, 0}, {0.2, 0.1, -3}), 10).value, 0) << "as in lesson 08";
}

/// The integrating sphere: each bounce adds the same light again, times the colour of the wall.
TEST(Reference, InAHollowBallBouncesAreAGeometricSeries)
{
    auto scene = nothing();
    addSphere(scene, {0, 0, 0}, 2, {.name = "", .color = {0.6, 0.6, 0.6}});
    scene.lights.push_back({{0, 0, 0}, {10, 10, 10}});
    const auto ray = towards({1, 1, 0}, {2, 2, 1});
    const double once = 0.6 * 10 / 4.0;
    for (const int bounces : {0, 1, 2, 5})
        expectNear(mean(scene, {.lightRadius = 0.3, .bounces = bounces}, ray, 2000),
                   once * (1 - std::pow(0.6, bounces + 1)) / (1 - 0.6));
}

TEST(Reference, MaxDepthEndsAPath)
{
    auto scene = nothing();
    addSphere(scene, {0, 0, 0}, 2, {});
    scene.lights.push_back({{0, 0, 0}, {4, 4, 4}});
    for (const int depth : {0, 1, 3})
    {
        scene.trace.maxDepth = depth;
        expectNear(mean(scene, {.bounces = 1000}, towards({1, 1, 0}, {2, 2, 1}), 2000), depth + 1);
    }
}

/// A lamp at distance a below a ceiling at height H lights it with c a / (s² + a²)^(3/2) at distance s from the axis; the
/// floor below the lamp collects that with the weight H² / (pi (s² + H²)²).
TEST(Reference, OneBounceBetweenTwoPlanesIsTheIntegral)
{
    const double floorColor = 0.9, ceilingColor = 0.5, c = 7, H = 3, a = 1;
    auto scene = nothing();
    addFloor(scene, {.name = "", .color = vec3(floorColor)});
    scene.planes.push_back({{0, H, 0}, {0, -1, 0}, addMaterial(scene, {.name = "", .color = vec3(ceilingColor)})});
    scene.lights.push_back({{0, H - a, 0}, vec3(c)});

    double collected = 0;
    const int steps = 200000;
    for (int i = 0; i < steps; ++i)
    {
        const double u = (i + 0.5) / steps, s = u / (1 - u), ds = 1 / ((1 - u) * (1 - u)) / steps;
        collected +=
            ceilingColor * c * a / std::pow(s * s + a * a, 1.5) * 2 * s * H * H / std::pow(s * s + H * H, 2) * ds;
    }
    const double direct = c / ((H - a) * (H - a));
    expectNear(mean(scene, {.lightRadius = 0.2, .bounces = 1}, onto(0, 0), 100000), floorColor * (direct + collected));
}

TEST(Reference, BouncesAreNotSpentOnGlassAndMirrors)
{
    auto scene = nothing();
    addSky(scene, {1, 1, 1});
    addFloor(scene, {.name = "", .color = {0.5, 0.5, 0.5}});
    const auto throughGlass = onto(0, 0), overMirror = towards({1, 1, 0}, {2, 0.5, 0});
    scene.planes.push_back({{2, 0, 0}, {1, 0, 0}, addMaterial(scene, {.name = "", .mirror = 1})});
    addSphere(scene, {0, 0.06, 0}, 0.02, {.name = "", .ior = 1});
    EXPECT_NEAR(mean(scene, {.bounces = 1}, throughGlass, 100).value, 0.5, 1e-12);
    EXPECT_NEAR(mean(scene, {.bounces = 1}, overMirror, 100).value, 0.5, 1e-12);
}

TEST(Reference, ARedWallColoursTheFloorBesideIt)
{
    auto scene = nothing();
    addFloor(scene, {});
    scene.planes.push_back({{-1, 0, 0}, {1, 0, 0}, addMaterial(scene, {.name = "", .color = {1, 0, 0}})});
    scene.lights.push_back({{2, 2, 0}, {8, 8, 8}});
    const Scene<double> tracer(scene);
    vec3 sum(0);
    Reference reference{tracer, {.bounces = 1}, std::mt19937_64(1)};
    for (int i = 0; i < 2000; ++i) sum += reference.trace(onto(-0.8, 0));
    EXPECT_GT(sum.x, 1.15 * sum.y);
    EXPECT_EQ(sum.y, sum.z);
}

// ---- glass and caustics ---------------------------------------------------------------------------------------------

TEST(Reference, GlassUnderAWhiteSkyIsInvisible)
{
    auto scene = nothing();
    addSky(scene, {1, 1, 1});
    addSphere(scene, {0, 0, -3}, 1, {.name = "", .ior = 1.5});
    addSphere(scene, {0.2, 0, -3}, 0.6, {.name = "", .ior = 1, .iorOutside = 1.5});
    for (double x = -1.2; x < 1.25; x += 0.1)
        EXPECT_NEAR(mean(scene, {}, towards({0, 0, 0}, {x, 0.1, -3}), 300).value, 1, 1e-12) << x;
}

TEST(Reference, GlassReflectsAsFresnelSays)
{
    auto scene = nothing();
    scene.sky.present = true;
    scene.sky.color = {0, 0, 0};
    scene.sky.zenith = vec3(1); // up is y, and what goes down is black
    addFloor(scene, {.name = "", .ior = 1.5});
    for (const auto& [degrees, Fr] : {std::pair(45.0, 0.05024), {60.0, 0.08919}, {75.0, 0.25306}})
    {
        const double angle = degrees / 180 * SkyFormulas<double>::PI, up = std::cos(angle);
        expectNear(mean(scene, {}, towards({0, up, 0}, {std::sin(angle), 0, 0}), 400000), Fr * up);
    }
}

/// Under a glass ball, at its focus: as bright as the lamp seen in the whole ball at most, and brighter than the open floor.
TEST(Reference, ACausticIsBrighterThanTheOpenFloor)
{
    auto scene = nothing();
    addFloor(scene, {});
    addSphere(scene, {0, 1.5, 0}, 1, {.name = "", .ior = 1.5});
    scene.lights.push_back({{0, 12, 0}, {144, 144, 144}});
    const Beyond beyond{.lightRadius = 1, .bounces = 1};
    const Mean focus = mean(scene, beyond, towards({1, 0.2, 0}, {0, 0, 0}), 20000);
    const double filledBall = 144 * (1 / 1.5) * (1 / 1.5), openFloor = 1;
    EXPECT_GT(focus.value, 10 * openFloor);
    EXPECT_LT(focus.value, filledBall);
    EXPECT_EQ(mean(scene, {.lightRadius = 1}, towards({1, 0.2, 0}, {0, 0, 0}), 1000).value, 0) << "as in lesson 08";
    EXPECT_NEAR(mean(scene, beyond, onto(30, 0), 20000).value, 144 * 12 / std::pow(144 + 900, 1.5), 0.02);
}

/// All light that the ball intercepts reaches the floor or goes up by reflection: nothing is counted twice.
TEST(Reference, ACausticHoldsNoMoreLightThanTheBallTookAway)
{
    auto scene = nothing();
    addFloor(scene, {});
    addSphere(scene, {0, 1.5, 0}, 1, {.name = "", .ior = 1.5});
    scene.lights.push_back({{0, 60, 0}, {3600, 3600, 3600}});
    // Rings of the floor, weighted with their area; without the ball each has 1 (nearly: the lamp is far).
    double withBall = 0, area = 0;
    const int rings = 60;
    for (int i = 0; i < rings; ++i)
    {
        const double width = 3.0 / rings, s = (i + 0.5) * width, ring = 2 * s * width;
        withBall +=
            ring * mean(scene, {.lightRadius = 6, .bounces = 1}, towards({s + 0.1, 0.02, 0}, {s, 0, 0}), 3000).value;
        area += ring;
    }
    EXPECT_GT(withBall, area - 0.35);
    EXPECT_LT(withBall, area + 0.02);
}

// ---- gloss ---------------------------------------------------------------------------------------------------------

TEST(Reference, ALobeReturnsAWhiteSkyWhole)
{
    auto scene = nothing();
    addSky(scene, {1, 1, 1});
    addFloor(scene, {.name = "", .color = {0.5, 0.5, 0.5}, .glossy = 0.4, .exponent = 5});
    expectNear(mean(scene, {.lobes = true}, onto(0, 0), 20000), 0.5 * 0.4);
    expectNear(mean(scene, {.bounces = 1, .lobes = true}, onto(0, 0), 20000), 0.5);
    EXPECT_EQ(mean(scene, {.lobes = false}, onto(0, 0), 100).value, 0) << "as in lesson 08";
    EXPECT_NEAR(mean(scene, {.bounces = 1}, onto(0, 0), 100).value, 0.5 * 0.6, 1e-12) << "the diffuse share";
}

TEST(Reference, ALobesMeanCosineBelongsToItsExponent)
{
    auto scene = nothing();
    scene.sky.present = true;
    scene.sky.zenith = vec3(1); // as bright as the direction's height
    for (const double alpha : {1.0, 2.0, 9.0})
    {
        addFloor(scene, {.name = "", .glossy = 1, .exponent = alpha});
        expectNear(mean(scene, {.lobes = true}, onto(0, 0), 100000), (alpha + 1) / (alpha + 2));
        scene.planes.clear();
    }
}

/// The lecture's (V.R)^alpha sends on 2 / (alpha + 1) of the light; a lobe sends on all of it.
TEST(Reference, ALobesHighlightIsTheLecturesOneNormalised)
{
    const double f = 0.7, alpha = 20, c = 50;
    auto scene = nothing();
    addFloor(scene, {.name = "", .glossy = f, .exponent = alpha});
    scene.lights.push_back({{3, 4, 0}, vec3(c)});
    const vec3 R = unit(vec3(3, 4, 0)), N(0, 1, 0), from = unit(vec3(-3, 5, 0.5));
    const vec3 mirrored(-from.x, from.y, -from.z);
    const double highlight = std::pow(dot(mirrored, R), alpha), share = c / 25;
    const auto ray = towards(from, {0, 0, 0});
    const Mean got = mean(scene, {.lightRadius = 0.2, .lobes = true}, ray, 300000);
    const double expected = share * (f * (alpha + 1) / 2 * highlight + (1 - f) * dot(N, R));
    EXPECT_NEAR(got.value, expected, 0.02 * expected + 4.5 * got.error);
    EXPECT_LT(got.error, 0.02 * expected);
    const Mean without = mean(scene, {.lightRadius = 1e-4}, ray, 1000);
    EXPECT_NEAR(without.value, share * (f * highlight + (1 - f) * dot(N, R)), 1e-4) << "without lobes, as on the slide";
}

TEST(Reference, AVeryNarrowLobeIsThePartialMirrorOfLesson03)
{
    auto scene = nothing();
    addSky(scene, {0.2, 0.2, 0.2});
    addFloor(scene, {.name = "", .color = {0.8, 0.8, 0.8}, .glossy = 0.3, .exponent = 1e10});
    addSphere(scene, {0, 1, -2}, 1, {});
    scene.lights.push_back({{4, 6, 3}, {40, 40, 40}});
    SceneDescription mirror = scene;
    mirror.materials[0] = {.name = "", .color = {0.8, 0.8, 0.8}, .mirror = 0.3};
    for (const auto& target : {vec3(0, 0, -0.5), vec3(0.5, 0, 0.3), vec3(3, 0, 2)})
    {
        const auto ray = towards({0, 2, 4}, target);
        const Scene<double> partial(mirror);
        const auto tree = lesson08::entry.inspect(mirror, Precision::doubled, GivenRay{ray.O, ray.D});
        expectNear(mean(scene, {.lightRadius = 1e-3, .lobes = true}, ray, 20000), tree.nodes[0].radiance.x);
    }
}

// ---- pictures ------------------------------------------------------------------------------------------------------

/// The limitation's own scene, small.
SceneDescription ownScene(const Limitation& limitation)
{
    SceneDescription scene = loadScene(projectFile(limitation.scene));
    scene.camera.width = 32;
    scene.camera.height = 24;
    return scene;
}

RenderOptions samples(int spp, int threads = 0)
{
    RenderOptions options;
    options.spp = spp;
    options.threads = threads;
    return options;
}

Image reference(const Limitation& limitation, const RenderOptions& options)
{
    return referencePicture(ownScene(limitation), limitation, limitation.lightRadius, options);
}

TEST(Pairs, AliasingWithOneSampleIsLesson08BitForBit)
{
    const auto& aliasing = *findLimitation("aliasing");
    const Image lesson = lesson08::entry.render(ownScene(aliasing), Precision::doubled, {});
    EXPECT_EQ(reference(aliasing, samples(1)).pixels, lesson.pixels);
    EXPECT_EQ(lessonPicture(ownScene(aliasing), aliasing, samples(64)).pixels, lesson.pixels);
    EXPECT_NE(reference(aliasing, samples(64)).pixels, lesson.pixels);
}

TEST(Pairs, HaveTheSameBitsForAnyNumberOfThreads)
{
    for (const auto& limitation : limitations())
    {
        const Image one = reference(limitation, samples(2, 1));
        EXPECT_EQ(one.pixels, reference(limitation, samples(2, 2)).pixels) << limitation.name;
        EXPECT_EQ(one.pixels, reference(limitation, samples(2, 5)).pixels) << limitation.name;
    }
}

TEST(Pairs, PixelsDoNotShareTheirNoise)
{
    auto scene = nothing();
    addFloor(scene, {});
    scene.sky.present = true;
    scene.sky.zenith = vec3(1);
    // All pixels see the same point: what differs is noise.
    scene.camera = {.eye = {0, 1, 0}, .target = {1, 0, 0}, .verticalFov = 1e-6, .width = 16, .height = 16};
    const Image image = referencePicture(scene, *findLimitation("indirect"), 1, samples(1));
    int alike = 0;
    for (int y = 0; y < 16; ++y)
        for (int x = 1; x < 16; ++x) alike += std::abs(image.at(x, y).x - image.at(x - 1, y).x) < 1e-4;
    EXPECT_LT(alike, 3);
}

TEST(Pairs, ShowADifferenceInTheirOwnScenes)
{
    const std::map<std::string, int> least = {
        {"shadows", 25}, {"indirect", 400}, {"caustic", 60}, {"glossy", 250}, {"aliasing", 150}};
    for (const auto& limitation : limitations())
    {
        const auto scene = ownScene(limitation);
        EXPECT_TRUE(missing(required(scene), lesson08::entry.models).empty()) << limitation.name;
        const Image left = lessonPicture(scene, limitation, samples(16)), right = reference(limitation, samples(16));
        int different = 0;
        for (std::size_t i = 0; i < left.pixels.size(); ++i)
        {
            EXPECT_TRUE(isFinite(right.pixels[i]));
            different += std::abs(left.pixels[i].x - right.pixels[i].x) > 0.02;
        }
        EXPECT_GE(different, least.at(limitation.name)) << limitation.name;
    }
}

TEST(Pairs, TintedShadowsDoNotCountLightTwice)
{
    const auto& caustic = *findLimitation("caustic");
    auto scene = ownScene(caustic);
    const Image block = referencePicture(scene, caustic, 1, samples(4));
    scene.trace.shadowThroughGlass = ShadowThroughGlass::tint;
    EXPECT_EQ(referencePicture(scene, caustic, 1, samples(4)).pixels, block.pixels);
}

TEST(Pairs, StandSideBySide)
{
    Image left(2, 1), right(3, 1);
    left.at(1, 0) = vec3(0.5);
    right.at(0, 0) = vec3(0.25);
    const Image both = sideBySide(left, right);
    ASSERT_EQ(both.width, 9);
    EXPECT_EQ(both.at(1, 0), vec3(0.5));
    EXPECT_EQ(both.at(2, 0), vec3(1));
    EXPECT_EQ(both.at(5, 0), vec3(1));
    EXPECT_EQ(both.at(6, 0), vec3(0.25));
}

TEST(Pairs, StopWhenAsked)
{
    const std::atomic<bool> stop = true;
    RenderOptions stopped = samples(1);
    stopped.stop = &stop;
    const Image image = reference(*findLimitation("indirect"), stopped);
    EXPECT_EQ(image.pixels, Image(32, 24).pixels);
}

TEST(Reference, FitsOnAPageAndNeedsOnlyTheLessonsHeader)
{
    const std::string text = readTextFile(projectFile("lessons/09_limitations/reference.h"));
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 150);
    std::vector<std::string> includes;
    for (std::size_t at = 0; (at = text.find("#include ", at)) != std::string::npos; ++at)
        includes.push_back(text.substr(at + 9, text.find('\n', at) - at - 9));
    EXPECT_EQ(includes, (std::vector<std::string>{"<random>", "\"common/scene/lesson.h\""}));
}

} // namespace

} // namespace rt::lesson09
