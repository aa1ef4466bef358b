#include "viz/state/energy.h"

#include <gtest/gtest.h>
#include <limits>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"

namespace rt::viz
{

namespace
{

RayTree::Node nodeOf(int depth, const Vec3<double>& throughput, const Vec3<double>& contribution)
{
    RayTree::Node node;
    node.depth = depth;
    node.throughput = throughput;
    node.contribution = contribution;
    return node;
}

RayTree treeOf(std::vector<RayTree::Node> nodes)
{
    RayTree tree;
    for (auto& node : nodes)
    {
        node.id = int(tree.nodes.size());
        tree.nodes.push_back(node);
    }
    return tree;
}

RayTree small()
{
    return treeOf({nodeOf(0, {1, 1, 1}, {2, 2, 2}), nodeOf(1, {0.5, 0.25, 0}, {1, 1, 1}),
                   nodeOf(1, {0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}), nodeOf(2, {0.125, 0, 0}, {0.5, 0.5, 0.5})});
}

TEST(Energy, SumsTheRaysOfEachDepth)
{
    const auto energy = energyPerDepth(small());
    ASSERT_EQ(energy.depths.size(), 3U);
    EXPECT_EQ(energy.depths[0].weight, Vec3<double>(1, 1, 1));
    EXPECT_EQ(energy.depths[1].depth, 1);
    EXPECT_EQ(energy.depths[1].rays, 2);
    EXPECT_EQ(energy.depths[1].weight, Vec3<double>(0.75, 0.5, 0.25));
    EXPECT_EQ(energy.depths[1].gathered, Vec3<double>(1.5, 1.5, 1.5));
    EXPECT_EQ(energy.gathered(), Vec3<double>(4, 4, 4));
    EXPECT_EQ(energy.broken, 0);
}

TEST(Energy, OfALessonsTreeIsTheRootsRadianceAndADepthCarriesNoMoreThanTheOneBefore)
{
    auto scene = loadScene(projectFile("lessons/06_fresnel/scenes/half_and_glass.toml"));
    const auto* lesson = findLesson(6);
    ASSERT_TRUE(lesson);
    int deepTrees = 0;
    for (int y = 0; y < scene.camera.height; y += 37)
        for (int x = 0; x < scene.camera.width; x += 41)
        {
            const auto tree = lesson->inspect(scene, Precision::doubled, std::array{x, y});
            const auto energy = energyPerDepth(tree);
            const auto sum = energy.gathered(), root = tree.nodes[0].radiance;
            // Each contribution is rounded a few times on its way, and they are added in another order.
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], root[c], 1e-13 * (1 + root[c])) << x << ',' << y;
            for (std::size_t i = 1; i < energy.depths.size(); ++i)
                EXPECT_LE(largestChannel(energy.depths[i].weight),
                          largestChannel(energy.depths[i - 1].weight) * (1 + 1e-13));
            deepTrees += energy.depths.size() > 3;
        }
    EXPECT_GT(deepTrees, 0);
}

TEST(Energy, CountsOnlyWhatIsAskedFor)
{
    const auto energy = energyPerDepth(
        small(), [](int id) { return id != 2; }, [](int id) { return id == 3; });
    ASSERT_EQ(energy.depths.size(), 3U);
    EXPECT_EQ(energy.depths[1].rays, 1);
    EXPECT_EQ(energy.depths[1].weight, Vec3<double>(0.5, 0.25, 0));
    EXPECT_EQ(energy.gathered(), Vec3<double>(0.5, 0.5, 0.5));
}

TEST(Energy, LeavesOutWhatIsNotANumberAndSaysSo)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    auto tree = small();
    tree.nodes[1].contribution.y = nan;
    tree.nodes[2].throughput.x = inf;
    const auto energy = energyPerDepth(tree);
    EXPECT_EQ(energy.broken, 2);
    EXPECT_EQ(energy.gathered(), Vec3<double>(2.5, 2.5, 2.5));
    EXPECT_EQ(shareText(energy), "depth 0-2 give 100 %");
}

TEST(Energy, OfNothingIsNothing)
{
    const auto energy = energyPerDepth({});
    EXPECT_TRUE(energy.depths.empty());
    EXPECT_TRUE(cumulativeShares(energy).empty());
    EXPECT_EQ(shareText(energy), "");
    EXPECT_TRUE(grouped(energy, 3).empty());
    // A black pixel: rays, but no light.
    EXPECT_EQ(shareText(energyPerDepth(treeOf({nodeOf(0, {1, 1, 1}, {0, 0, 0})}))), "");
}

TEST(Energy, NamesTheDepthsThatGiveNearlyAll)
{
    const auto text = [](std::vector<double> shares) {
        std::vector<RayTree::Node> nodes;
        for (std::size_t i = 0; i < shares.size(); ++i)
            nodes.push_back(nodeOf(int(i), {1, 1, 1}, Vec3<double>(shares[i])));
        return shareText(energyPerDepth(treeOf(nodes)));
    };
    EXPECT_EQ(text({1}), "depth 0 gives 100 %");
    EXPECT_EQ(text({97, 3}), "depth 0 gives 97 %");
    EXPECT_EQ(text({50, 30, 17, 2, 1}), "depth 0-2 give 97 %");
    EXPECT_EQ(text({50, 30, 14, 6}), "depth 0-3 give 100 %");
    EXPECT_EQ(text({99.999, 0.001}), "depth 0 gives 99.9 %");
}

TEST(Energy, SharesGrowToOne)
{
    const auto shares = cumulativeShares(energyPerDepth(small()));
    ASSERT_EQ(shares.size(), 3U);
    EXPECT_DOUBLE_EQ(shares[0], 0.5);
    EXPECT_DOUBLE_EQ(shares[1], 0.875);
    EXPECT_EQ(shares[2], 1);
}

TEST(Energy, TheDeepestAreGroupedWhereThereIsNoRoom)
{
    const auto energy = energyPerDepth(small());
    const auto groups = grouped(energy, 2);
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[1].depth, 1);
    EXPECT_EQ(groups[1].rays, 3);
    EXPECT_EQ(groups[1].weight, Vec3<double>(0.75, 0.5, 0.25)); // of depth 1
    EXPECT_EQ(groups[1].gathered, Vec3<double>(2, 2, 2));
    EXPECT_EQ(grouped(energy, 7).size(), 3U);
}

TEST(Luminance, OfWhiteIsOne)
{
    EXPECT_DOUBLE_EQ(luminance({1, 1, 1}), 1);
    EXPECT_GT(luminance({0, 1, 0}), luminance({1, 0, 0}));
    EXPECT_GT(luminance({1, 0, 0}), luminance({0, 0, 1}));
}

} // namespace

} // namespace rt::viz
