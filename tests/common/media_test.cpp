// What the surfaces of glass along a ray say of the media between them, and where two of them contradict each other.
#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/tree/ray_tree.h"
#include "lessons/programs/registry.h"

namespace rt
{

namespace
{

/// Spheres in one another, of which the inner one says `outside` of what is around it.
RayTree nestedBalls(const std::string& outside)
{
    const auto scene = parseScene(R"(
[trace]
fresnel = "none"
[[sphere]]
center = [0, 0, 0]
radius = 2
material = "water"
[[sphere]]
center = [0, 0, 0]
radius = 1
material = "glass"
[materials.water]
ior = 1.25
[materials.glass]
ior = 1.5
)" + outside,
                                  "balls.toml");
    return lessons()[7]->inspect(scene, Precision::doubled, GivenRay{{0, 0, 5}, {0, 0, -1}});
}

TEST(Media, TellWhereTwoSurfacesContradictEachOther)
{
    const auto wrong = nestedBalls(""), right = nestedBalls("ior_outside = 1.25");
    ASSERT_EQ(wrong.nodes.size(), 5U); // in and out of both
    const std::vector<bool> contradicted{false, true, false, true, false};
    const std::vector<double> medium{0, 1.25, 1.5, 1, 1};
    for (int i = 0; i < 5; ++i)
    {
        EXPECT_EQ(wrong.isContradicted(i), contradicted[std::size_t(i)]) << i;
        EXPECT_FALSE(right.isContradicted(i)) << i;
        EXPECT_EQ(wrong.mediumOf(i).value_or(0), medium[std::size_t(i)]) << i;
    }
    const std::string sentence =
        "sphere1 says n1 = 1, but the ray comes through 1.25: is its ior_outside right, or that of the surface before?";
    EXPECT_EQ(contradictionText(wrong, 1), sentence);
    EXPECT_EQ(firstContradiction(wrong), "balls.toml: ray 1 of the tree: " + sentence);
    EXPECT_EQ(firstContradiction(right), "");
    EXPECT_NE(toText(wrong).find("! " + sentence), std::string::npos) << toText(wrong);
    EXPECT_NE(toJson(wrong).find("\"medium\": 1.25"), std::string::npos);
    EXPECT_EQ(toJson(right).find("\"medium\""), std::string::npos);
}

} // namespace

} // namespace rt
