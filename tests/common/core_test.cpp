// The core's promises: vectors, shapes, the camera, and Scene's two questions, in every precision.
#include <random>

#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/scene/features.h"
#include "common/scene/scene.h"
#include "lessons/programs/registry.h"
#include "tests/common/random_scene.h"
#include "tests/common/scaled_scene.h"

namespace rt
{

namespace
{

template <class Real>
class Core : public testing::Test
{
};
using Precisions = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(Core, Precisions);

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

TYPED_TEST(Core, UnitHasLengthOneAtEveryScale)
{
    using Real = TypeParam;
    using V = Vec3<Real>;
    const Real huge = std::numeric_limits<Real>::max() / 4, tiny = std::numeric_limits<Real>::min();
    for (const V& v : {V(1, 2, 3), V(huge, huge, -huge), V(tiny, 0, tiny), V(tiny / 4, tiny / 2, 0), V(0, 0, huge)})
        EXPECT_NEAR(double(length(unit(v))), 1, double(4 * eps<Real>)) << double(v.x);
    EXPECT_EQ(unit(V(0, 0, 49)), V(0, 0, 1)) << "an axis stays exact";
    EXPECT_EQ(unit(V(0)), V(0));
}

TYPED_TEST(Core, APictureMovesNotABitWhenTheSceneIsScaledByAPowerOfTwo)
{
    using Real = TypeParam;
    const std::vector<Feature> models = lessons().back()->models;
    int lit = 0;
    for (const int power : {-30, -10, 10, 30})
        for (unsigned seed = 0; seed < 6; ++seed)
        {
            const auto scene = randomScene(seed, models);
            constexpr Precision precision = std::is_same_v<Real, float>    ? Precision::floating
                                            : std::is_same_v<Real, double> ? Precision::doubled
                                                                           : Precision::longDouble;
            const Image a = lessons().back()->render(scene, precision, {}),
                        b = lessons().back()->render(scaled(scene, std::ldexp(1.0, power)), precision, {});
            EXPECT_EQ(a.pixels, b.pixels) << "scaled by 2^" << power << ", seed " << seed;
            for (const auto& pixel : a.pixels) lit += pixel != Vec3<double>(0);
        }
    EXPECT_GT(lit, 5000);
}

TYPED_TEST(Core, ARayNeverMeetsWhatItLeaves)
{
    using Real = TypeParam;
    std::mt19937 engine(7);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    int outwards = 0, inwards = 0;
    for (int i = 0; i < 300; ++i)
    {
        SceneDescription description;
        description.materials.push_back({});
        const double scale = std::pow(10.0, in(-8, 8)), r = std::pow(10.0, in(-2, 2)) * scale;
        const Vec3<double> center(in(-9, 9) * scale, in(-9, 9) * scale, in(-9, 9) * scale);
        description.spheres.push_back({center, r, 0});
        const Scene<Real> scene(description);
        const Vec3<double> away(in(-1, 1), in(-1, 1), in(-1, 1) + 1.5);
        const Ray<Real> ray{.O = Vec3<Real>(center + 3 * r * glm::normalize(away)),
                            .D = unit(Vec3<Real>(-away + Vec3<double>(in(-0.2, 0.2))))};
        const auto hit = scene.intersect(ray);
        if (!hit) continue;
        for (int k = 0; k < 100; ++k)
        {
            const Vec3<Real> D = unit(Vec3<Real>(Real(in(-1, 1)), Real(in(-1, 1)), Real(in(-1, 1))));
            const auto next = scene.intersect(ray.spawn(reflected, hit->I, D));
            const Real inward = dot(D, Vec3<Real>(hit->I) - scene.spheres[0].C);
            if (inward >= 0)
            {
                EXPECT_FALSE(next) << "leaving the sphere, it was met again at t = " << double(next->t)
                                   << ", r = " << r;
                ++outwards;
            }
            else
            {
                ASSERT_TRUE(next) << "going in, the far side was lost; r = " << r;
                EXPECT_TRUE(next->inside);
                ++inwards;
            }
        }
    }
    EXPECT_GT(outwards, 5000);
    EXPECT_GT(inwards, 5000);
}

TYPED_TEST(Core, AHitPointLiesOnItsSphere)
{
    using Real = TypeParam;
    SceneDescription description;
    description.materials.push_back({});
    description.spheres.push_back({{0, 0, 0}, 1, 0});
    const Scene<Real> scene(description);
    for (const double distance : {2.0, 1e3, 1e6, 1e9})
    {
        const Vec3<Real> O(Real(0.3), Real(0.4), Real(distance));
        const auto hit = scene.intersect({.O = O, .D = {0, 0, -1}});
        ASSERT_TRUE(hit) << distance;
        EXPECT_NEAR(double(length(Vec3<Real>(hit->I))), 1, double(4 * eps<Real>)) << distance;
    }
}

TYPED_TEST(Core, TheNormalFacesTheRayAndTheMediaFollow)
{
    using Real = TypeParam;
    const Scene<Real> scene(parseScene(
        "[materials.g]\nior = 1.5\nior_outside = 1.25\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = 'g'\n",
        "g"));
    const auto in = scene.intersect({.O = {0, 0, 3}, .D = {0, 0, -1}});
    const auto out = scene.intersect({.O = {0, 0, 0}, .D = {0, 0, -1}});
    ASSERT_TRUE(in && out);
    EXPECT_FALSE(in->inside);
    EXPECT_TRUE(out->inside);
    EXPECT_EQ(in->N, Vec3<Real>(0, 0, 1));
    EXPECT_EQ(out->N, Vec3<Real>(0, 0, 1));
    EXPECT_EQ(out->outwardNormal(), Vec3<Real>(0, 0, -1));
    EXPECT_EQ(in->n1, Real(1.25));
    EXPECT_EQ(in->n2, Real(1.5));
    EXPECT_EQ(out->n1, Real(1.5));
    EXPECT_EQ(out->n2, Real(1.25));
}

TYPED_TEST(Core, NoRaySlipsBetweenTrianglesThatShareAnEdge)
{
    using Real = TypeParam;
    SceneDescription description;
    description.materials.push_back({});
    const Vec3<double> a(-1.1, 0.3, -2), b(1.7, -0.2, -2.5), c(0.1, 1.9, -3), d(0.3, -2.1, -2.2);
    description.triangles.push_back({{a, b, c}, 0});
    description.triangles.push_back({{b, a, d}, 0});
    const Scene<Real> scene(description);
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> share(0.001, 0.999);
    for (int i = 0; i < 20000; ++i)
    {
        const double s = share(engine);
        const Vec3<Real> target(a + s * (b - a)); // a point of the shared edge, rounded
        EXPECT_TRUE(scene.intersect({.O = {0, 0, 0}, .D = unit(target)})) << s;
    }
}

TYPED_TEST(Core, TheNearestHitWinsAndEqualOnesGoToTheFirst)
{
    using Real = TypeParam;
    SceneDescription description;
    description.materials.push_back({});
    description.spheres = {{{0, 0, -5}, 1, 0}, {{0, 0, -5}, 1, 0}, {{0, 0, -3}, 0.5, 0}};
    const Scene<Real> scene(description);
    EXPECT_EQ(scene.primitiveName(scene.intersect({.D = {0, 0, -1}})->I.on), "sphere2");
    description.spheres.pop_back();
    EXPECT_EQ(Scene<Real>(description).intersect({.D = {0, 0, -1}})->I.on, 0);
}

TYPED_TEST(Core, OccludedAsksTheOpenSegmentOnly)
{
    using Real = TypeParam;
    SceneDescription description;
    description.materials.push_back({});
    description.spheres.push_back({{0, 0, -5}, 1, 0});
    const Scene<Real> scene(description);
    const Point<Real> I{Vec3<Real>(0, 0, 0), noPrimitive};
    EXPECT_FALSE(scene.occluded(I, {0, 0, -1}, Real(3.5)));
    EXPECT_FALSE(scene.occluded(I, {0, 0, -1}, Real(4))) << "a light on the surface itself is visible";
    EXPECT_TRUE(scene.occluded(I, {0, 0, -1}, Real(4.5)));
    EXPECT_FALSE(scene.occluded(I, {0, 0, 1}, Real(100)));
}

TYPED_TEST(Core, TheCameraLooksThroughPixelCentres)
{
    using Real = TypeParam;
    CameraDescription description;
    description.eye = {1, 2, 3};
    description.target = {1, 2, -7};
    description.verticalFov = 90;
    description.width = 4;
    description.height = 2;
    const Camera<Real> camera(description);
    const auto near = [](const Vec3<Real>& got, const Vec3<double>& expected) {
        const Vec3<double> wanted = glm::normalize(expected);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(got[c]), wanted[c], double(4 * eps<Real>));
    };
    near(camera.ray(2, 1).D, {0, 0, -1});
    near(camera.ray(Real(0.5), Real(0.5)).D, {-1.5, 0.5, -1}); // the top left pixel
    near(camera.ray(Real(3.5), Real(1.5)).D, {1.5, -0.5, -1});
    EXPECT_EQ(camera.ray(0, 0).O, Vec3<Real>(1, 2, 3));
}

TEST(Features, AreRequiredByWhatIsUsed)
{
    const auto scene = parseScene(R"(
[materials.unused]
ior = 1.5
[materials.half]
mirror = 0.5
[materials.floor]
[[plane]]
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
[[light]]
position = [0, 1, 0]
color = [1, 1, 1]
)",
                                  "s");
    ASSERT_EQ(required(scene).size(), 1U);
    EXPECT_EQ(required(scene)[0].feature, Feature::direct);
    auto used = scene;
    used.planes[0].material = 1;
    ASSERT_EQ(required(used).size(), 2U);
    EXPECT_EQ(required(used)[1].feature, Feature::partial);
    EXPECT_EQ(required(used)[1].because, "material 'half' is a partial mirror (mirror = 0.5)");
    EXPECT_EQ(missing(required(used), {Feature::direct}).size(), 1U);
}

TEST(Features, TheSmallestSufficientLessonGivesThePictureOfTheLast)
{
    for (const auto* lesson : lessons())
    {
        const auto scene = loadScene(std::string(RAYTREE_SOURCE_DIR) + "/" + lesson->scene);
        ASSERT_EQ(smallestLesson(scene), lesson) << lesson->scene;
        auto small = scene;
        small.camera.width = 64;
        small.camera.height = 48;
        EXPECT_EQ(lesson->render(small, Precision::doubled, {}).pixels,
                  lessons().back()->render(small, Precision::doubled, {}).pixels);
    }
}

} // namespace

} // namespace rt
