// The hierarchy holds what it should, however it is built. What rays find in it: bvh_test.cpp.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "common/search/bvh_build.h"

namespace rt
{

namespace
{

std::vector<Box<float>> randomBoxes(int count)
{
    std::mt19937 engine(2);
    std::uniform_real_distribution<float> in(-1, 1);
    std::vector<Box<float>> boxes(std::size_t(count), Box<float>{});
    for (auto& box : boxes)
    {
        box.add({in(engine), in(engine), in(engine)});
        box.add(box.low + 0.01F);
    }
    return boxes;
}

TEST(Hierarchy, IsTheSameWhetherPartsAreBuiltAtOnceOrOneByOne)
{
    const auto boxes = randomBoxes(30000);
    const auto alone = BvhBuilder{boxes, boxes.size()}.build();
    for (const std::size_t apartFrom : {10, 1000, 16384})
    {
        const auto tree = BvhBuilder{boxes, apartFrom}.build();
        ASSERT_EQ(tree.nodes.size(), alone.nodes.size());
        EXPECT_EQ(tree.leaves, alone.leaves);
        for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        {
            const auto &a = tree.nodes[i], &b = alone.nodes[i];
            ASSERT_TRUE(std::ranges::equal(a.planes, b.planes) && std::ranges::equal(a.child, b.child) &&
                        a.children == b.children)
                << i;
        }
    }
}

TEST(Hierarchy, HoldsEachShapeOnce)
{
    const auto boxes = randomBoxes(20000);
    std::vector<int> times(boxes.size());
    const auto tree = BvhBuilder{boxes}.build();
    std::vector<std::int32_t> waiting{0};
    while (!waiting.empty())
    {
        const auto& node = tree.nodes.at(std::size_t(waiting.back()));
        waiting.pop_back();
        for (int k = 0; k < bvhWidth; ++k)
        {
            if (!(node.children >> k & 1)) continue;
            if (node.child[k] >= 0)
                waiting.push_back(node.child[k]);
            else
                for (const auto id : tree.leaves.at(std::size_t(~node.child[k])))
                    if (id >= 0) ++times.at(std::size_t(id));
        }
    }
    EXPECT_EQ(std::ranges::count(times, 1), std::ptrdiff_t(boxes.size()));
}

} // namespace

} // namespace rt
