// Radiances that can be computed by hand, from one lamp to 33 bounces, and what lamps do at their extremes.
#include "tests/numerics/extremes.h"

namespace rt::numerics
{

namespace
{

template <class Real>
class ClosedForm : public testing::Test
{
};
TYPED_TEST_SUITE(ClosedForm, Precisions);

constexpr double ulps = 64; ///< for every closed form

template <class Real>
Ray<Real> down(const V& from)
{
    return {.O = Vec3<Real>(from), .D = {0, -1, 0}};
}

TYPED_TEST(ClosedForm, ALampOverADiffuseFloor)
{
    using Real = TypeParam;
    Random random(1);
    for (int i = 0; i < 1000; ++i)
    {
        const double scale = random.power10(-3, 3);
        const Vec3<float> L(V(random.in(-9, 9), random.in(0.01, 9), random.in(-9, 9)) *
                            scale); // the same in every type
        const auto scene = Build().material(grey(0.5)).floor().light(V(L), 8).scene;
        const Vec3<long double> l(L);
        EXPECT_TRUE(
            near(colorOf(Scene<Real>(scene), down<Real>({0, 2, 0})).x, 4 * l.y / std::pow(dot(l, l), 1.5L), ulps));
    }
}

TYPED_TEST(ClosedForm, AGeometricSeriesBetweenFacingMirrors)
{
    using Real = TypeParam;
    for (const double share : {0.25, 0.5, 0.75, 0.9375})
        for (const int depth : {0, 1, 5, 32})
        {
            const auto scene = Build()
                                   .material(mirrorOf(0.875, share))
                                   .floor()
                                   .plane({0, 2, 0}, {0, -1, 0})
                                   .light({0, 1, 0}, 16)
                                   .depth(depth)
                                   .scene;
            const long double factor = share * 0.875L;
            const long double sum = (1 - std::pow(factor, depth + 1)) / (1 - factor);
            EXPECT_TRUE(
                near(colorOf(Scene<Real>(scene), down<Real>({0, 1, 0})).y, (1 - (long double)share) * 14 * sum, ulps))
                << "share " << share << ", depth " << depth;
        }
}

TYPED_TEST(ClosedForm, APhongHighlight)
{
    using Real = TypeParam;
    for (const double exponent : {1.0, 4.0, 64.0})
    {
        const auto scene = Build().material(glossyOf(0.5, 0.25, exponent)).floor().light({0.75, 1, 0}, 25).scene;
        // dist = 1.25, N.L = 0.8; straight down, V = N, so V.R = N.L.
        const long double phong = 0.75L * 0.8L + 0.25L * std::pow(0.8L, (long double)exponent);
        EXPECT_TRUE(near(colorOf(Scene<Real>(scene), down<Real>({0, 3, 0})).z, 0.5L * 16 * phong, ulps)) << exponent;
    }
}

TYPED_TEST(ClosedForm, AHighlightIsNeverBrighterThanItsLamp)
{
    using Real = TypeParam;
    using vec3 = Vec3<Real>;
    Random random(5);
    Material<Real> gloss;
    gloss.glossy = 1;
    gloss.exponent = 1 / eps<Real>; // rounding of V.R, to this power
    for (int i = 0; i < 10000; ++i)
    {
        const vec3 N = unit(vec3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)));
        const vec3 L = unit(vec3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)));
        if (!(dot(N, L) > 0)) continue;
        const vec3 V = unit(2 * dot(N, L) * N - L);
        EXPECT_LE((lesson08::Tracer<Real>::phong(L, N, V, gloss)), 1);
    }
}

TYPED_TEST(ClosedForm, AHighlightOfExponentTwoToThe20)
{
    using Real = TypeParam;
    const double exponent = 0x1p20;
    const auto scene = [&](const V& lamp) {
        return Scene<Real>(Build().material(glossyOf(1, 1, exponent)).floor().light(lamp, dot(lamp, lamp)).scene);
    };
    EXPECT_EQ(colorOf(scene({0, 2, 0}), down<Real>({0, 3, 0})).x, 1) << "its peak";
    EXPECT_EQ(colorOf(scene({2, 2, 0}), down<Real>({0, 3, 0})).x, 0) << "45 degrees away";
    // The slope of the highlight: cos^alpha makes alpha relative errors of one. In float they are 12 % each.
    for (int i = 1; i < 64; ++i)
    {
        const long double x = i * 0x1p-15L, cosine = 1 / std::sqrt(1 + x * x);
        const Real got = colorOf(scene({double(x), 1, 0}), down<Real>({0, 3, 0})).x;
        const long double expected = std::pow(cosine, 0x1p20L), bound = std::exp(3 * 0x1p20L * eps<Real>);
        EXPECT_GE(got, expected / bound) << i;
        EXPECT_LE(got, expected * bound) << i;
    }
    // Away from the middle V.R may round to a little more than 1; no highlight gets infinite by that.
    Random random(11);
    for (int i = 0; i < 2000; ++i)
    {
        const V lamp = random.vector(-1, 1) + V(0, 1.5, 0), back = V(-lamp.x, lamp.y, -lamp.z);
        const Vec3<Real> color = colorOf(scene(lamp), {.O = unit(Vec3<Real>(back)), .D = unit(Vec3<Real>(-back))});
        EXPECT_GT(color.x, 0);
        EXPECT_LE(color.x, std::exp(16 * 0x1p20L * eps<Real>)) << i;
    }
}

