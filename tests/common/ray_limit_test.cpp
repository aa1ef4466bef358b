#include "common/base/ray_limit.h"

#include <algorithm>
#include <thread>

#include <gtest/gtest.h>

#include "common/program/lesson_entry.h"
#include "common/tree/tree_growth.h"
#include "lessons/08_phong/trace.h"
#include "lessons/programs/registry.h"

namespace rt
{

namespace
{

using Recorded = lesson08::Tracer<double, TreeRecorder<double>>;

/// Panes of glass that face each other, and a floor with lamps: a tree that doubles at each depth, with shadow rays that are
/// blocked and others that are not.
SceneDescription panes(int count, int depth)
{
    SceneDescription scene;
    scene.file = "panes.toml";
    scene.materials = {{.name = "glass", .ior = 1.5}, {.name = "matt"}};
    for (int i = 0; i < count; ++i)
        scene.planes.push_back({.point = {0, 0, -1.0 - i}, .normal = {0, 0, 1}, .material = 0});
    scene.planes.push_back({.point = {0, 0, -100}, .normal = {0, 0, 1}, .material = 1});
    scene.lights = {{.position = {0, 1, -99}, .color = {1, 1, 1}}, {.position = {0, 1, 5}, .color = {1, 1, 1}}};
    scene.camera.eye = {0, 0, 0};
    scene.camera.target = {0, 0, -1};
    scene.camera.width = scene.camera.height = 1;
    scene.trace.maxDepth = depth;
    return scene;
}

GivenRay ahead()
{
    return {{0, 0, 0}, {0, 0, -1}};
}

std::string messageOf(const std::function<void()>& work)
{
    try
    {
        work();
    }
    catch (const TooManyRays& error)
    {
        return error.what();
    }
    return "it was traced";
}

/// The fewest rays with which it is traced.
template <class Trace>
std::int64_t raysOf(const Trace& trace)
{
    for (std::int64_t most = 1;; ++most)
    {
        const TraceLimit limit(nullptr, most);
        if (messageOf([&] { beginCameraRay(), trace(); }) == "it was traced") return most;
    }
}

TEST(RayLimit, PictureAndTreeEndAtTheSameRay)
{
    for (const auto atCap : {AtCap::black, AtCap::direct})
    {
        auto description = panes(6, 8);
        description.trace.atCap = atCap;
        const Scene<double> scene(description);
        RayTree tree;
        tree.maxDepth = description.trace.maxDepth;
        const auto ray = detail::probeRay(scene, ahead());
        Recorded(scene, TreeRecorder<double>(tree, scene)).trace(ray);
        const auto all = std::int64_t(tree.nodes.size() + tree.shadows.size());
        ASSERT_GT(all, 64 + 1); // more than a slice
        const auto isBlocked = [](const auto& shadow) { return !shadow.visible; };
        const auto blocked = std::count_if(tree.shadows.begin(), tree.shadows.end(), isBlocked);
        EXPECT_TRUE(blocked > 0 && blocked < std::ptrdiff_t(tree.shadows.size()));
        const auto inTree = raysOf([&] {
            RayTree again;
            Recorded(scene, TreeRecorder<double>(again, scene)).trace(ray);
        });
        // What is asked for at the cap, and meets nothing, is no node.
        EXPECT_TRUE(atCap == AtCap::black ? inTree == all : inTree > all) << inTree << " and " << all;
        EXPECT_EQ(raysOf([&] { lesson08::Tracer<double>{scene}.trace(ray); }), inTree);
        // A picture looks ahead for its camera rays.
        EXPECT_EQ(raysOf([&] {
                      TileRays<double> rays(scene, 0, 1, 1, true);
                      lesson08::Tracer<double>{scene}.trace(rays(0, 0, 0));
                  }),
                  inTree);
    }
}

TEST(RayLimit, EachCameraRayHasItsOwn)
{
    const Scene<double> scene(panes(6, 8)); // several slices
    const auto ray = detail::probeRay(scene, ahead());
    const auto once = [&] { lesson08::Tracer<double>{scene}.trace(ray); };
    const TraceLimit limit(nullptr, raysOf(once));
    for (int i = 0; i < 20; ++i)
    {
        beginCameraRay();
        EXPECT_NO_THROW(once());
    }
    EXPECT_THROW(once(), TooManyRays);
    EXPECT_THROW(once(), TooManyRays) << "whoever catches it does not get more";
}

TEST(RayLimit, ATreeTooLargeEndsWithASentenceInEachPrecision)
{
    const auto scene = panes(6, 64);
    const auto& lesson = *findLesson(6);
    const std::string pixel = "pixel 0,0 leads to more than 1,000,000 rays at depth 64, which is";
    const std::string ray = "the ray leads to more than 1,000,000 rays at depth 64, which is";
    for (const auto precision : {Precision::floating, Precision::doubled, Precision::longDouble})
        EXPECT_EQ(messageOf([&] { lesson.render(scene, precision, {}); }).substr(0, pixel.size()), pixel);
    const auto inspect = [&](const Probe& probe) {
        return messageOf([&] { lesson.inspect(scene, Precision::doubled, probe); });
    };
    EXPECT_EQ(inspect(std::array{0, 0}).substr(0, pixel.size()), pixel);
    EXPECT_EQ(inspect(ahead()).substr(0, ray.size()), ray);
}

/// Its first pixel is too large, once another tile is under way; all others take their time.
struct Slow
{
    static inline std::atomic<int> others = 0;

    const Scene<double>& scene;

