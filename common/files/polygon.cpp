#include "common/files/polygon.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace rt
{

namespace
{

/// Twice the area of a, b, c; positive if they turn to the left.
double turn(const Corner2& a, const Corner2& b, const Corner2& c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

constexpr double roundingOfTurns = 64 * std::numeric_limits<double>::epsilon(); ///< of a polygon of size 1

} // namespace

std::vector<Corner2> flattened(const std::vector<Vec3<double>>& corners)
{
    Vec3<double> normal(0), size(0);
    for (const auto& corner : corners) size = max(size, abs(corner - corners[0]));
    const double scale = largestChannel(size);
    const auto at = [&](std::size_t i) { return (corners[i % corners.size()] - corners[0]) / scale; };
    for (std::size_t i = 0; i < corners.size(); ++i) normal += cross(at(i), at(i + 1));
    const auto n = abs(normal);
    const int z = n.x > n.y ? (n.x > n.z ? 0 : 2) : (n.y > n.z ? 1 : 2);
    int x = (z + 1) % 3, y = (z + 2) % 3;
    if (normal[z] < 0) std::swap(x, y);
    std::vector<Corner2> flat;
    for (std::size_t i = 0; i < corners.size(); ++i) flat.push_back({at(i)[x], at(i)[y]});
    return flat;
}

bool isConvex(const std::vector<Corner2>& polygon)
{
    const auto n = polygon.size();
    // A star drawn in one go turns one way too, but goes round twice: its fan turns back.
    for (std::size_t i = 0; i < n; ++i)
        if (turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) < -roundingOfTurns ||
            turn(polygon[0], polygon[i], polygon[(i + 1) % n]) < -roundingOfTurns)
            return false;
    return true;
}

std::vector<std::array<std::size_t, 3>> earsOf(const std::vector<Corner2>& polygon)
{
    std::vector<std::array<std::size_t, 3>> triangles;
    std::vector<std::size_t> left(polygon.size());
    std::iota(left.begin(), left.end(), std::size_t(0));
    const auto isEar = [&](std::size_t i, std::size_t j, std::size_t k) {
        const auto &a = polygon[i], &b = polygon[j], &c = polygon[k];
        if (!(turn(a, b, c) > 0)) return false;
        return std::ranges::none_of(left, [&](std::size_t other) {
            const auto& p = polygon[other];
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    };
    for (std::size_t at = 0, tried = 0; left.size() > 3;)
    {
        const auto n = left.size();
        const std::size_t i = left[(at + n - 1) % n], j = left[at % n], k = left[(at + 1) % n];
        const bool isFlat = turn(polygon[i], polygon[j], polygon[k]) == 0;
        if (!isFlat && !isEar(i, j, k))
        {
            if (++tried > n) return {};
            ++at;
            continue;
        }
        triangles.push_back({i, j, k});
        left.erase(left.begin() + std::ptrdiff_t(at % n));
        at = at % n;
        tried = 0;
    }
    triangles.push_back({left[0], left[1], left[2]});
    if (turn(polygon[left[0]], polygon[left[1]], polygon[left[2]]) < 0) return {};
    return triangles;
}

} // namespace rt
