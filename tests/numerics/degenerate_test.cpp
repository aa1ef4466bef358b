// Random scenes in which everything coincides that can: no pixel is negative, NaN or infinite, nothing crashes or hangs.
// RAYTREE_DEGENERATE_SCENES sets how many are tried in each precision.
#include <cstdlib>

#include "common/files/obj_file.h"
#include "tests/numerics/extremes.h"

namespace rt::numerics
{

namespace
{

template <class Real>
class Degenerate : public testing::Test
{
};
TYPED_TEST_SUITE(Degenerate, Precisions);

/// All points, radii and directions come from a few; so spheres touch or are the same, cameras sit on surfaces and in
/// lamps, triangles are slivers, and planes meet in the point that is looked at. Whatever a scene file may say, and no more.
SceneDescription degenerateScene(unsigned seed)
{
    Random random(seed);
    const double scale = std::ldexp(1.0, random.below(41) - 20);
    const V base = random.chance(0.2) ? random.vector(-1, 1) * scale * 1000.0 : V(0);
    std::vector<V> points{V(0), scale * V(1, 0, 0), scale * V(0, 1, 0), scale * V(0, 0, 1), scale * V(1, 1, 1)};
    for (int i = 0; i < 3; ++i) points.push_back(scale * random.vector(-2, 2));
    points.push_back(points.back() + scale * random.power10(-18, -3) * random.direction());
    for (V& point : points) point += base;

    const auto point = [&] { return points[std::size_t(random.below(int(points.size())))]; };
    const auto length = [&] {
        const double d = glm::length(point() - point());
        const double lengths[] = {scale, scale / 2, scale * 2, scale * 0x1p-20, scale * 0x1p20, scale * (1 - 4e-5)};
        return random.chance(0.5) && d > 0 ? d : lengths[random.below(6)];
    };
    const auto direction = [&] {
        const V along = point() - point();
        return random.chance(0.5) && along != V(0) ? along : V(random.below(3) - 1, random.below(2), 1);
    };
    const auto pick = [&](std::initializer_list<double> values) {
        return values.begin()[random.below(int(values.size()))];
    };

    SceneDescription scene;
    for (int i = 0; i < 4; ++i)
    {
        Material<double> mat{.name = "m", .color = V(pick({0, 0.5, 1}), pick({1, 0x1p-30}), pick({0.7, 1}))};
        if (random.chance(0.5))
        {
            mat.ior = pick({1, 1.5, 1 / 1.5, 1 + 0x1p-23, 1e-3, 1e3, 2.4});
            mat.iorOutside = pick({1, 1, 1.5, 1e3});
        }
        else
        {
            mat.mirror = pick({0, 0, 0.5, 1});
            mat.glossy = pick({0, 0.5, 1});
            mat.exponent = pick({0, 1, 50, 0x1p20, 1e30});
        }
        scene.materials.push_back(mat);
    }
    for (int i = random.below(5); i > 0; --i) scene.spheres.push_back({point(), length(), random.below(4)});
    for (int i = random.below(3); i > 0; --i)
        scene.planes.push_back({.point = point(),
                                .normal = direction(),
                                .material = random.below(4),
                                .hasChecker = random.chance(0.3),
                                .checkerSize = length()});
    for (int i = random.below(4); i > 0; --i)
        if (const std::array<V, 3> vertices{point(), point(), point()}; !isDegenerate(vertices))
            scene.triangles.push_back({vertices, random.below(4)});
    for (int i = random.below(3); i > 0; --i)
        scene.lights.push_back({point(), scale * scale * pick({0, 1, 1e5}) * V(1, 0.5, 1)});

    auto& trace = scene.trace;
    trace.maxDepth = random.below(6);
    trace.cutoff = pick({0, 0, 1e-3, 1});
    trace.atCap = AtCap(random.below(3));
    trace.fresnel = FresnelModel(random.below(3));
    trace.shadowThroughGlass = ShadowThroughGlass(random.below(2));
    scene.sky.present = random.chance(0.8);
    if (scene.sky.present) scene.sky.color = V(pick({0, 1, 1e5}), 1, 0.5);
    if (random.chance(0.3)) scene.sky.zenith = V(1, 0, 2);
    if (random.chance(0.3)) scene.sky.sun = Sun{direction(), V(100), pick({1e-9, 5, 180})};

    scene.camera = {.eye = point(), .verticalFov = pick({1e-9, 40, 179.999}), .width = 3, .height = 3};
    do scene.camera.target = random.chance(0.7) ? point() : scene.camera.eye + direction();
    while (scene.camera.target == scene.camera.eye);
    const V forward = glm::normalize(scene.camera.target - scene.camera.eye);
    scene.camera.up = std::abs(forward.y) < 0.9 ? V(0, 1, 0) : V(1, 0, 0);
    return scene;
}

int scenesToTry()
{
    const char* wanted = std::getenv("RAYTREE_DEGENERATE_SCENES");
    return wanted ? std::atoi(wanted) : 100000;
}

TYPED_TEST(Degenerate, ScenesGiveFinitePictures)
{
    using Real = TypeParam;
    const int scenes = scenesToTry();
    int failed = 0;
    long lit = 0;
    for (int seed = 0; seed < scenes && failed < 5; ++seed)
    {
        const Scene<Real> scene(degenerateScene(unsigned(seed)));
        lesson08::Tracer<Real> tracer{scene};
        // The middle pixel looks straight at the target, the others past it.
        for (const int pixel : {4, 0, 5, 7})
        {
            const auto color = renderPixel(scene, tracer, pixel % 3, pixel / 3, 1);
            const bool good = isFinite(color) && std::min({color.x, color.y, color.z}) >= 0;
            EXPECT_TRUE(good) << "scene " << seed << ", pixel " << pixel << ": " << cases::text(V(color));
            failed += !good;
            lit += color.x > 0;
        }
    }
    EXPECT_GT(lit, scenes) << "most of what was seen was black: the scenes are no test";
}

TYPED_TEST(Degenerate, ScenesFollowNoMoreRaysThanTheirTreesMayHave)
{
    using Real = TypeParam;
    for (unsigned seed = 0; seed < 2000; ++seed)
    {
        const Scene<Real> scene(degenerateScene(seed));
        const std::size_t full = std::size_t(2) << scene.settings.maxDepth; // nodes of a full binary tree, and one
        const std::size_t most = scene.settings.atCap == AtCap::direct ? 2 * full : full;
        EXPECT_LT(pathOf(scene, scene.camera.ray(Real(1.5), Real(1.5))).size(), most) << seed;
    }
}

} // namespace

} // namespace rt::numerics
