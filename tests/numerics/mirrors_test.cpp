// Long paths: corner cubes, time reversal, and mirror balls, which lose digits at a known rate.
#include "tests/numerics/extremes.h"

namespace rt::numerics
{

namespace
{

template <class Real>
class Mirrors : public testing::Test
{
};
TYPED_TEST_SUITE(Mirrors, Precisions);

const Material<double> mirror = mirrorOf(1);

TYPED_TEST(Mirrors, ACornerCubeReturnsMinusD)
{
    using Real = TypeParam;
    // Three orthogonal normals, exact in every type: along the axes, and turned.
    const std::array<V, 3> frames[] = {{V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)}, {V(1, 2, 2), V(2, 1, -2), V(2, -2, 1)}};
    Random random(1);
    for (const auto& normals : frames)
    {
        Build corner;
        corner.material(mirror).sky(V(1));
        for (const V& N : normals) corner.plane({0, 0, 0}, N);
        const Scene<Real> scene(corner.scene);
        for (int i = 0; i < 1000; ++i)
        {
            V O(0), D(0);
            for (const V& N : normals)
            {
                O += random.in(0.1, 1) * N;
                D -= random.in(0.1, 1) * N;
            }
            const Ray<Real> ray{.O = Vec3<Real>(O), .D = unit(Vec3<Real>(D))};
            const auto path = pathOf(scene, ray);
            ASSERT_EQ(path.size(), 4U);
            EXPECT_LE(apart(path[3].ray.D, -Vec3<long double>(ray.D)), 8 * eps<Real>);
        }
    }
}

TYPED_TEST(Mirrors, TimeRunsBackwards)
{
    using Real = TypeParam;
    // Mirror walls and glass balls; nothing branches. A path that is sent back arrives where it came from.
    auto room = Build()
                    .material(glassOf(1.5))
                    .sphere({0.5, 0.25, 0}, 1)
                    .sphere({-1.5, -0.5, 1}, 0.75)
                    .material(mirror)
                    .sky(V(1))
                    .fresnel(FresnelModel::none)
                    .depth(6);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
        {
            V P(0);
            P[axis] = 4 * side;
            room.plane(P, -P);
        }
    const Scene<Real> scene(room.scene);
    Random random(2);
    long double worst = 0;
    int compared = 0;
    for (int i = 0; i < 500; ++i)
    {
        const Ray<Real> ray{.O = Vec3<Real>(0, 0, 3), .D = unit(Vec3<Real>(random.direction()))};
        const auto there = pathOf(scene, ray);
        if (there.size() != 7) continue;
        const bool grazing = std::any_of(there.begin(), there.end(), [](const auto& step) {
            return std::abs(dot(step.ray.D, step.N)) < Real(0.3) || step.t < Real(0.1);
        });
        if (grazing) continue; // at a flat angle glass is a strong lens: the next test measures such
        // From halfway along the last ray, the other way round.
        const auto& last = there.back();
        const auto back = pathOf<Real>(scene, {.O = last.ray.O + last.t / 2 * last.ray.D, .D = -last.ray.D});
        ASSERT_EQ(back.size(), 7U);
        for (std::size_t k = 0; k < 6; ++k)
        {
            ASSERT_EQ(back[k].on, there[5 - k].on);
            worst = std::max(worst, apart(back[k].I, Vec3<long double>(there[5 - k].I)));
        }
        worst = std::max(worst, apart(back[6].ray.D, -Vec3<long double>(ray.D)));
        ++compared;
    }
    EXPECT_GT(compared, 50);
    note("worst_ulp", double(worst / eps<Real>));
    EXPECT_LE(worst, 4096 * eps<Real>);
}

/// Errors of a path that ought to go round a periodic orbit: how far the n-th hit is from where the orbit has it.
template <class Real>
std::vector<long double> driftFrom(const std::vector<Vec3<long double>>& orbit, const SceneDescription& description,
                                   const Vec3<long double>& start,
                                   const Vec3<long double>& nudge = Vec3<long double>(0))
{
    const Ray<Real> ray{.O = Vec3<Real>(start),
                        .D = unit(Vec3<Real>(orbit[0] - start) + eps<Real> * Vec3<Real>(nudge))};
    std::vector<long double> drift;
    for (const auto& step : pathOf(Scene<Real>(description), ray))
        if (step.on != noPrimitive) drift.push_back(apart(step.I, orbit[drift.size() % orbit.size()]));
    return drift;
}

/// Digits lost a bounce: the slope of log10(drift), from the first error that is not just rounding to the last that is
/// still small.
template <class Real>
void expectGrowth(const std::vector<long double>& drift, long double factor, const char* what)
{
    const double digits = double(std::log10(factor));
    const double horizon = double(-std::log10(eps<Real>)) / digits; // bounces until nothing is left
    std::size_t first = 0;
    while (first < drift.size() && drift[first] < 16 * eps<Real>) ++first;
    std::size_t last = first;
    while (last + 1 < drift.size() && drift[last + 1] < 0.04L) ++last;
    ASSERT_GT(last, first + 1) << what;
    const double measured = double(std::log10(drift[last] / drift[first])) / double(last - first);
    EXPECT_NEAR(measured, digits, 0.1 * digits) << what;
    const auto safe = std::size_t(std::max(0.0, horizon - 2 - 1 / digits)); // one digit is kept
    ASSERT_GT(drift.size(), safe) << what << ": the path left the orbit before its horizon of " << horizon;
    EXPECT_LT(drift[safe], 0.1L) << what;
    note(std::string(what) + ": digits a bounce", measured);
    note(std::string(what) + ": horizon", horizon);
    note(std::string(what) + ": bounces on the orbit", double(last));
}

TYPED_TEST(Mirrors, TwoBallsLoseDigitsAsFastAsTheorySays)
{
    using Real = TypeParam;
    // Along the line of centres (3, 4, 12) / 13 a ray bounces to and fro for ever; an error grows with every bounce by
    // 1 + g + sqrt((1 + g)² - 1), where g is the gap in radii.
    for (const double gap : {0.25, 1.0, 3.0})
    {
        const double r = 13.0 / (2 + gap);
        const long double length = 13;
        const Vec3<long double> C(3, 4, 12);
        const std::vector<Vec3<long double>> orbit{(long double)(Real(r)) / length * C,
                                                   (1 - (long double)(Real(r)) / length) * C};
        const auto scene = Build().material(mirror).sphere({0, 0, 0}, r).sphere(V(C), r).depth(200).scene;
        // A nudge of some ulp: without it, rounding may keep float on the orbit for ever.
        const auto drift = driftFrom<Real>(orbit, scene, C / 2.0L, Vec3<long double>(0, -1.5, 0.5));
        const long double g = 1 + (long double)gap;
        expectGrowth<Real>(drift, g + std::sqrt(g * g - 1), ("two balls, gap " + cases::text(gap)).c_str());
    }
}

TYPED_TEST(Mirrors, ThreeBallsLoseDigitsAsFastAsTheorySays)
{
    using Real = TypeParam;
    // Centres on the three axes are an exact equilateral triangle of side sqrt(2). The orbit that visits all three meets
    // them at 30 degrees; its plane's error grows by s + sqrt(s² - 1), s = 1 + L / (r cos 30°), L from ball to ball.
    for (const double r : {0.5, 0.375, 0.25})
    {
        const long double side = std::sqrt(2.0L), root3 = std::sqrt(3.0L);
        const Vec3<long double> G(1.0L / 3);
        std::vector<Vec3<long double>> orbit;
        for (int i = 0; i < 3; ++i)
        {
            Vec3<long double> C(0);
            C[i] = 1;
            orbit.push_back(C + (long double)r * unit(G - C));
        }
        const auto scene =
            Build().material(mirror).sphere({1, 0, 0}, r).sphere({0, 1, 0}, r).sphere({0, 0, 1}, r).depth(200).scene;
        const long double between = side - root3 * (long double)r;
        EXPECT_LE(std::abs(between - length(orbit[1] - orbit[0])), 4 * eps<long double>);
        const auto drift = driftFrom<Real>(orbit, scene, (orbit[2] + orbit[0]) / 2.0L);
        const long double s = 1 + between / ((long double)r * root3 / 2);
        expectGrowth<Real>(drift, s + std::sqrt(s * s - 1), ("three balls, r = " + cases::text(r)).c_str());
    }
}

} // namespace

} // namespace rt::numerics
