// The functions that every machine computes alike: as near to the truth as a double can be, and at their ends what C says.
#include <random>

#include <gtest/gtest.h>

#include "common/base/portable.h"

namespace rt::portable
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Half a last place is the best that rounding can do; a long double knows where the truth lies to a thousandth of it.
constexpr double best = std::numeric_limits<long double>::digits > 60 ? 0.502 : 1;

/// How far `got` is from the long double, in last places.
double lastPlaces(double got, long double truth)
{
    const double size = std::abs(double(truth));
    const long double place = (long double)(std::nextafter(size, infinite)) - (long double)(size);
    return double(std::abs(((long double)(got)-truth) / place));
}

struct Random
{
    std::mt19937_64 engine{1};
    double in(double low, double high) { return low + (high - low) * (double(engine() >> 11) * 0x1p-53); }
    /// Of any size, also very near to 0.
    double small(double least) { return std::exp(in(std::log(least), 0)); }
};

template <class Own, class Truth, class Arguments>
void holds(const char* name, const Own& own, const Truth& truth, const Arguments& arguments)
{
    for (int i = 0; i < 20000; ++i)
    {
        const auto [x, y] = arguments(i);
        const double got = own(x, y);
        ASSERT_LE(lastPlaces(got, truth(x, y)), best) << name << "(" << x << ", " << y << ") = " << got;
        const auto a = float(x), b = float(y);
        ASSERT_EQ(own(a, b), float(own(double(a), double(b)))) << name << " of floats " << a << ", " << b;
    }
}

TEST(Portable, PowersAreRoundedWell)
{
    Random random;
    const auto own = [](auto x, auto y) { return pow(x, y); };
    const auto truth = [](long double x, long double y) { return std::pow(x, y); };
    holds("pow of cosines", own, truth, [&](int i) {
        return std::array{i % 2 ? random.in(0.5, 1) : 1 - random.small(1e-16), random.in(0, i % 3 ? 20 : 800)};
    });
    holds("pow", own, truth, [&](int) { return std::array{random.small(1e-300) * 1e10, random.in(-0.9, 0.9)}; });
}

TEST(Portable, AnglesAndLengthsAreRoundedWell)
{
    Random random;
    const auto pair = [&](int i) {
        const double x = random.in(-1, 1), y = random.in(-1, 1);
        return std::array{i % 3 == 0 ? x * random.small(1e-200) : x, i % 3 == 1 ? y * random.small(1e-200) : y};
    };
    holds(
        "atan2", [](auto y, auto x) { return atan2(y, x); },
        [](long double y, long double x) { return std::atan2(y, x); }, pair);
    holds(
        "hypot", [](auto x, auto y) { return hypot(x, y); },
        [](long double x, long double y) { return std::hypot(x, y); }, pair);
    holds(
        "acos", [](auto x, auto) { return acos(x); }, [](long double x, long double) { return std::acos(x); },
        [&](int i) {
            const double near = random.small(1e-16);
            return std::array{i % 2 ? random.in(-1, 1) : i % 4 ? 1 - near : near - 1, 0.0};
        });
    const auto angle = [&](int i) { return std::array{i % 2 ? random.in(0, 2) : random.small(1e-20), 0.0}; };
    holds(
        "sin", [](auto x, auto) { return sin(x); }, [](long double x, long double) { return std::sin(x); }, angle);
    holds(
        "tan", [](auto x, auto) { return tan(x); }, [](long double x, long double) { return std::tan(x); }, angle);
}

TEST(Portable, EndsAreWhatCSays)
{
    const double none = std::numeric_limits<double>::quiet_NaN(), least = std::numeric_limits<double>::denorm_min(),
                 most = std::numeric_limits<double>::max();
    const double values[] = {0, least, 1e-310, 1e-30, 0.5, 0.75, 1, 1.5, 2, 3, 1e30, most, infinite, none};
    const auto same = [](double got, double expected, const auto&... arguments) {
        const bool equal =
            got == expected || (std::isnan(got) && std::isnan(expected)) || lastPlaces(got, expected) <= 1;
        EXPECT_TRUE(equal) << got << ", expected " << expected << " of "
                           << testing::PrintToString(std::array{arguments...});
    };
    for (const double a : values)
        for (const double x : {a, -a})
        {
            if (!(std::abs(x) > 2)) same(sin(std::abs(x)), std::sin(std::abs(x)), x);
            same(acos(x), std::acos(x), x);
            for (const double b : values)
                for (const double y : {b, -b})
                {
                    same(pow(x, y), std::pow(x, y), x, y);
                    if (!std::isnan(x) && !std::isnan(y)) same(hypot(x, y), std::hypot(x, y), x, y);
                    if (std::abs(x) < 1e300 && std::abs(y) < 1e300)
                    {
                        same(atan2(y, x), std::atan2(y, x), y, x);
                        EXPECT_EQ(std::signbit(atan2(y, x)), std::signbit(std::atan2(y, x))) << y << ", " << x;
                    }
                }
        }
    EXPECT_EQ(acos(-1.0), std::acos(-1.0));
    EXPECT_EQ(acos(-1.0F), std::acos(-1.0F));
    EXPECT_EQ(tan(0.0F), 0);
}

} // namespace

} // namespace rt::portable
