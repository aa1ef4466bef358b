#include "viz/drawing/lamps.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "common/base/vec.h"

namespace rt::viz
{

namespace
{

SceneDescription row(int count)
{
    SceneDescription scene;
    for (int i = 0; i < count; ++i) scene.lights.push_back({.position = {double(i), 0, 0}, .color = {1, 1, 1}});
    return scene;
}

std::vector<std::size_t> named(const SceneDescription& scene, const vec3& at)
{
    std::vector<std::size_t> found;
    const auto isNamed = namedLamps(scene, at);
    EXPECT_EQ(isNamed.size(), scene.lights.size());
    for (std::size_t i = 0; i < isNamed.size(); ++i)
        if (isNamed[i]) found.push_back(i);
    return found;
}

TEST(Lamps, AreAllNamedWhereTheyAreFew)
{
    EXPECT_TRUE(named(row(0), {0, 0, 0}).empty());
    EXPECT_EQ(named(row(int(mostNamedLamps)), {0, 0, 0}).size(), mostNamedLamps);
}

TEST(Lamps, OfManyTheStrongestAreNamed)
{
    auto scene = row(200);
    const auto near = named(scene, {100, 0, 1});
    EXPECT_EQ(near.size(), mostNamedLamps);
    EXPECT_EQ(near.front(), 94u); // of two that are equally far, the first
    EXPECT_EQ(near.back(), 105u);
    scene.lights[199].color = {0, 1e6, 0}; // far, and stronger than any other
    const auto bright = named(scene, {100, 0, 1});
    EXPECT_EQ(bright.size(), mostNamedLamps);
    EXPECT_EQ(bright.back(), 199u);
    scene.lights[100].color = {0, 0, 0};
    const auto dark = named(scene, {100, 0, 1});
    EXPECT_EQ(std::count(dark.begin(), dark.end(), 100u), 0);
}

TEST(Lamps, OnThePointItselfCount)
{
    const auto all = named(row(40), {7, 0, 0});
    EXPECT_EQ(all.size(), mostNamedLamps);
    EXPECT_EQ(std::count(all.begin(), all.end(), 7u), 1);
}

} // namespace

} // namespace rt::viz
