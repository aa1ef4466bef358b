// Numbers from a seed: the same on every machine, which <random>'s distributions do not promise.
#pragma once

#include <random>
#include <string_view>

#include "common/base/vec.h"
#include "tests/grade/digest.h"

namespace rt::grade
{

class Random
{
public:
    using V = Vec3<double>;

    /// Different keys or names give numbers that have nothing to do with each other.
    Random(std::string_view key, std::string_view name)
    {
        std::array<std::uint32_t, 8> words{};
        const auto bytes = hmacSha256(key, name);
        for (std::size_t i = 0; i < bytes.size(); ++i) words[i / 4] = words[i / 4] << 8 | bytes[i];
        std::seed_seq seed(words.begin(), words.end());
        bits.seed(seed);
    }

    /// In [low, high).
    double in(double low, double high) { return low + (high - low) * (double(bits() >> 11) / 9007199254740992.0); }
    /// From low to high, both included.
    int whole(int low, int high) { return low + int(bits() % std::uint64_t(high - low + 1)); }
    bool coin() { return bits() >> 63; }
    double sign() { return coin() ? 1 : -1; }

    V vector(double low, double high)
    {
        const double x = in(low, high), y = in(low, high);
        return {x, y, in(low, high)};
    }
    /// A colour with three clearly different channels, so that none can stand for another.
    V color()
    {
        const double a = in(0.75, 0.95), b = in(0.45, 0.65), c = in(0.15, 0.35);
        const V all[] = {{a, b, c}, {b, c, a}, {c, a, b}, {a, c, b}, {b, a, c}, {c, b, a}};
        return all[whole(0, 5)];
    }
    /// A unit vector, all directions alike.
    V direction()
    {
        while (true)
        {
            const V v = vector(-1, 1);
            const double length = glm::length(v);
            if (length > 0.1 && length < 1) return v / length;
        }
    }
    /// A unit vector at right angles to the unit vector n.
    V across(const V& n)
    {
        while (true)
        {
            const V v = cross(direction(), n);
            if (glm::length(v) > 0.1) return glm::normalize(v);
        }
    }

private:
    std::mt19937_64 bits;
};

} // namespace rt::grade
