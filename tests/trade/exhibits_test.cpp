// Lesson 10's tracer with the good choices is lesson 08; each exhibit has its fault, and its cure removes it.
#include "lessons/10_speed_and_accuracy/study/exhibits.h"

#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/10_speed_and_accuracy/study/modelling.h"
#include "lessons/10_speed_and_accuracy/study/study.h"
#include "lessons/programs/entries.h"
#include "tests/common/random_scene.h"

namespace rt::lesson10
{

namespace
{

SceneDescription small(const std::string& file, int width = 64, int height = 48)
{
    return resized(loadScene(projectFile(file)), width, height);
}

constexpr std::pair<Scalar, Precision> types[] = {{Scalar::floating, Precision::floating},
                                                  {Scalar::doubled, Precision::doubled},
                                                  {Scalar::longDouble, Precision::longDouble}};

TEST(Lesson10, WithTheGoodChoicesHasTheBitsOfLesson08OnEveryShippedScene)
{
    for (const auto& file : shippedScenes())
        for (const auto& [scalar, precision] : types)
        {
            auto scene = small(file, 32, 24);
            const Setting setting{.scalar = scalar, .depth = scene.trace.maxDepth, .cutoff = scene.trace.cutoff};
            const auto mine = prepare(scene, setting)->render({});
            scene = withSetting(scene, setting);
            EXPECT_EQ(mine.pixels, lesson08::entry.render(scene, precision, {}).pixels)
                << file << ", " << name(precision);
        }
}

TEST(Lesson10, WithSchlickOrWithoutFresnelHasTheBitsOfLesson08)
{
    const auto scene = small("lessons/10_speed_and_accuracy/scenes/classic.toml");
    for (const auto glass : {GlassModel::schlick, GlassModel::none})
    {
        const Setting setting{.glass = glass, .depth = 5, .cutoff = 1e-2};
        EXPECT_EQ(prepare(scene, setting)->render({}).pixels,
                  lesson08::entry.render(withSetting(scene, setting), Precision::doubled, {}).pixels)
            << name(glass);
    }
}

TEST(Lesson10, ATimedPassHasTheBitsOfTheRenderedPicture)
{
    const auto scene = small("lessons/10_speed_and_accuracy/scenes/classic.toml");
    const std::atomic<bool> go = false;
    const auto subject = prepare(scene, {.spp = 3});
    const auto whole = subject->render({});
    EXPECT_EQ(subject->timedPass(1, go).image.pixels, whole.pixels);
    const auto some = subject->timedPass(5, go);
    ASSERT_EQ(some.image.height, 10);
    for (int x = 0; x < 64; ++x) EXPECT_EQ(some.image.at(x, 3), whole.at(x, 15));
}

TEST(Lesson10, ATinySceneLooksLikeTheClassicOneBitForBit)
{
    const auto classic = small("lessons/10_speed_and_accuracy/scenes/classic.toml");
    const auto tiny = small("lessons/10_speed_and_accuracy/scenes/tiny.toml");
    for (const auto scalar : {Scalar::floating, Scalar::doubled})
        EXPECT_EQ(prepare(classic, {.scalar = scalar, .cutoff = 0})->render({}).pixels,
                  prepare(tiny, {.scalar = scalar, .cutoff = 0})->render({}).pixels)
            << name(scalar);
}

TEST(Lesson10, EachExhibitShowsItsFaultAndItsCureRemovesIt)
{
    for (const auto& exhibit : exhibits())
    {
        const auto scene = small(exhibit.scene, 160, 120);
        const int pixels = 160 * 120, poor = countFault(scene, exhibit, exhibit.poorSetting);
        EXPECT_GT(poor, pixels / 100) << exhibit.name;
        // Outlines: in float a ray in a thousand may pass on the other side of an edge.
        const int allowed = exhibit.fault == Fault::wrongHit ? pixels / 1000 : 0;
        EXPECT_LE(countFault(scene, exhibit, exhibit.goodSetting), allowed) << exhibit.name;
    }
}

TEST(Lesson10, AnOffsetIsOnTheSideWhereTheRayGoes)
{
    // On the wrong side a transmitted ray would meet at once the surface that it has just passed.
    const auto scene = small("lessons/10_speed_and_accuracy/scenes/classic.toml");
    const std::atomic<bool> go = false;
    const Setting offset{.leaving = LeavingPolicy::normalOffset};
    const auto facts = prepare(scene, offset)->inspect(1, true, 1 << 20, go);
    for (const auto& pixel : *facts) EXPECT_EQ(pixel.acne, 0);
    EXPECT_GT(errorsAgainst(prepare(scene, offset)->render({}), prepare(scene, {})->render({})).psnr, 50);
}

TEST(Lesson10, PoorFormulasWithPoorLeavingPoliciesAreRefused)
{
    const auto scene = small("lessons/10_speed_and_accuracy/scenes/classic.toml");
    EXPECT_THROW(prepare(scene, {.sphere = SphereFormula::naive, .leaving = LeavingPolicy::fixedTMin}),
                 std::invalid_argument);
}

/// One ball of radius 1 at distance 5, in the direction -z, seen by one pixel.
SceneDescription oneBall(const Material<double>& material)
{
    SceneDescription scene;
    scene.camera.width = scene.camera.height = 1;
    scene.camera.verticalFov = 1;
    scene.materials.push_back(material);
    scene.spheres.push_back({{0, 0, -5}, 1, 0});
    return scene;
}

TEST(Inspector, CountsRaysAndShadowRays)
{
    auto scene = oneBall({.name = "m", .mirror = 0.5});
    scene.lights = {{{0, 9, 0}, {1, 1, 1}}, {{9, 0, 0}, {1, 1, 1}}};
    const std::atomic<bool> go = false;
    const auto facts = prepare(scene, {.cutoff = 0})->inspect(1, true, 1000, go);
    ASSERT_TRUE(facts);
    EXPECT_EQ(facts->at(0).rays, 1 + 2 + 1);
    EXPECT_EQ(facts->at(0).first, 0);
    EXPECT_EQ(facts->at(0).acne + facts->at(0).leaks, 0);
    EXPECT_EQ(prepare(scene, {.cutoff = 0, .spp = 3})->inspect(1, true, 1000, go)->at(0).rays, 12);
}

TEST(Inspector, GivesUpWhenThereAreTooManyRays)
{
    const auto scene = oneBall({.name = "glass", .ior = 1.5});
    const std::atomic<bool> go = false;
    EXPECT_FALSE(prepare(scene, {.depth = 64, .cutoff = 0})->inspect(1, false, 5, go));
    EXPECT_TRUE(prepare(scene, {.depth = 64, .cutoff = 0})->inspect(1, false, 5000, go));
}

TEST(Metrics, ErrorsOfKnownPictures)
{
    Image reference(2, 1), image(2, 1);
    reference.pixels = {{0.5, 0.5, 0.5}, {0, 0, 0}};
    image.pixels = {{0.5, 0.5, 0.6}, {0, 0, 0.003}};
    const auto errors = errorsAgainst(image, reference);
    EXPECT_NEAR(errors.maxAbsolute, 0.1, 1e-15);
    EXPECT_NEAR(errors.rms, std::sqrt((0.01 + 0.000009) / 6), 1e-15);
    EXPECT_NEAR(errors.psnr, -20 * std::log10(errors.rms), 1e-12);
    EXPECT_NEAR(errors.maxRelative, 0.003 * 255, 1e-12);
    EXPECT_EQ(errors.visible, 1);
    EXPECT_EQ(errors.nonFinite, 0);
    EXPECT_EQ(errorsAgainst(reference, reference).psnr, infinity<double>);
}

TEST(Metrics, APixelThatIsNotFiniteIsOffByOne)
{
    Image reference(1, 1), image(1, 1);
    image.pixels[0].x = std::numeric_limits<double>::quiet_NaN();
    const auto errors = errorsAgainst(image, reference);
    EXPECT_EQ(errors.nonFinite, 1);
    EXPECT_EQ(errors.psnr, 0);
}

} // namespace

} // namespace rt::lesson10