TYPED_TEST(ClosedForm, ExponentsBeyondAllSenseStayFinite)
{
    using Real = TypeParam;
    Random random(12);
    for (const double exponent : {1e6, 1e9, 1e15, 1e20, 3e38})
        for (int i = 0; i < 200; ++i)
        {
            const V lamp = random.vector(-1, 1) + V(0, 1.5, 0), back = V(-lamp.x, lamp.y, -lamp.z);
            const Scene<Real> scene(Build().material(glossyOf(1, 1, exponent)).floor().light(lamp, 1).scene);
            const auto color = colorOf(scene, {.O = unit(Vec3<Real>(back)), .D = unit(Vec3<Real>(-back))});
            EXPECT_TRUE(isFinite(color)) << exponent;
        }
}

TYPED_TEST(ClosedForm, ALampOnTheHitPointIsSkippedAndTheOthersAreNot)
{
    using Real = TypeParam;
    const V lit(0.5 * 4 / 4);
    const auto floor = Build().material(grey(0.5)).floor().light({0, 0, 0}, 100).light({0, 2, 0}, 4).scene;
    EXPECT_EQ(V(colorOf(Scene<Real>(floor), down<Real>({0, 1, 0}))), lit);
    const auto ball = Build().material(grey(0.5)).sphere({0, -1, 0}, 1).light({0, 0, 0}, 100).light({0, 2, 0}, 4);
    EXPECT_EQ(V(colorOf(Scene<Real>(ball.scene), down<Real>({0, 1, 0}))), lit);
    const auto triangle = Build()
                              .material(grey(0.5))
                              .triangle({-1, 0, -1}, {0, 0, 2}, {1, 0, -1})
                              .light({0, 0, 0}, 100)
                              .light({0, 2, 0}, 4);
    EXPECT_EQ(V(colorOf(Scene<Real>(triangle.scene), down<Real>({0, 1, 0}))), lit);
}

TYPED_TEST(ClosedForm, ALampCloseToTheSurface)
{
    using Real = TypeParam;
    for (int k = 1; k <= 20; ++k)
    {
        const auto scene = Build().material(grey(0.5)).floor().light({0, std::ldexp(1.0, -k), 0}, 2).scene;
        EXPECT_EQ(colorOf(Scene<Real>(scene), down<Real>({0, 1, 0})).x, std::ldexp(Real(1), 2 * k)) << k;
    }
}

TYPED_TEST(ClosedForm, ALampWhoseLightDoesNotFitTheTypeIsOnThePoint)
{
    using Real = TypeParam;
    // 1 / dist² is infinite long before dist² is 0, and times a cosine of 0 it is NaN.
    const double tiny = double(std::sqrt(std::numeric_limits<Real>::min()));
    if (tiny == 0) return; // long double: no scene file can say so
    for (const double height : {tiny / 4, tiny / 256, tiny})
        for (const double color : {1.0, 1e6, 0.0})
            for (const V& lamp : {V(0, height, 0), V(height, 0, 0)})
            {
                const Scene<Real> scene(
                    Build().material({.name = "black", .color = V(1, 0, 0.5)}).floor().light(lamp, color).scene);
                EXPECT_TRUE(isFinite(colorOf(scene, down<Real>({0, 1, 0})))) << height << ", " << color;
            }
}

TYPED_TEST(ClosedForm, LightIsNotClampedAtAHundredThousand)
{
    using Real = TypeParam;
    const auto lamp = Build().material(grey(0.5)).floor().light({0, 2, 0}, 4e5).scene;
    EXPECT_EQ(colorOf(Scene<Real>(lamp), down<Real>({0, 1, 0})).x, 5e4);
    const auto sky = Build().material(mirrorOf(0.5)).floor().sky(V(1e5)).scene;
    EXPECT_EQ(colorOf(Scene<Real>(sky), down<Real>({0, 1, 0})).x, 5e4);
}

TYPED_TEST(ClosedForm, AShadowRayEndsAtTheLamp)
{
    using Real = TypeParam;
    // The lamp sits on a sphere, a plane and a triangle in turn: t = dist is not in between.
    const auto lit = Build().floor().light({0, 4, 0}, 16).scene;
    auto sphere = lit, plane = lit, triangle = lit;
    sphere.spheres.push_back({{0, 5, 0}, 1, 0});
    plane.planes.push_back({.point = {0, 4, 0}, .normal = {0, 1, 0}, .material = 0});
    triangle.triangles.push_back({{V(-1, 4, -1), V(0, 4, 2), V(1, 4, -1)}, 0});
    for (const auto& scene : {lit, sphere, plane, triangle})
        EXPECT_EQ(colorOf(Scene<Real>(scene), down<Real>({0, 2, 0})).x, 1);
    for (auto scene : {sphere, plane, triangle})
    {
        scene.lights[0].position.y = std::nextafter(4.0F, 5.0F); // one ulp of float behind it
        EXPECT_EQ(colorOf(Scene<Real>(scene), down<Real>({0, 2, 0})).x, 0);
    }
}

} // namespace

} // namespace rt::numerics
