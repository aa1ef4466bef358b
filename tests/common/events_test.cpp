#include "common/tree/events.h"

#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"

namespace rt
{

namespace
{

RayTree treeOf(const LessonEntry& lesson)
{
    const auto scene = loadScene(projectFile(lesson.scene));
    return lesson.inspect(scene, Precision::doubled, scene.pixel());
}

RayTree withoutSteps(RayTree tree)
{
    for (auto& node : tree.nodes) node.step = node.returnStep = 0;
    for (auto& shadow : tree.shadows) shadow.step = 0;
    for (auto& capped : tree.capped) capped.step = 0;
    return tree;
}

class Events : public testing::TestWithParam<const LessonEntry*>
{
};

TEST_P(Events, EveryRayIsFollowedBeforeItReturnsAndChildrenReturnBeforeTheirParent)
{
    for (const auto& tree : {treeOf(*GetParam()), withoutSteps(treeOf(*GetParam()))})
    {
        std::vector<int> followed(tree.nodes.size(), -1), returned(tree.nodes.size(), -1);
        std::size_t shadows = 0, capped = 0;
        const auto events = eventsOf(tree);
        for (std::size_t i = 0; i < events.size(); ++i)
        {
            const auto& event = events[i];
            const auto node = std::size_t(event.node);
            if (event.kind == Event::Kind::follow) followed[node] = int(i);
            if (event.kind == Event::Kind::returns) returned[node] = int(i);
            shadows += event.kind == Event::Kind::shadow;
            capped += event.kind == Event::Kind::notFollowed;
            if (event.kind != Event::Kind::follow)
            {
                EXPECT_GE(followed[node], 0);
                EXPECT_LE(returned[node], int(i)) << "nothing happens to a ray that has returned";
                EXPECT_TRUE(returned[node] < 0 || returned[node] == int(i));
            }
            EXPECT_FALSE(describe(tree, event).empty());
        }
        EXPECT_EQ(shadows, tree.shadows.size());
        EXPECT_EQ(capped, tree.capped.size());
        EXPECT_EQ(events.size(), 2 * tree.nodes.size() + shadows + capped);
        for (const auto& node : tree.nodes)
        {
            EXPECT_GT(returned[std::size_t(node.id)], followed[std::size_t(node.id)]);
            if (node.parent < 0) continue;
            EXPECT_GT(followed[std::size_t(node.id)], followed[std::size_t(node.parent)]);
            EXPECT_LT(returned[std::size_t(node.id)], returned[std::size_t(node.parent)]);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OfLesson, Events, testing::ValuesIn(lessons().begin(), lessons().end()),
                         [](const auto& lesson) { return std::string("L") + std::to_string(lesson.param->number); });

TEST(Events, AnExerciseThatWasNotFinishedHasNotReturned)
{
    auto tree = treeOf(*findLesson(1));
    ASSERT_EQ(tree.nodes.size(), 1U);
    tree.nodes[0].returnStep = 0;
    for (const auto& event : eventsOf(tree)) EXPECT_NE(event.kind, Event::Kind::returns);
}

TEST(Events, AChainOfAHundredThousandRaysNeedsNoStack)
{
    RayTree tree;
    for (int i = 0; i < 100000; ++i)
    {
        RayTree::Node node;
        node.id = i;
        node.parent = i - 1;
        node.depth = i;
        tree.nodes.push_back(node);
    }
    const auto events = eventsOf(tree);
    ASSERT_EQ(events.size(), 200000U);
    EXPECT_EQ(events[99999].node, 99999);
    EXPECT_EQ(events.back().node, 0);
}

TEST(Events, AreToldInWords)
{
    const auto tree = treeOf(*findLesson(2));
    const auto events = eventsOf(tree);
    EXPECT_EQ(describe(tree, events[0]).find("camera ray [0] hits "), 0U) << describe(tree, events[0]);
    EXPECT_EQ(describe(tree, events.back()).find("camera ray [0] returns ("), 0U);
}

} // namespace

} // namespace rt
