// Large against small: far cameras, planets, specks, thin shells, scenes far from the origin. Where float has a horizon,
// the horizon is what is asserted.
#include <numbers>

#include "tests/numerics/extremes.h"

namespace rt::numerics
{

namespace
{

template <class Real>
class FarAndSmall : public testing::Test
{
};
TYPED_TEST_SUITE(FarAndSmall, Precisions);

/// How many pixels of a differ from b by more than `allowed`, relative to b or, where that is dark, to b's mean.
int different(const Image& a, const Image& b, double allowed)
{
    double mean = 0;
    for (const auto& pixel : b.pixels) mean += largestChannel(pixel) / double(b.pixels.size());
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        count +=
            !(largestChannel(abs(a.pixels[i] - b.pixels[i])) <= allowed * std::max(mean, largestChannel(b.pixels[i])));
    return count;
}

TYPED_TEST(FarAndSmall, ACameraMayBeAsFarAwayAsItsDirectionsCanTell)
{
    using Real = TypeParam;
    // The picture is the same from everywhere, but for perspective; a direction is known to eps, so at D radii the
    // picture is known to eps * D radii. Float's horizon is at 10^4: of this picture's 1024 pixels, 0 are more than 1/255
    // off from 3000 radii, 64 from 30000, 364 from 300000. Double's is not reached: 0 from 3e9.
    for (int decade = 1; decade <= 9; ++decade)
    {
        const double away = std::pow(10.0, decade) * 3;
        auto scene = Build().material(grey(0.8)).sphere({0, 0, 0}, 1).light({4, 6, 5}, 60).scene;
        scene.camera = {.eye = V(1, 2, 2) / 3.0 * away,
                        .target = {0, 0, 0},
                        .verticalFov = 2 * std::atan(1.25 / away) / 3.14159265358979323846 * 180,
                        .width = 32,
                        .height = 32};
        const Image got = pictureOf<Real>(scene), reference = pictureOf<long double>(scene);
        for (const auto& pixel : got.pixels) ASSERT_TRUE(isFinite(pixel));
        const double allowed = 16 * double(eps<Real>) * away;
        note("from 3e" + std::to_string(decade) + ", more than 1/255 off", different(got, reference, 1 / 255.0));
        note("from 3e" + std::to_string(decade) + ", more than allowed", different(got, reference, allowed));
        if (allowed > 0.2) continue; // beyond the horizon
        // A pixel at the ball's rim may fall on its other side.
        EXPECT_LE(different(got, reference, allowed), 10) << "from " << away;
    }
}

TYPED_TEST(FarAndSmall, EyeAndTargetMayRoundToTheSamePoint)
{
    using Real = TypeParam;
    CameraDescription camera;
    camera.eye = {3, 1, 1e9};
    camera.target = {3, 1, 1e9 - 1}; // float has steps of 64 there
    EXPECT_EQ(Camera<Real>(camera).ray(320, 240).D, Vec3<Real>(0, 0, -1));
}

TYPED_TEST(FarAndSmall, NormalsAreAsExactAsTheirType)
{
    using Real = TypeParam;
    Random random(2);
    for (int i = 0; i < 200; ++i)
    {
        const V a = random.vector(-9, 9), b = random.vector(-9, 9), c = random.vector(-9, 9);
        const V normal = b * random.power10(-300, 300);
        const Scene<Real> scene(Build().plane(a, normal).triangle(a, b, c).scene);
        const Vec3<long double> A(a), B(b), C(c);
        EXPECT_LE(apart(scene.planes[0].N, unit(Vec3<long double>(normal))), 2 * eps<Real>);
        // A sliver magnifies the rounding of its edges.
        const long double sine = length(cross(unit(B - A), unit(C - A)));
        EXPECT_LE(apart(scene.triangles[0].N, unit(cross(B - A, C - A))), 4 * eps<Real> / sine);
    }
}

TYPED_TEST(FarAndSmall, NumbersThatDoNotFitTheTypeAreRefused)
{
    using Real = TypeParam;
    constexpr bool single = std::is_same_v<Real, float>;
    auto far = Build().sphere({0, 0, 0}, 1).scene, thin = far, strange = far, stranger = far;
    far.camera.eye.x = 1e39;
    thin.materials[0].ior = 1e-46;
    strange.materials[0].ior = 1e20; // its square is infinite in float
    stranger.materials[0] = glassOf(1e200, 1e-200);
    for (const auto& scene : {far, thin, strange})
    {
        if constexpr (single)
            EXPECT_THROW((Scene<Real>(scene)), std::range_error);
        else
            EXPECT_NO_THROW((Scene<Real>(scene)));
    }
    EXPECT_THROW((Scene<Real>(stranger)), std::range_error);
}

TYPED_TEST(FarAndSmall, APlanetOf1e6SeenFromOneAbove)
{
    using Real = TypeParam;
    const double R = 1e6;
    auto scene = Build().material(grey(0.5)).sphere({0, -R, 0}, R).light({0, 500, 0}, 1e6).scene;
    scene.camera = {.eye = {0, 1, 0}, .target = {0, 0.75, -4}, .width = 64, .height = 48};
    const Scene<Real> planet(scene);
    const auto below = planet.intersect({.O = {0, 1, 0}, .D = {0, -1, 0}});
    ASSERT_TRUE(below);
    EXPECT_EQ(below->t, 1);
    EXPECT_EQ(Vec3<Real>(below->I), Vec3<Real>(0));

    // The horizon lies acos(R / (R + 1)) below the horizontal. Above it there is nothing, below it the planet.
    const long double dip = std::acos(R / (R + 1.0L)), doubt = eps<Real> > 1e-10 ? 0x1p-15L : R * 64 * eps<Real>;
    for (const long double part : {1 - doubt, 1 + doubt})
    {
        const Vec3<long double> D(0, -std::sin(dip * part), -std::cos(dip * part));
        EXPECT_EQ(bool(planet.intersect({.O = {0, 1, 0}, .D = unit(Vec3<Real>(D))})), part > 1);
    }

    // No pixel of the ground is dark; a point of it is known to eps * R, and the lamp is 500 away.
    const Image got = pictureOf<Real>(scene), reference = pictureOf<long double>(scene);
    EXPECT_EQ(different(got, reference, 8 * double(eps<Real>) * R / 500), 0);
    int ground = 0;
    double error = 0;
    for (std::size_t i = 0; i < got.pixels.size(); ++i)
    {
        EXPECT_EQ(got.pixels[i].x > 0, reference.pixels[i].x > 0);
        ground += got.pixels[i].x > 0;
        if (reference.pixels[i].x > 0) error = std::max(error, std::abs(got.pixels[i].x / reference.pixels[i].x - 1));
    }
    EXPECT_GT(ground, 1500);
    note("largest relative error", error);
}

TYPED_TEST(FarAndSmall, ASpeckOfTwoToTheMinus20)
{
    using Real = TypeParam;
    const double r = 0x1p-20;
    // At (1, 1, 1) float has 8 steps a radius; what is along the axes is exact all the same.
    const Scene<Real> scene(Build().material(mirrorOf(0.5)).sphere({1, 1, 1}, r).sky(V(2)).scene);
    for (int axis = 0; axis < 3; ++axis)
    {
        Ray<Real> ray{.O = Vec3<Real>(1)};
        ray.O[axis] += Real(0x1p-17);
        ray.D[axis] = -1;
        const auto hit = scene.intersect(ray);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->t, Real(0x1p-17 - r));
        EXPECT_EQ(hit->N, -ray.D);
        EXPECT_EQ(colorOf(scene, ray).x, 1);
    }
    // A camera that is as near as it is small sees it as any ball is seen.
    const auto close = [](double radius, const V& center) {
        auto ball =
            Build().material(grey(0.5)).sphere(center, radius).light(center + radius * V(3, 4, 5), radius * radius);
        ball.scene.camera = {.eye = center + radius * V(0, 0, 4), .target = center, .width = 32, .height = 32};
        return ball.scene;
    };
    const Image large = pictureOf<Real>(close(1, V(0)));
    EXPECT_EQ(pictureOf<Real>(close(r, V(0))).pixels, large.pixels);
    if (eps<Real> < 1e-10)
    {
        EXPECT_LE(different(pictureOf<Real>(close(r, V(1))), large, 0x1p24 * double(eps<Real>)), 2);
    }
}

TYPED_TEST(FarAndSmall, AShellThinnerThanAnyEpsilonIsNotLost)
{
    using Real = TypeParam;
    const double inner = 1 - 4e-5;
    const Scene<Real> shell(Build()
                                .material(glassOf(1.5))
                                .sphere({0, 0, 0}, 1)
                                .material(glassOf(1, 1.5))
                                .sphere({0, 0, 0}, inner)
                                .sky(V(1))
                                .fresnel(FresnelModel::none)
                                .scene);
    Random random(1);
    for (int i = 0; i < 300; ++i)
    {
        const double x = i ? random.in(-0.9, 0.9) : 0;
        const auto path = pathOf<Real>(shell, {.O = {Real(x), 0, 4}, .D = {0, 0, -1}});
        ASSERT_EQ(path.size(), 5U) << "in, through the shell, through it again, out; " << x;
        for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(path[k].on, k == 0 || k == 3 ? 0 : 1);
        const long double h = Real(x), turn = 2 * (std::asin(h) - std::asin(h / 1.5L) +
                                                   std::asin(h / (1.5L * Real(inner))) - std::asin(h / Real(inner)));
        EXPECT_LE(apart(path[4].ray.D, Vec3<long double>(-std::sin(turn), 0, -std::cos(turn))), 64 * eps<Real>);
    }
    // What is inside an opaque shell gets no light from outside, however thin the gap.
    const Scene<Real> dark(
        Build().sphere({0, 0, 0}, 1).sphere({0, 0, 0}, inner).light({3, 4, 5}, 100).light({-30, 1, 0}, 1e4).scene);
    for (int i = 0; i < 1000; ++i)
    {
        const Vec3<Real> N = unit(Vec3<Real>(random.direction()));
        const Point<Real> I{Real(inner) * N, 1};
        for (const auto& light : dark.lights)
        {
            const Vec3<Real> L = light.position - I;
            EXPECT_TRUE(dark.occluded(I, unit(L), length(L)));
        }
    }
}

TYPED_TEST(FarAndSmall, ASceneMovedAThousandRadiiLosesThreeDigitsAndNoMore)
{
    using Real = TypeParam;
    for (const char* file : {"08_phong/scenes/everything.toml", "02_mirrors/scenes/pure_specular.toml"})
    {
        const auto scene = cases::smallScene(std::string("lessons/") + file);
        const Image here = pictureOf<long double>(scene), there = pictureOf<Real>(moved(scene, {1024, -1024, 1024}));
        const int wrong = different(there, here, 1 / 255.0),
                  close = different(there, here, 0x1p18 * std::max(double(eps<Real>), eps<double>));
        note("more than 1/255 off", wrong);
        note("more than 2^18 eps off", close);
        // Pixels at an edge of something may fall on its other side: in float at most 1 in 50, in double 1 in 1000.
        const int edges = 64 * 48 / (eps<Real> > 1e-10 ? 50 : 1000);
        EXPECT_LE(wrong, edges) << file;
        if (eps<Real> < 1e-10)
        {
            EXPECT_LE(close, edges) << file;
        }
    }
}

TEST(FarAndSmall, ASphereMetHeadOnFromAnywhereHasANormal)
{
    for (const double far : {1e7, 1e8, 1e9, 1e12})
    {
        SceneDescription description;
        description.materials.push_back({});
        description.spheres.push_back({V(0), 1, 0});
        const Scene<float> scene(description);
        const auto hit = scene.intersect({.O = {0, 0, float(far)}, .D = {0, 0, -1}});
        ASSERT_TRUE(hit);
        EXPECT_EQ(length(hit->N), 1) << far;
    }
}

} // namespace

} // namespace rt::numerics
