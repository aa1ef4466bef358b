#include "common/files/polygon.h"

#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace rt
{

namespace
{

using Numbers = std::vector<std::array<std::size_t, 3>>;

double turn(const Corner2& a, const Corner2& b, const Corner2& c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// In how many of the triangles a point lies.
int covered(const std::vector<Corner2>& polygon, const Numbers& triangles, const Corner2& p)
{
    int count = 0;
    for (const auto& [i, j, k] : triangles)
    {
        const auto &a = polygon[i], &b = polygon[j], &c = polygon[k];
        EXPECT_GT(turn(a, b, c), 0) << "cut triangles face as the polygon does";
        count += turn(a, b, p) > 0 && turn(b, c, p) > 0 && turn(c, a, p) > 0;
    }
    return count;
}

TEST(Polygon, WithADoorIsCutAlongItsEdges)
{
    const std::vector<Corner2> doorway{{-1, -1}, {-.4, -1}, {-.4, .3}, {.4, .3}, {.4, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::size_t first = 0; first < doorway.size(); ++first) // wherever the list of its corners begins
    {
        auto polygon = doorway;
        std::rotate(polygon.begin(), polygon.begin() + std::ptrdiff_t(first), polygon.end());
        EXPECT_FALSE(isConvex(polygon));
        const auto triangles = earsOf(polygon);
        EXPECT_EQ(triangles.size(), 6U);
        EXPECT_EQ(covered(polygon, triangles, {0.01, -0.52}), 0) << "in the doorway";
        EXPECT_EQ(covered(polygon, triangles, {-0.71, -0.53}), 1);
        EXPECT_EQ(covered(polygon, triangles, {0.72, -0.51}), 1);
        EXPECT_EQ(covered(polygon, triangles, {0.013, 0.617}), 1);
    }
}

TEST(Polygon, OfAnyShapeOfAStarIsCut)
{
    std::mt19937 random(1504);
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (int i = 0; i < 100; ++i)
    {
        std::vector<Corner2> star(std::size_t(5 + i % 30));
        for (std::size_t k = 0; k < star.size(); ++k)
        {
            const double r = number(0.1, 1), angle = 2 * 3.14159265 * double(k) / double(star.size());
            star[k] = {r * std::cos(angle), r * std::sin(angle)};
        }
        const auto triangles = earsOf(star);
        ASSERT_EQ(triangles.size(), star.size() - 2);
        double area = 0, cut = 0;
        for (std::size_t k = 0; k < star.size(); ++k) area += turn({0, 0}, star[k], star[(k + 1) % star.size()]);
        for (const auto& [p, q, r] : triangles) cut += turn(star[p], star[q], star[r]);
        EXPECT_NEAR(cut, area, 1e-12);
        for (int k = 0; k < 20; ++k) EXPECT_LE(covered(star, triangles, {number(-1, 1), number(-1, 1)}), 1);
    }
}

TEST(Polygon, IsFilledByAFanIfItTurnsOneWayAndGoesRoundOnce)
{
    EXPECT_TRUE(isConvex({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    EXPECT_TRUE(isConvex({{0, 0}, {.5, 0}, {1, 0}, {1, 1}, {0, 1}})) << "a corner of 180 degrees";
    EXPECT_FALSE(isConvex({{0, 0}, {1, 0}, {.1, .1}, {0, 1}}));
    EXPECT_FALSE(isConvex({{0, 1}, {-.59, -.81}, {.95, .31}, {-.95, .31}, {.59, -.81}})) << "a star drawn in one go";
}

TEST(Polygon, IsSeenFromItsFront)
{
    std::vector<Vec3<double>> square{{7, 0, 0}, {7, 0, -4}, {7, 4, -4}, {7, 4, 0}}; // first from +x, then from -x
    for (int side = 0; side < 2; ++side)
    {
        const auto flat = flattened(square);
        EXPECT_TRUE(isConvex(flat));
        EXPECT_GT(turn(flat[0], flat[1], flat[2]), 0);
        EXPECT_EQ(flat[2][0] * flat[2][0], 1) << "its largest side is 1";
        std::reverse(square.begin(), square.end());
    }
}

} // namespace

} // namespace rt
