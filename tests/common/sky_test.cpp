// The sky's promises: where a direction lies in a picture, what stands there, and that nothing is ever clamped.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/scene/sky.h"

namespace rt
{

namespace
{

template <class Real>
class SkyOf : public testing::Test
{
};
using Precisions = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(SkyOf, Precisions);

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

template <class Real>
Real radians(double degrees)
{
    return Real(degrees) * SkyFormulas<Real>::PI / 180;
}

template <class Real>
std::string text(const Vec3<Real>& v)
{
    return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

template <class Real>
void expectAt(const std::array<Real, 2>& got, Real u, Real v, Real tolerance, const Vec3<Real>& D)
{
    EXPECT_LE(std::abs(got[0] - u), tolerance) << "u = " << got[0] << ", expected " << u << " for " << text(D);
    EXPECT_LE(std::abs(got[1] - v), tolerance) << "v = " << got[1] << ", expected " << v << " for " << text(D);
}

template <class Real>
void expectNear(const Vec3<Real>& got, const Vec3<Real>& expected, Real tolerance, const Vec3<Real>& D)
{
    for (int c = 0; c < 3; ++c)
        EXPECT_LE(std::abs(got[c] - expected[c]), tolerance)
            << text(got) << ", expected " << text(expected) << " for " << text(D);
}

/// The direction at an angle from -z, turned by `around` from +x towards +y: the angular map's polar coordinates.
template <class Real>
Vec3<Real> offAxis(Real angle, Real around)
{
    return {std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), -std::cos(angle)};
}

/// The direction of a longitude (0: -z, a quarter turn: +x) and an angle from the zenith.
template <class Real>
Vec3<Real> onGlobe(Real longitude, Real fromZenith)
{
    return {std::sin(fromZenith) * std::sin(longitude), std::cos(fromZenith),
            -std::sin(fromZenith) * std::cos(longitude)};
}

SkyDescription pictureSky(const Image& image, SkyMapping mapping)
{
    SkyDescription sky;
    sky.present = true;
    sky.imageFile = "picture";
    sky.mapping = mapping;
    sky.image = std::make_shared<const Image>(image);
    return sky;
}

/// Different values in all texels; whole numbers, hence exact in every type.
Image numbered(int width, int height)
{
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = {double(x), double(y), 100.0 - x * height - y};
    return image;
}

/// A formula of a student that always gives this place.
template <class Real>
struct FixedPlace
{
    Real u, v;
    std::array<Real, 2> latLong(const Vec3<Real>&) const { return {u, v}; }
};

/// Directions at which formulas break: axes, zeros of both signs, the seam, next to the poles.
template <class Real>
std::vector<Vec3<Real>> delicateDirections()
{
    const Real least = std::numeric_limits<Real>::denorm_min(), small = eps<Real>;
    const std::vector<Real> parts{0, -Real(0), 1, -1, least, -least, small, -small, std::sqrt(small), Real(0.1)};
    std::vector<Vec3<Real>> directions;
    for (const Real x : parts)
        for (const Real y : parts)
            for (const Real z : parts)
                if (x != 0 || y != 0 || z != 0) directions.push_back(unit(Vec3<Real>(x, y, z)));
    return directions;
}

/// Any direction, by RapidCheck; some parts are zero, tiny or equal.
template <class Real>
Vec3<Real> anyDirection()
{
    const auto part = [] {
        const int mantissa = *rc::gen::inRange(-1000000, 1000001);
        return std::ldexp(Real(mantissa) / 7, *rc::gen::element(0, 0, 0, -20, -60, -140));
    };
    const Real x = part(), y = part(), z = part();
    const Vec3<Real> D = unit(Vec3<Real>(x, y, z));
    return D == Vec3<Real>(0) ? Vec3<Real>(0, 0, 1) : D;
}

// ---- directions ----------------------------------------------------------------------------------------------------

TYPED_TEST(SkyOf, LatLongPutsTheAxesWhereTheMapSays)
{
    using Real = TypeParam;
    using V = Vec3<Real>;
    const Real tolerance = 2 * eps<Real>;
    const auto at = [](const V& D) { return SkyFormulas<Real>::latLong(D); };
    expectAt<Real>(at({0, 0, -1}), Real(0.5), Real(0.5), tolerance, {0, 0, -1});
    expectAt<Real>(at({1, 0, 0}), Real(0.75), Real(0.5), tolerance, {1, 0, 0});
    expectAt<Real>(at({-1, 0, 0}), Real(0.25), Real(0.5), tolerance, {-1, 0, 0});
    expectAt<Real>(at({0, 0, 1}), 1, Real(0.5), tolerance, {0, 0, 1});               // the seam, from the right
    expectAt<Real>(at({-Real(0), 0, 1}), 0, Real(0.5), tolerance, {-Real(0), 0, 1}); // and from the left
    EXPECT_EQ(at({0, 1, 0})[1], 0) << "the zenith is the upper edge";
    EXPECT_LE(std::abs(at({0, -1, 0})[1] - 1), tolerance) << "the nadir is the lower edge";
}

TYPED_TEST(SkyOf, LatLongIsLinearInLongitudeAndLatitude)
{
    using Real = TypeParam;
    for (const double longitude : {-179.0, -150.0, -90.0, -37.5, 0.0, 30.0, 60.0, 120.0, 179.0})
        for (const double fromZenith : {5.0, 30.0, 45.0, 90.0, 100.0, 135.0, 170.0})
        {
            const auto D = onGlobe(radians<Real>(longitude), radians<Real>(fromZenith));
            expectAt<Real>(SkyFormulas<Real>::latLong(D), Real(0.5) + Real(longitude) / 360, Real(fromZenith) / 180,
                           16 * eps<Real>, D);
        }
}

TYPED_TEST(SkyOf, TheAngularMapPutsTheAxesWhereTheProbeSays)
{
    using Real = TypeParam;
    using V = Vec3<Real>;
    const Real tolerance = 2 * eps<Real>;
    const auto at = [](const V& D) { return SkyFormulas<Real>::angularMap(D); };
    expectAt<Real>(at({0, 0, -1}), Real(0.5), Real(0.5), 0, {0, 0, -1});
    expectAt<Real>(at({1, 0, 0}), Real(0.75), Real(0.5), tolerance, {1, 0, 0});
    expectAt<Real>(at({-1, 0, 0}), Real(0.25), Real(0.5), tolerance, {-1, 0, 0});
    expectAt<Real>(at({0, 1, 0}), Real(0.5), Real(0.25), tolerance, {0, 1, 0});
    expectAt<Real>(at({0, -1, 0}), Real(0.5), Real(0.75), tolerance, {0, -1, 0});
    const auto [u, v] = at({0, 0, 1});
    EXPECT_LE(std::abs(std::hypot(u - Real(0.5), v - Real(0.5)) - Real(0.5)), tolerance) << "+z is the rim";
}

TYPED_TEST(SkyOf, TheAngularMapsRadiusIsTheAngle)
{
    using Real = TypeParam;
    for (const double angle : {5.0, 30.0, 60.0, 90.0, 120.0, 150.0, 175.0})
        for (const double around : {0.0, 30.0, 45.0, 100.0, 180.0, 225.0, 300.0})
        {
            const auto D = offAxis(radians<Real>(angle), radians<Real>(around));
            const Real r = Real(angle) / 360;
            expectAt<Real>(SkyFormulas<Real>::angularMap(D), Real(0.5) + r * std::cos(radians<Real>(around)),
                           Real(0.5) - r * std::sin(radians<Real>(around)), 16 * eps<Real>, D);
        }
}

TYPED_TEST(SkyOf, EveryDirectionLiesInThePicture)
{
    using Real = TypeParam;
    const auto lies = [](const std::array<Real, 2>& at) {
        constexpr Real least = -eps<Real>, most = 1 + eps<Real>;
        return at[0] >= least && at[0] <= most && at[1] >= least && at[1] <= most;
    };
    for (const auto& D : delicateDirections<Real>()) EXPECT_TRUE(lies(SkyFormulas<Real>::latLong(D))) << text(D);
    EXPECT_TRUE(rc::check([&] {
        const auto D = anyDirection<Real>();
        RC_ASSERT(lies(SkyFormulas<Real>::latLong(D)));
        // So near to the axis that squares vanish, the place may be off; looking it up keeps to the picture's edge.
        const Real squared = D.x * D.x + D.y * D.y;
        if (squared == 0 || squared >= std::numeric_limits<Real>::min() / eps<Real>)
            RC_ASSERT(lies(SkyFormulas<Real>::angularMap(D)));
    }));
}

TYPED_TEST(SkyOf, ADirectionThatRoundingMadeTooLongLiesInThePicture)
{
    using Real = TypeParam;
    const Real more = 1 + 4 * eps<Real>;
    const auto latLong = [](const Vec3<Real>& D) { return SkyFormulas<Real>::latLong(D); };
    const auto angularMap = [](const Vec3<Real>& D) { return SkyFormulas<Real>::angularMap(D); };
    EXPECT_EQ(latLong({0, more, 0})[1], 0);
    EXPECT_LE(std::abs(latLong({0, -more, 0})[1] - 1), 2 * eps<Real>);
    expectAt<Real>(angularMap({eps<Real>, 0, -more}), Real(0.5), Real(0.5), 2 * eps<Real>, {eps<Real>, 0, -more});
    expectAt<Real>(angularMap({0, eps<Real>, more}), Real(0.5), 0, 2 * eps<Real>, {0, eps<Real>, more});
}

TYPED_TEST(SkyOf, PlacesNearThePolesKeepTheirDigits)
{
    using Real = TypeParam;
    constexpr auto pi = std::numbers::pi_v<long double>;
    for (Real angle = Real(0.5); angle > eps<Real>; angle /= 3)
    {
        const Vec3<Real> D(std::sin(angle) * Real(0.6), std::cos(angle), std::sin(angle) * Real(0.8));
        EXPECT_NEAR(double(SkyFormulas<Real>::latLong(D)[1] * pi / angle), 1, 8 * double(eps<Real>)) << double(angle);
    }
}

// ---- pictures ------------------------------------------------------------------------------------------------------

TYPED_TEST(SkyOf, ATexelsCentreHasItsValueExactly)
{
    using Real = TypeParam;
    const Image image = numbered(8, 4); // powers of two: the centres are exact
    const Sky<Real> sky(pictureSky(image, SkyMapping::latlong));
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
        {
            const FixedPlace<Real> centre{(Real(x) + Real(0.5)) / 8, (Real(y) + Real(0.5)) / 4};
            EXPECT_EQ(sky.color({0, 0, -1}, centre), Vec3<Real>(image.at(x, y))) << x << ", " << y;
        }
}

TYPED_TEST(SkyOf, ATexelIsSeenInItsDirection)
{
    using Real = TypeParam;
    const Image image = numbered(8, 6);
    const Sky<Real> globe(pictureSky(image, SkyMapping::latlong));
    const Sky<Real> probe(pictureSky(image, SkyMapping::angular));
    int inside = 0;
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x)
        {
            const Vec3<Real> texel(image.at(x, y));
            const Real u = (Real(x) + Real(0.5)) / 8, v = (Real(y) + Real(0.5)) / 6, pi = SkyFormulas<Real>::PI;
            const auto D = onGlobe(2 * pi * (u - Real(0.5)), pi * v);
            expectNear<Real>(globe.color(D), texel, 10000 * eps<Real>, D);

            const Real right = 2 * u - 1, up = 1 - 2 * v, r = std::hypot(right, up);
            if (r >= 1) continue; // corners of the picture show nothing
            const auto E = offAxis(pi * r, std::atan2(up, right));
            expectNear<Real>(probe.color(E), texel, 10000 * eps<Real>, E);
            ++inside;
        }
    EXPECT_GT(inside, 30);
}

TYPED_TEST(SkyOf, BetweenTexelsTheirValuesAreMixed)
{
    using Real = TypeParam;
    using V = Vec3<Real>;
    const Image image = numbered(8, 4);
    const Sky<Real> sky(pictureSky(image, SkyMapping::latlong));
    const auto at = [&](int x, int y) { return V(image.at(x, y)); };
    const auto look = [&](Real x, Real y) { return sky.color({0, 0, -1}, FixedPlace<Real>{x / 8, y / 4}); };
    EXPECT_EQ(look(3, Real(1.5)), (at(2, 1) + at(3, 1)) / Real(2));
    EXPECT_EQ(look(Real(2.5), 2), (at(2, 1) + at(2, 2)) / Real(2));
    EXPECT_EQ(look(3, 2), (at(2, 1) + at(3, 1) + at(2, 2) + at(3, 2)) / Real(4));
    EXPECT_EQ(look(Real(2.75), Real(1.5)), Real(0.75) * at(2, 1) + Real(0.25) * at(3, 1));
    EXPECT_EQ(look(Real(2.5), Real(1.75)), Real(0.75) * at(2, 1) + Real(0.25) * at(2, 2));
}

TYPED_TEST(SkyOf, ALatLongPictureClosesAtItsSeamAndEndsAtItsPoles)
{
    using Real = TypeParam;
    using V = Vec3<Real>;
    const Image image = numbered(8, 4);
    const Sky<Real> sky(pictureSky(image, SkyMapping::latlong));
    const auto at = [&](int x, int y) { return V(image.at(x, y)); };
    const auto look = [&](Real x, Real y) { return sky.color({0, 0, -1}, FixedPlace<Real>{x / 8, y / 4}); };
    for (const Real x : {Real(0), Real(8)}) EXPECT_EQ(look(x, Real(1.5)), (at(7, 1) + at(0, 1)) / Real(2)) << x;
    EXPECT_EQ(look(Real(0.25), Real(1.5)), Real(0.25) * at(7, 1) + Real(0.75) * at(0, 1));
    EXPECT_EQ(look(Real(7.75), Real(1.5)), Real(0.75) * at(7, 1) + Real(0.25) * at(0, 1));
    EXPECT_EQ(look(Real(2.5), 0), at(2, 0)) << "the zenith knows nothing of the nadir";
    EXPECT_EQ(look(Real(2.5), 4), at(2, 3));

    // The same in directions: both sides of +z agree.
    const V left = sky.color({-Real(0), 0, 1}), right = sky.color({0, 0, 1});
    expectNear<Real>(left, right, 1000 * eps<Real>, {0, 0, 1});
    expectNear<Real>(right, (at(7, 1) + at(0, 1) + at(7, 2) + at(0, 2)) / Real(4), 1000 * eps<Real>, {0, 0, 1});
}

TYPED_TEST(SkyOf, AnAngularPictureDoesNotCloseAtItsEdges)
{
    using Real = TypeParam;
    Image image(4, 2);
    image.at(0, 0) = image.at(0, 1) = {1, 1, 1}; // the left edge; the rim's right end must not see it
    image.at(3, 0) = image.at(3, 1) = {5, 5, 5};
    const Sky<Real> sky(pictureSky(image, SkyMapping::angular));
    EXPECT_EQ(sky.color({0, 0, 1}), Vec3<Real>(5));
    const auto left = offAxis(radians<Real>(179.999), radians<Real>(180));
    expectNear<Real>(sky.color(left), Vec3<Real>(1), Real(0.001), left);
}

TYPED_TEST(SkyOf, APictureOfOneTexelIsThatColorEverywhere)
{
    using Real = TypeParam;
    Image image(1, 1);
    image.at(0, 0) = {3, 2, 1};
    for (const auto mapping : {SkyMapping::latlong, SkyMapping::angular})
        for (const auto& D : delicateDirections<Real>())
            expectNear<Real>(Sky<Real>(pictureSky(image, mapping)).color(D), {3, 2, 1}, 8 * eps<Real>, D);
}

TYPED_TEST(SkyOf, ValuesFarAboveOneSurvive)
{
    using Real = TypeParam;
    Image image(8, 4);
    image.at(2, 1) = {100, 90, 0.01};
    const Sky<Real> sky(pictureSky(image, SkyMapping::latlong));
    const FixedPlace<Real> centre{Real(2.5) / 8, Real(1.5) / 4};
    EXPECT_EQ(sky.color({0, 0, -1}, centre), Vec3<Real>(Vec3<double>(100, 90, 0.01)));
    const auto D = onGlobe(radians<Real>(360 * (2.5 / 8 - 0.5)), radians<Real>(180 * 1.5 / 4));
    expectNear<Real>(sky.color(D), Vec3<Real>(Vec3<double>(100, 90, 0.01)), 10000 * eps<Real>, D);
}

TYPED_TEST(SkyOf, APictureOfOneColorIsThatColorEverywhere)
{
    using Real = TypeParam;
    Image image(7, 5);
    for (auto& texel : image.pixels) texel = {0.25, 3, 100};
    for (const auto mapping : {SkyMapping::latlong, SkyMapping::angular})
    {
        const Sky<Real> sky(pictureSky(image, mapping));
        for (const auto& D : delicateDirections<Real>())
            expectNear<Real>(sky.color(D), Vec3<Real>(Real(0.25), 3, 100), 400 * eps<Real>, D);
        EXPECT_TRUE(rc::check([&] {
            const auto c = sky.color(anyDirection<Real>());
            RC_ASSERT(length(c - Vec3<Real>(Real(0.25), 3, 100)) <= 400 * eps<Real>);
        }));
    }
}

TYPED_TEST(SkyOf, NoDirectionGivesWhatThePictureHasNot)
{
    using Real = TypeParam;
    const Image image = numbered(7, 5);
    for (const auto mapping : {SkyMapping::latlong, SkyMapping::angular})
    {
        const Sky<Real> sky(pictureSky(image, mapping));
        const auto good = [&](const Vec3<Real>& c) {
            const Real more = 1 + 8 * eps<Real>;
            return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x <= 6 * more && c.y <= 4 * more && c.z <= 100 * more;
        };
        for (const auto& D : delicateDirections<Real>()) EXPECT_TRUE(good(sky.color(D))) << text(D);
        EXPECT_TRUE(rc::check([&] { RC_ASSERT(good(sky.color(anyDirection<Real>()))); }));
    }
}

// ---- colours, gradients and suns -----------------------------------------------------------------------------------

TYPED_TEST(SkyOf, NoSkyIsBlack)
{
    using Real = TypeParam;
    const Sky<Real> sky(SkyDescription{});
    for (const auto& D : delicateDirections<Real>()) EXPECT_EQ(sky.color(D), Vec3<Real>(0));
    EXPECT_EQ(sky.brightest(), 0);
}

TYPED_TEST(SkyOf, AConstantSkyIsItsColorInEveryDirection)
{
    using Real = TypeParam;
    SkyDescription description;
    description.color = {0.2, 7, 1000};
    const Sky<Real> sky(description);
    for (const auto& D : delicateDirections<Real>()) EXPECT_EQ(sky.color(D), Vec3<Real>(description.color));
    EXPECT_TRUE(rc::check([&] { RC_ASSERT(sky.color(anyDirection<Real>()) == Vec3<Real>(description.color)); }));
}

TYPED_TEST(SkyOf, AGradientIsLinearInHeightAboveTheHorizonAndConstantBelow)
{
    using Real = TypeParam;
    using V = Vec3<Real>;
    SkyDescription description;
    description.color = {1, 2, 8};
    description.zenith = Vec3<double>(5, 0, 4);
    const Sky<Real> sky(description);
    EXPECT_EQ(sky.color({0, 1, 0}), V(5, 0, 4));
    EXPECT_EQ(sky.color({1, 0, 0}), V(1, 2, 8));
    EXPECT_EQ(sky.color({std::sqrt(Real(0.75)), Real(0.5), 0}), V(3, 1, 6));
    EXPECT_EQ(sky.color({0, Real(0.25), -std::sqrt(Real(0.9375))}), V(2, Real(1.5), 7));
    EXPECT_EQ(sky.color({0, -std::numeric_limits<Real>::denorm_min(), 1}), V(1, 2, 8));
    EXPECT_EQ(sky.color({0, -1, 0}), V(1, 2, 8));
    EXPECT_TRUE(rc::check([&] {
        const auto D = anyDirection<Real>();
        const auto c = sky.color(D);
        if (D.y <= 0) RC_ASSERT(c == V(1, 2, 8));
        RC_ASSERT(std::abs(c.x - (1 + 4 * std::max<Real>(D.y, 0))) <= 8 * eps<Real>);
    }));
}

TYPED_TEST(SkyOf, AGradientsZenithMayBeBlack)
{
    using Real = TypeParam;
    SkyDescription description;
    description.color = {1, 1, 1};
    description.zenith = Vec3<double>(0);
    EXPECT_EQ(Sky<Real>(description).color({0, 1, 0}), Vec3<Real>(0));
}

TYPED_TEST(SkyOf, ASunEndsAtHalfItsSizeFromItsMiddle)
{
    using Real = TypeParam;
    using V = Vec3<Real>;
    const V sunlight(100, 90, 80), blue(0, 0, Real(0.5));
    for (const double size : {0.53, 5.0, 90.0, 170.0, 180.0})
        for (const double around : {10.0, 100.0, 300.0})
        {
            SkyDescription description;
            description.color = {0, 0, 0.5};
            const auto middle = offAxis(radians<Real>(70), radians<Real>(around));
            description.sun = Sun{Vec3<double>(middle) * 1e200, {100, 90, 80}, size};
            const Sky<Real> sky(description);
            EXPECT_EQ(sky.color(middle), sunlight) << size;
            EXPECT_EQ(sky.color(-middle), blue) << size;
            for (const double side : {-1.0, 1.0}) // along the great circle through -z
            {
                const double edge = 70 + side * size / 2, step = side * 0.02;
                const auto at = [&](double angle) { return offAxis(radians<Real>(angle), radians<Real>(around)); };
                EXPECT_EQ(sky.color(at(edge - step)), sunlight) << size << ", just inside";
                EXPECT_EQ(sky.color(at(edge + step)), blue) << size << ", just outside";
            }
        }
}

TYPED_TEST(SkyOf, ASunStandsBeforeAGradient)
{
    using Real = TypeParam;
    SkyDescription description;
    description.color = {1, 1, 1};
    description.zenith = Vec3<double>(2);
    description.sun = Sun{{0, 3, 0}, {0, 0, 0}, 10};
    const Sky<Real> sky(description);
    EXPECT_EQ(sky.color({0, 1, 0}), Vec3<Real>(0)) << "the disc replaces the sky, it adds nothing to it";
    EXPECT_EQ(sky.color({1, 0, 0}), Vec3<Real>(1));
}

TYPED_TEST(SkyOf, BrightestIsTheLargestChannelAnywhere)
{
    using Real = TypeParam;
    SkyDescription description;
    description.color = {1, 3, 2};
    EXPECT_EQ(Sky<Real>(description).brightest(), 3);
    description.zenith = Vec3<double>(0, 0, 7);
    EXPECT_EQ(Sky<Real>(description).brightest(), 7);
    description.sun = Sun{{0, 1, 0}, {50, 60, 40}, 1};
    EXPECT_EQ(Sky<Real>(description).brightest(), 60);

    Image image(4, 2);
    image.at(3, 1) = {1, 100, 2};
    EXPECT_EQ(Sky<Real>(pictureSky(image, SkyMapping::latlong)).brightest(), 100);
    EXPECT_EQ(Sky<Real>(pictureSky(Image(2, 2), SkyMapping::angular)).brightest(), 0);
}

} // namespace

} // namespace rt
