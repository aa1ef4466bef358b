// sin, tan, acos, atan2, hypot and pow with the same bits on every machine, for float and double. C libraries differ: of
// glibc's powers one in a thousand depends on the processor, and of musl's arc tangents one in six is not glibc's. Here all is
// made of + - * / and square roots, which IEEE 754 rounds in one way, with twice the digits of a double where they count: what
// comes out is the correctly rounded number, in a million trials always (but for powers below 1e-308).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace rt::portable
{

namespace detail
{

/// hi + lo: lo is what hi lacks, at most half of its last place.
struct Two
{
    double hi = 0, lo = 0;
};

/// Exactly a + b, if |a| >= |b| or a is 0.
inline Two ordered(double a, double b)
{
    const double s = a + b;
    return {s, b - (s - a)};
}

/// Exactly a + b (Knuth).
inline Two sum(double a, double b)
{
    const double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
}

/// Exactly a * b (Dekker), by halves of 26 bits: not every processor has fma.
inline Two product(double a, double b)
{
    const auto upper = [](double x) {
        const double shifted = 0x1p27 * x + x;
        return shifted - (shifted - x);
    };
    const double p = a * b, ah = upper(a), bh = upper(b), al = a - ah, bl = b - bh;
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

inline Two operator-(const Two& a)
{
    return {-a.hi, -a.lo};
}

inline Two operator+(const Two& a, const Two& b)
{
    const Two high = sum(a.hi, b.hi), low = sum(a.lo, b.lo);
    const Two both = ordered(high.hi, high.lo + low.hi);
    return ordered(both.hi, both.lo + low.lo);
}

inline Two operator*(const Two& a, const Two& b)
{
    const Two p = product(a.hi, b.hi);
    return ordered(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

inline Two operator/(const Two& a, const Two& b)
{
    const double q = a.hi / b.hi;
    const Two back = product(q, b.hi);
    return ordered(q, (((a.hi - back.hi) - back.lo) + (a.lo - q * b.lo)) / b.hi);
}

/// The square root of a >= 0.
inline Two root(const Two& a)
{
    const double r = std::sqrt(a.hi);
    if (r == 0) return {};
    const Two back = product(r, r);
    return ordered(r, (((a.hi - back.hi) - back.lo) + a.lo) / (2 * r));
}

/// x + sign x^3 / 3 + x^5 / 5 + sign x^7 / 7 ...: the arc tangent with sign -1, its hyperbolic sister with 1; |x| <= 1/3.
inline Two oddSeries(const Two& x, double sign)
{
    Two rest;
    for (int n = 69; n >= 1; n -= 2) rest = Two{1} / Two{double(n)} + Two{sign} * x * x * rest;
    return x * rest;
}

/// e^x, for x from 0 to 1.
inline Two powerSeries(const Two& x)
{
    Two rest{1};
    for (int n = 30; n >= 1; --n) rest = Two{1} + x / Two{double(n)} * rest;
    return rest;
}

/// What is looked up, made once: a program needs no constants of many digits.
struct Tables
{
    static constexpr int steps = 64;   ///< of the arguments of log and atan
    static constexpr int parts = 32;   ///< of a factor of two
    Two ln2, halfPi;                   ///< log 2 and pi / 2
    double ln2Upper, ln2Lower, perLn2; ///< log 2: 24 bits of it, so that a multiple is exact, the rest, the inverse
    std::array<Two, 3 * steps / 2 + 1> log{};       ///< of i / steps, from 3/4 to 3/2
    std::array<Two, steps + 1> atan{};              ///< of i / steps
    std::array<Two, std::size_t(parts)> exponent{}; ///< 2^(i / parts)

    Tables()
    {
        const auto logarithm = [](double x) { return Two{2} * oddSeries(Two{x - 1} / Two{x + 1}, 1); };
        ln2 = logarithm(2);
        ln2Upper = double(float(ln2.hi));
        ln2Lower = (ln2.hi - ln2Upper) + ln2.lo;
        perLn2 = 1 / ln2.hi;
        for (int i = 3 * steps / 4; i <= 3 * steps / 2; ++i) log[std::size_t(i)] = logarithm(double(i) / steps);
        // atan b - atan a = atan((b - a) / (1 + a b))
        for (int i = 0; i < steps; ++i)
            atan[std::size_t(i) + 1] =
                atan[std::size_t(i)] + oddSeries(Two{double(steps)} / Two{double(steps * steps + i * (i + 1))}, -1);
        halfPi = Two{2} * atan[steps];
        for (int i = 0; i < parts; ++i) exponent[std::size_t(i)] = powerSeries(Two{double(i) / parts} * ln2);
    }
};

inline const Tables& tables()
{
    static const Tables made;
    return made;
}

/// The logarithm of a finite x > 0, to some 68 bits.
inline Two logarithm(double x)
{
    const Tables& known = tables();
    int power = 0;
    if (x < std::numeric_limits<double>::min())
    {
        x *= 0x1p54;
        power = -54;
    }
    // x = 2^power m, m from 3/4 to 3/2 and next to f = i / 64: log m = log f + 2 atanh((m - f) / (m + f))
    const auto bits = std::bit_cast<std::int64_t>(x);
    const std::int64_t doublings = (bits - std::bit_cast<std::int64_t>(0.75)) >> 52;
    power += int(doublings);
    const double m = std::bit_cast<double>(bits - doublings * (std::int64_t(1) << 52));
    const int i = int(m * Tables::steps + 0.5);
    const double f = double(i) / Tables::steps, difference = m - f;
    const Two whole = sum(m, f);
    const double inverse = 1 / whole.hi, s = difference * inverse, z = s * s;
    const Two back = product(s, whole.hi);
    const double lacks = (((difference - back.hi) - back.lo) - s * whole.lo) * inverse;
    const double tail = 2 * s * z * (1.0 / 3 + z * (1.0 / 5 + z * (1.0 / 7 + z * (1.0 / 9 + z * (1.0 / 11)))));
    const Two& near = known.log[std::size_t(i)];
    const Two first = sum(power * known.ln2Upper, near.hi), second = sum(first.hi, 2 * s);
    const double low = power * known.ln2Lower + near.lo + 2 * lacks + tail;
    return ordered(second.hi, first.lo + second.lo + low);
}

/// e^x.
inline double exponential(const Two& x)
{
    if (!(std::abs(x.hi) < 1000)) return x.hi > 0 ? std::numeric_limits<double>::infinity() : x.hi < 0 ? 0 : x.hi;
    const Tables& known = tables();
    // x = n log 2 / 32 + r
    const double parts = x.hi * known.perLn2 * Tables::parts;
    const int n = int(parts + (parts < 0 ? -0.5 : 0.5)), power = n >> 5;
    const Two& factor = known.exponent[std::size_t(n & (Tables::parts - 1))];
    const double share = double(n) / Tables::parts;
    const Two r = sum(x.hi - share * known.ln2Upper, x.lo - share * known.ln2Lower);
    const double h = r.hi;
    const double cubic =
        1.0 / 6 + h * (1.0 / 24 + h * (1.0 / 120 + h * (1.0 / 720 + h * (1.0 / 5040 + h * (1.0 / 40320)))));
    const double tail = r.lo + h * h * (0.5 + h * cubic);
    // factor * (1 + r.hi + tail)
    const Two linear = product(factor.hi, r.hi), main = ordered(factor.hi, linear.hi);
    const double result = main.hi + (main.lo + (linear.lo + factor.lo + factor.lo * r.hi + factor.hi * tail));
    // In two steps, of which the first is exact: 2^power itself may be too small or too large.
    const auto scale = [](int exponent) { return std::bit_cast<double>(std::uint64_t(exponent + 1023) << 52); };
    return result * scale(power / 2) * scale(power - power / 2);
}

/// The angle of (x, y) for x, y >= 0 that are not both 0.
inline Two angle(const Two& y, const Two& x)
{
    const Tables& known = tables();
    const bool steep = y.hi > x.hi;
    const Two &low = steep ? x : y, &high = steep ? y : x;
    // atan(low / high) = atan c + atan((low - c high) / (high + c low))
    const int i = int(low.hi / high.hi * Tables::steps + 0.5);
    const Two c{double(i) / Tables::steps}, u = (low + -(c * high)) / (high + c * low);
    const double z = u.hi * u.hi;
    const double tail = -u.hi * z * (1.0 / 3 - z * (1.0 / 5 - z * (1.0 / 7 - z * (1.0 / 9 - z * (1.0 / 11)))));
    const Two flat = known.atan[std::size_t(i)] + Two{u.hi, u.lo + tail};
    return steep ? known.halfPi + -flat : flat;
}

/// Sine and cosine of an angle from 0 to 2. Slow: cameras and suns ask once.
inline std::array<Two, 2> sineAndCosine(double x)
{
    const Two squared = product(x, x);
    Two sine{1}, cosine{1};
    for (int n = 31; n >= 3; n -= 2)
    {
        sine = Two{1} + -(squared / Two{double(n * (n - 1))} * sine);
        cosine = Two{1} + -(squared / Two{double((n - 1) * (n - 2))} * cosine);
    }
    return {Two{x} * sine, cosine};
}

[[gnu::noinline]] inline double pow(double x, double y)
{
    constexpr double infinite = std::numeric_limits<double>::infinity(),
                     none = std::numeric_limits<double>::quiet_NaN();
    if (x == 1 || y == 0) return 1;
    if (!(x == x && y == y)) return none;
    if (std::signbit(x))
    {
        const bool whole = std::floor(y) == y, odd = whole && std::floor(y / 2) * 2 != y;
        if (!whole && x < 0 && x != -infinite) return none;
        return odd ? -pow(-x, y) : pow(-x, y);
    }
    if (x == 0 || x == infinite) return (x == 0) == (y > 0) ? 0 : infinite;
    const double exponent = std::min(std::max(y, -0x1p70), 0x1p70); // beyond, all is 0 or infinite
    const Two log = logarithm(x), power = product(log.hi, exponent);
    return exponential({power.hi, power.lo + log.lo * exponent});
}

[[gnu::noinline]] inline double atan2(double y, double x)
{
    const double up = std::abs(y), side = std::abs(x);
    if (!(up + side <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::quiet_NaN();
    Two a;
    if (up + side > 0) a = angle({up}, {side});
    if (std::signbit(x)) a = Two{2} * tables().halfPi + -a;
    return std::copysign(a.hi, y);
}

[[gnu::noinline]] inline double acos(double x)
{
    const double size = std::abs(x);
    if (!(size <= 1)) return std::numeric_limits<double>::quiet_NaN();
    const Two squared = product(size, size), other = ordered(1, -squared.hi);
    const Two a = angle(root(ordered(other.hi, other.lo - squared.lo)), {size});
    return x < 0 ? (Two{2} * tables().halfPi + -a).hi : a.hi;
}

[[gnu::noinline]] inline double hypot(double x, double y)
{
    using Limits = std::numeric_limits<double>;
    const double size = std::max(std::abs(x), std::abs(y));
    if (!(size > 0 && size <= Limits::max())) return size + std::abs(y);
    constexpr double least = Limits::min() / Limits::epsilon() / Limits::epsilon();
    if (size * size < least || size * size > Limits::max() / 4) // the digits of the squares would not fit
    {
        const int exponent = std::ilogb(size);
        return std::ldexp(hypot(std::ldexp(x, -exponent), std::ldexp(y, -exponent)), exponent);
    }
    return root(product(x, x) + product(y, y)).hi;
}

[[gnu::noinline]] inline double sin(double x)
{
    return sineAndCosine(x)[0].hi;
}

[[gnu::noinline]] inline double tan(double x)
{
    const auto [sine, cosine] = sineAndCosine(x);
    return (sine / cosine).hi;
}

/// float is computed in double, and long double by the C library: its format differs between machines anyway.
template <std::floating_point Real>
inline constexpr bool isOurs = sizeof(Real) <= sizeof(double);

} // namespace detail

/// x to the power of y.
template <std::floating_point Real>
Real pow(Real x, Real y)
{
    if constexpr (detail::isOurs<Real>)
        return Real(detail::pow(double(x), double(y)));
    else
        return std::pow(x, y);
}

/// The angle of (x, y) to the x axis, from -pi to pi; for a point within 1e300 of the middle.
template <std::floating_point Real>
Real atan2(Real y, Real x)
{
    if constexpr (detail::isOurs<Real>)
        return Real(detail::atan2(double(y), double(x)));
    else
        return std::atan2(y, x);
}

/// The angle from 0 to pi whose cosine is x.
template <std::floating_point Real>
Real acos(Real x)
{
    if constexpr (detail::isOurs<Real>)
        return Real(detail::acos(double(x)));
    else
        return std::acos(x);
}

/// The length of (x, y).
template <std::floating_point Real>
Real hypot(Real x, Real y)
{
    if constexpr (detail::isOurs<Real>)
        return Real(detail::hypot(double(x), double(y)));
    else
        return std::hypot(x, y);
}

/// The sine of an angle from 0 to 2.
template <std::floating_point Real>
Real sin(Real x)
{
    if constexpr (detail::isOurs<Real>)
        return Real(detail::sin(double(x)));
    else
        return std::sin(x);
}

/// The tangent of an angle from 0 to 2.
template <std::floating_point Real>
Real tan(Real x)
{
    if constexpr (detail::isOurs<Real>)
        return Real(detail::tan(double(x)));
    else
        return std::tan(x);
}

} // namespace rt::portable
