// Many samples a pixel: their places, and their mean, are as right as those of one.
#include "tests/numerics/extremes.h"

namespace rt::numerics
{

namespace
{

template <class Real>
class Samples : public testing::Test
{
};
TYPED_TEST_SUITE(Samples, Precisions);

constexpr int most = 65536; // what --spp takes

TYPED_TEST(Samples, LieWhereTheSequencePutsThem)
{
    using Real = TypeParam;
    for (const int index : {1, 1000, most - 1})
        for (const int axis : {0, 1})
        {
            const long double x = 0.5L + index * (axis == 0 ? 0.75487766624669276005L : 0.56984029099805326591L);
            const Real got = samplePosition<Real>(index)[std::size_t(axis)];
            EXPECT_LT(got, 1);
            // The index times a step is rounded in double at least.
            const long double error = eps<Real> + index * (long double)eps<Wide<Real>>;
            EXPECT_LE(std::abs((long double)got - (x - std::floor(x))), error) << index;
        }
}

TYPED_TEST(Samples, AnEvenSkyHasItsColour)
{
    using Real = TypeParam;
    SceneDescription description;
    description.sky.color = {0.7, 0.1, 1e-3};
    const Scene<Real> scene(description);
    lesson08::Tracer<Real> tracer{scene};
    const auto one = renderPixel(scene, tracer, 3, 4, 1);
    EXPECT_EQ(one, Vec3<Real>(description.sky.color));
    for (const int spp : {3, 1000, most})
    {
        const auto mean = renderPixel(scene, tracer, 3, 4, spp);
        const Real error = std::is_same_v<Real, float> ? Real(0) : spp * eps<Real>; // float sums in double
        for (int k = 0; k < 3; ++k) EXPECT_LE(std::abs(mean[k] - one[k]), error * one[k]) << spp;
    }
}

} // namespace

} // namespace rt::numerics