    Vec3<double> trace(const Ray<double>& ray) const
    {
        using std::chrono::milliseconds;
        if (ray.D.x > 0 || ray.D.y < 0) // not in the first tile
        {
            ++others;
            std::this_thread::sleep_for(milliseconds(2));
            return Vec3<double>(0);
        }
        for (int i = 0; i < 1000 && !others; ++i) std::this_thread::sleep_for(milliseconds(1));
        throw TooManyRays();
    }
};

TEST(RayLimit, APixelTooLargeEndsTheTilesThatAreUnderWay)
{
    const Scene<double> scene(panes(0, 0));
    EXPECT_EQ(messageOf([&] { render<Slow>(scene, 2 * tileSide, 2 * tileSide, {.threads = 2}); }).substr(0, 9),
              "pixel 0,0");
    EXPECT_LT(Slow::others, tileSide * tileSide);
}

/// When what is traced has begun, unless the machine is very busy.
std::jthread stopSoon(std::atomic<bool>& stop)
{
    return std::jthread([&stop] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        stop = true;
    });
}

TEST(RayLimit, AStopIsSeenInsideOneTree)
{
    const Scene<double> scene(panes(6, 1024));
    const auto ray = detail::probeRay(scene, ahead());
    std::atomic<bool> stop = false;
    std::jthread stopping = stopSoon(stop);
    const TraceLimit limit(&stop, std::numeric_limits<std::int64_t>::max()); // a tree without end
    RayTree tree;
    EXPECT_THROW(lesson08::Tracer<double>{scene}.trace(ray), Stopped);
    EXPECT_THROW(findLesson(8)->inspect(panes(6, 64), Precision::doubled, ahead(), &stop), Stopped);
}

TEST(RayLimit, AStoppedPictureReturns)
{
    // Each sample has so many rays that a pixel would take an hour.
    std::atomic<bool> stop = false;
    auto scene = panes(6, 20);
    const auto rays = findLesson(8)->inspect(scene, Precision::doubled, ahead()).nodes.size();
    EXPECT_TRUE(rays > 10'000 && rays < std::size_t(rayLimit)) << rays;
    scene.camera.width = 64;
    std::jthread stopping = stopSoon(stop);
    findLesson(8)->render(scene, Precision::doubled, {.spp = 65536, .stop = &stop});
}

TEST(Cutoff, AboveAllLightIsForetold)
{
    const auto warning = [](double cutoff, int lesson) {
        auto scene = panes(2, 4);
        scene.trace.cutoff = cutoff;
        return cutoffWarning(scene, findLesson(lesson)->models);
    };
    const double brightest = Scene<double>([] {
                                 auto scene = panes(2, 4);
                                 scene.trace.cutoff = 1;
                                 return scene;
                             }())
                                 .brightest;
    EXPECT_EQ(warning(brightest, 8), "");
    EXPECT_EQ(warning(0, 8), "");
    EXPECT_EQ(warning(1e300, 6), "") << "knows no cutoff";
    const auto said = warning(1e300, 7);
    EXPECT_EQ(said.substr(0, 63), "cutoff = 1e+300 is more than any ray can bring, which is at mos") << said;
    EXPECT_NE(said.find(": no ray is traced"), said.npos);
    auto dark = panes(2, 4);
    dark.lights.clear();
    dark.trace.cutoff = 1;
    EXPECT_EQ(cutoffWarning(dark, findLesson(8)->models), "") << "black in any case";
}

TEST(TreeGrowth, IsForetoldWhereATreeCanExceedTheLimit)
{
    const auto lesson = [](int number) { return findLesson(number)->models; };
    EXPECT_EQ(
        growthWarning(panes(6, 300), lesson(6)),
        "panes.toml: at depth 300 a pixel can lead to 2^300 rays, since glass splits each in two; one that leads to "
        "more than 1,000,000 is refused");
    EXPECT_NE(growthWarning(panes(2, 19), lesson(8)), "");
    EXPECT_NE(growthWarning(panes(2, 18), lesson(8)), "") << "with the shadow rays of two lamps";
    EXPECT_EQ(growthWarning(panes(2, 17), lesson(8)), "");
    auto dark = panes(2, 18);
    dark.lights.clear();
    EXPECT_EQ(growthWarning(dark, lesson(8)), "");
    // What splits no ray, or only once.
    EXPECT_EQ(growthWarning(panes(6, 300), lesson(5)), "");
    EXPECT_EQ(growthWarning(panes(1, 300), lesson(8)), "");
    EXPECT_EQ(growthWarning(panes(0, 300), lesson(8)), "");
    auto scene = panes(6, 300);
    scene.trace.fresnel = FresnelModel::none;
    EXPECT_EQ(growthWarning(scene, lesson(8)), "");
    scene = panes(6, 300);
    scene.materials[0].iorOutside = scene.materials[0].ior;
    EXPECT_EQ(growthWarning(scene, lesson(8)), "");
    scene = panes(6, 300);
    scene.trace.cutoff = 0.001;
    EXPECT_EQ(growthWarning(scene, lesson(8)), "");
    EXPECT_NE(growthWarning(scene, lesson(6)), "") << "which knows no cutoff";
    // One pane and a mirror that sends its light back.
    scene = panes(1, 300);
    scene.materials[1].mirror = 0.5;
    EXPECT_NE(growthWarning(scene, lesson(8)), "");
    // One mesh may face itself.
    scene = panes(0, 300);
    scene.meshes.emplace_back();
    EXPECT_NE(growthWarning(scene, lesson(8)), "");
}

} // namespace

} // namespace rt
