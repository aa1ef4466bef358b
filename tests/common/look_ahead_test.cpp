// What is found before a lesson asks is what it would find, bit for bit.
#include "common/scene/pixel.h"
#include "tests/common/random_world.h"

namespace rt
{

namespace
{

template <class Real>
class LookAhead : public testing::Test
{
};
using Precisions = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(LookAhead, Precisions);

/// By the instructions of this processor and by the baseline's. Some scenes have planes, and nothing else.
TYPED_TEST(LookAhead, FindsWhatIntersectFinds)
{
    using Real = TypeParam;
    if (!looksAhead<Real>)
    {
        EXPECT_FALSE(Scene<Real>(SceneDescription{}).wantsLookAhead());
        return;
    }
    int hits = 0, misses = 0;
    for (int w = 0; w < 200; ++w)
    {
        World world(unsigned(w + 1));
        const double power = w % 4 == 0 ? 5 : 0;
        world.spheres(w % 17, power);
        for (int i = 0; i < w % 3; ++i) // coincident ones, too
            world.scene.planes.push_back({.point = {0, -1, 0}, .normal = i ? Vec3<double>(0, 1, 0) : world.vector(1)});
        Scene<Real> scene(world.scene);
        ASSERT_TRUE(scene.wantsLookAhead());
        for (const auto set : {Instructions::baseline, bestInstructions()})
        {
            scene.instructions = set;
            Ahead<Real> rays[64];
            for (auto& ahead : rays)
            {
                const auto ray = world.ray(scene, power);
                ahead.O = ray.O;
                ahead.D = ray.D;
                if (world.below(8) == 0) ahead.O[world.below(3)] = infinity<Real>;
                if (world.below(8) == 0) ahead.D[world.below(3)] = std::numeric_limits<Real>::quiet_NaN();
            }
            scene.lookAhead(rays, 64);
            for (const auto& ahead : rays)
            {
                const auto hit = scene.intersect({.O = ahead.O, .D = ahead.D});
                ASSERT_EQ(bool(hit), bool(ahead.hit));
                ++(hit ? hits : misses);
                if (hit && hit->t < infinity<Real>) expectSame(*hit, *ahead.hit);
            }
        }
    }
    EXPECT_GT(hits, 5000);
    EXPECT_GT(misses, 5000);
}

TEST(LookAheadOf, OneRayIsForgottenForAnotherRay)
{
    SceneDescription description;
    description.materials.push_back({});
    description.spheres.push_back({{0, 0, -5}, 1, 0});
    const Scene<double> scene(description);
    Ahead<double> rays[4];
    for (auto& ahead : rays) ahead.D = {0, 0, -1};
    scene.lookAhead(rays, 4);
    ASSERT_TRUE(rays[0].hit);
    rays[0].hit->t = 77; // to see who answers
    Ray<double> ray{.D = {0, 0, -1}, .ahead = rays};
    EXPECT_EQ(scene.intersect(ray)->t, 77);
    ray.D.x = -0.0;
    EXPECT_EQ(scene.intersect(ray)->t, 4);
    ray = {.O = {0, 0.5, 0}, .D = {0, 0, -1}, .ahead = rays};
    EXPECT_LT(scene.intersect(ray)->t, 5);
    EXPECT_EQ(ray.spawn(reflected, rays[0].hit->I, {0, 0, -1}).ahead, nullptr);
}

/// Sees where its rays arrive; some pixels are given up half-way.
struct Sight
{
    const Scene<double>& scene;
    int calls = 0;

    Vec3<double> trace(const Ray<double>& ray)
    {
        if (ray.D.x > 0.2 && ray.D.y < -0.1 && ++calls % 3 == 2 && calls > 0) throw NotAttempted("x");
        const auto hit = scene.intersect(ray);
        return hit ? Vec3<double>(hit->I) + 3.0 : ray.D;
    }
};

TEST(LookAheadOf, ATileLeavesPixelsAsTheyAre)
{
    World world(3);
    world.spheres(16, 0);
    world.scene.planes.push_back({.point = {0, -1, 0}, .normal = {0, 1, 0}});
    world.scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 0}, .width = 75, .height = 41};
    const Scene<double> scene(world.scene);
    ASSERT_TRUE(scene.wantsLookAhead());
    for (const int spp : {1, 3, 7})
    {
        Image image(75, 41);
        for (int tile = 0; tile < tilesOf(image); ++tile) renderTile<Sight>(image, tile, scene, spp);
        int same = 0, givenUp = 0;
        for (int y = 0; y < 41; ++y)
            for (int x = 0; x < 75; ++x)
            {
                Sight sight{scene, -1000000000};
                if (image.at(x, y) == magenta)
                    ++givenUp;
                else if (image.at(x, y) == renderPixel(scene, sight, x, y, spp))
                    ++same;
            }
        EXPECT_EQ(same + givenUp, 75 * 41) << spp;
        EXPECT_GT(givenUp, 20);
        EXPECT_GT(same, 1000);
    }
}

} // namespace

} // namespace rt
