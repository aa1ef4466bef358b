#include "viz/drawing/tree_layout.h"

#include <map>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/common/growth.h"

namespace rt::viz
{

namespace
{

RayTree::Node nodeOf(int id, int parent, int depth)
{
    RayTree::Node node;
    node.id = id;
    node.parent = parent;
    node.depth = depth;
    node.kind = parent < 0 ? RayKind::camera : RayKind::reflected;
    return node;
}

/// `parents[i]` < i is the parent of node i; node 0 is the root.
RayTree treeOf(const std::vector<int>& parents)
{
    RayTree tree;
    for (std::size_t i = 0; i < parents.size(); ++i)
        tree.nodes.push_back(
            nodeOf(int(i), parents[i], parents[i] < 0 ? 0 : tree.nodes[std::size_t(parents[i])].depth + 1));
    return tree;
}

void addShadow(RayTree& tree, int node, int step = 0)
{
    RayTree::Shadow shadow;
    shadow.node = node;
    shadow.step = step;
    tree.shadows.push_back(shadow);
}

void addCapped(RayTree& tree, int node, int step = 0)
{
    RayTree::Capped capped;
    capped.node = node;
    capped.step = step;
    tree.capped.push_back(capped);
}

RayTree binaryTree(int nodes)
{
    std::vector<int> parents{-1};
    for (int i = 1; i < nodes; ++i) parents.push_back((i - 1) / 2);
    return treeOf(parents);
}

RayTree chain(int nodes)
{
    std::vector<int> parents;
    for (int i = 0; i < nodes; ++i) parents.push_back(i - 1);
    return treeOf(parents);
}

RayTree anyTree()
{
    std::vector<int> parents{-1};
    const int count = *rc::gen::inRange(1, 60);
    // Now and then an orphan.
    for (int i = 1; i < count; ++i) parents.push_back(*rc::gen::inRange(std::max(-1, i - 8), i));
    RayTree tree = treeOf(parents);
    for (int i = *rc::gen::inRange(0, 30); i > 0; --i) addShadow(tree, *rc::gen::inRange(0, count));
    for (int i = *rc::gen::inRange(0, 10); i > 0; --i) addCapped(tree, *rc::gen::inRange(0, count));
    return tree;
}

TEST(TreeLayout, ParentsStandOverTheMiddleOfTheirChildren)
{
    const auto layout = layOutTree(treeOf({-1, 0, 1, 1, 0}));
    const auto& items = layout.items;
    EXPECT_EQ(items[2].x, 0);
    EXPECT_EQ(items[3].x, 1);
    EXPECT_EQ(items[1].x, 0.5);
    EXPECT_GT(items[4].x, 2); // a cousin: a little further than a sister
    EXPECT_EQ(items[0].x, (items[1].x + items[4].x) / 2);
    EXPECT_EQ(items[0].y, 0);
    EXPECT_EQ(items[1].y, 1);
    EXPECT_EQ(items[3].y, 2);
    EXPECT_EQ(layout.width, items[4].x);
    EXPECT_EQ(layout.height, 2);
}

TEST(TreeLayout, ShadowRaysAndRaysNotFollowedAreLeavesOfTheirNode)
{
    RayTree tree = treeOf({-1, 0});
    addShadow(tree, 0);
    addShadow(tree, 1);
    addCapped(tree, 1);
    const auto layout = layOutTree(tree);
    ASSERT_EQ(layout.items.size(), 5U);
    const auto& shadow = layout.items[std::size_t(layout.ofShadow[1])];
    EXPECT_EQ(shadow.kind, ItemKind::shadow);
    EXPECT_EQ(shadow.node, 1);
    EXPECT_EQ(shadow.index, 1);
    EXPECT_EQ(shadow.parent, layout.ofNode[1]);
    EXPECT_EQ(shadow.level, 2);
    const auto& capped = layout.items[std::size_t(layout.ofNotFollowed[0])];
    EXPECT_EQ(capped.kind, ItemKind::notFollowed);
    EXPECT_EQ(capped.parent, layout.ofNode[1]);
}

TEST(TreeLayout, WhatHappenedFirstComesFirst)
{
    RayTree tree = treeOf({-1, 0, 0});
    tree.nodes[0].step = 1;
    tree.nodes[1].step = 3;
    tree.nodes[2].step = 6;
    addShadow(tree, 0, 5);
    addCapped(tree, 0, 2);
    const auto layout = layOutTree(tree);
    const auto x = [&](int item) { return layout.items[std::size_t(item)].x; };
    EXPECT_LT(x(layout.ofNotFollowed[0]), x(layout.ofNode[1]));
    EXPECT_LT(x(layout.ofNode[1]), x(layout.ofShadow[0]));
    EXPECT_LT(x(layout.ofShadow[0]), x(layout.ofNode[2]));
}

TEST(TreeLayout, OfNoTreeIsEmpty)
{
    const auto layout = layOutTree({});
    EXPECT_TRUE(layout.items.empty());
    EXPECT_EQ(layout.levels, 0);
    EXPECT_EQ(itemAt(layout, 0, 0, 100, 100), -1);
    EXPECT_TRUE(itemsWithin(layout, -9, -9, 9, 9).empty());
    EXPECT_FALSE(isBetterTurned(turned(layout), 100, 100));
}

RC_GTEST_PROP(TreeLayout, KeepsItsDistances, ())
{
    const auto layout = layOutTree(anyTree(), *rc::gen::arbitrary<bool>());
    const auto across = [&](const TreeItem& it) { return layout.sideways ? it.y : it.x; };
    const auto along = [&](const TreeItem& it) { return layout.sideways ? it.x : it.y; };
    for (std::size_t i = 0; i < layout.items.size(); ++i)
    {
        const auto& a = layout.items[i];
        RC_ASSERT(a.x >= 0 && a.y >= 0 && a.x <= layout.width && a.y <= layout.height);
        RC_ASSERT(along(a) == a.level);
        RC_ASSERT(a.parent < int(i));
        RC_ASSERT(a.level == (a.parent < 0 ? 0 : layout.items[std::size_t(a.parent)].level + 1));
        for (std::size_t j = 0; j < i; ++j)
        {
            const auto& b = layout.items[j];
            if (a.level != b.level) continue;
            const bool areRays = a.kind != ItemKind::shadow && b.kind != ItemKind::shadow;
            // Sums of halves and tenths: a few rounding errors of numbers below 100.
            RC_ASSERT(across(a) - across(b) >= (areRays ? 1 : tightest) - 1e-11);
        }
    }
}

RC_GTEST_PROP(TreeLayout, SubtreesDoNotMix, ())
{
    const auto layout = layOutTree(anyTree());
    std::vector<double> low(layout.items.size()), high(layout.items.size());
    for (std::size_t i = layout.items.size(); i-- > 0;)
    {
        low[i] = high[i] = layout.items[i].x;
        for (std::size_t j = i + 1; j < layout.items.size(); ++j)
            if (layout.items[j].parent == int(i))
            {
                low[i] = std::min(low[i], low[j]);
                high[i] = std::max(high[i], high[j]);
            }
    }
    for (std::size_t i = 0; i < layout.items.size(); ++i)
        for (std::size_t j = i + 1; j < layout.items.size(); ++j)
            if (layout.items[i].parent == layout.items[j].parent) RC_ASSERT(high[i] < low[j]);
}

RC_GTEST_PROP(TreeLayout, FindsInARectangleWhatALoopFinds, ())
{
    const auto layout = layOutTree(anyTree(), *rc::gen::arbitrary<bool>());
    const double left = *rc::gen::inRange(-20, 200) / 8.0, top = *rc::gen::inRange(-20, 200) / 8.0;
    const double right = left + *rc::gen::inRange(0, 100) / 8.0, bottom = top + *rc::gen::inRange(0, 100) / 8.0;
    auto found = itemsWithin(layout, left, top, right, bottom);
    std::sort(found.begin(), found.end());
    std::vector<int> expected;
    for (std::size_t i = 0; i < layout.items.size(); ++i)
    {
        const auto& it = layout.items[i];
        if (it.x >= left && it.x <= right && it.y >= top && it.y <= bottom) expected.push_back(int(i));
    }
    RC_ASSERT(found == expected);
}

TEST(TreeLayout, CountsWhatLiesOnTheEdgeOfARectangle)
{
    const auto layout = layOutTree(treeOf({-1, 0, 0, 0})); // leaves at 0, 1 and 2
    EXPECT_EQ(itemsWithin(layout, 0, 1, 1, 1), (std::vector{1, 2}));
    EXPECT_EQ(itemsWithin(layout, 1, 0, 2, 1), (std::vector{0, 2, 3}));
    EXPECT_EQ(itemsWithin(turned(layout), 1, 0, 1, 1), (std::vector{1, 2}));
}

RC_GTEST_PROP(TreeLayout, PicksTheNearestItem, ())
{
    const auto layout = layOutTree(anyTree(), *rc::gen::arbitrary<bool>());
    const double x = *rc::gen::inRange(-8, 300) / 8.0, y = *rc::gen::inRange(-8, 200) / 8.0;
    const double rx = *rc::gen::inRange(1, 30) / 8.0, ry = *rc::gen::inRange(1, 30) / 8.0;
    double nearest = 1;
    bool any = false;
    const auto distance = [&](const TreeItem& it) { return std::hypot((it.x - x) / rx, (it.y - y) / ry); };
    for (const auto& it : layout.items)
        if (distance(it) <= nearest)
        {
            nearest = distance(it);
            any = true;
        }
    const int found = itemAt(layout, x, y, rx, ry);
    RC_ASSERT((found >= 0) == any);
    if (any) RC_ASSERT(distance(layout.items[std::size_t(found)]) == nearest);
}

RC_GTEST_PROP(TreeLayout, MeasuresTheGapsThatALoopFinds, ())
{
    const auto layout = layOutTree(anyTree());
    double gaps[3] = {TreeLayout::farthest, TreeLayout::farthest, TreeLayout::farthest}; // by number of shadow rays
    for (std::size_t i = 0; i < layout.items.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
        {
            const auto &a = layout.items[i], &b = layout.items[j];
            auto& gap = gaps[(a.kind == ItemKind::shadow) + (b.kind == ItemKind::shadow)];
            if (a.level == b.level) gap = std::min(gap, a.x - b.x);
        }
    RC_ASSERT(layout.rayGap >= gaps[0] && layout.mixedGap >= gaps[1] && layout.shadowGap >= gaps[2]);
    // A pair with something else between has at least the room of the nearer pairs.
    RC_ASSERT(std::min({layout.rayGap, layout.mixedGap, layout.shadowGap}) == std::min({gaps[0], gaps[1], gaps[2]}));
}

TEST(TreeLayout, NamesTheAncestors)
{
    RayTree tree = treeOf({-1, 0, 1, 0});
    addShadow(tree, 2);
    const auto layout = layOutTree(tree);
    EXPECT_EQ(ancestorsOf(layout, layout.ofShadow[0]),
              (std::vector{layout.ofNode[2], layout.ofNode[1], layout.ofNode[0]}));
    EXPECT_TRUE(ancestorsOf(layout, layout.ofNode[0]).empty());
}

TEST(TreeLayout, LaysOutAChainOfATenThousandWithoutRecursion)
{
    const auto layout = layOutTree(chain(10'000));
    EXPECT_EQ(layout.levels, 10'000);
    EXPECT_EQ(layout.width, 0);
    EXPECT_EQ(layout.height, 9'999);
    EXPECT_EQ(ancestorsOf(layout, 9'999).size(), 9'999U);
}

TEST(TreeLayout, TakesTimeInProportionToTheTree)
{
    for (const auto& make : {chain, binaryTree})
    {
        std::map<int, RayTree> trees; // made first: to get so much memory takes longer than the layout
        for (const int nodes : {25'000, 8 * 25'000}) trees[nodes] = make(nodes);
        const auto layOut = [&](int nodes) { EXPECT_EQ(layOutTree(trees[nodes]).items.size(), unsigned(nodes)); };
        EXPECT_LT(growthByEight(25'000, layOut), aboutLinear);
    }
}

TEST(TreeLayout, TurnsToTheSideThatHasMoreRoom)
{
    const auto deep = layOutTree(chain(40)),
               wide = layOutTree(treeOf({-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_TRUE(isBetterTurned(deep, 800, 200));
    EXPECT_FALSE(isBetterTurned(turned(deep), 800, 200));
    EXPECT_FALSE(isBetterTurned(deep, 100, 800));
    EXPECT_FALSE(isBetterTurned(wide, 800, 200));
    EXPECT_TRUE(isBetterTurned(turned(wide), 800, 200));
    EXPECT_TRUE(isBetterTurned(wide, 100, 800));
}

TEST(TreeLayout, TurnedIsTheSameOverTheDiagonal)
{
    const auto layout = layOutTree(binaryTree(9)), other = turned(layout);
    EXPECT_TRUE(other.sideways);
    EXPECT_EQ(other.width, layout.height);
    for (std::size_t i = 0; i < layout.items.size(); ++i)
    {
        EXPECT_EQ(other.items[i].x, layout.items[i].y);
        EXPECT_EQ(other.items[i].y, layout.items[i].x);
    }
}

TreeView::Frame frame()
{
    TreeView::Frame frame;
    frame.width = 600;
    frame.height = 300;
    frame.left = frame.right = 20;
    frame.top = 40;
    frame.bottom = 10;
    return frame;
}

RC_GTEST_PROP(TreeView, ShowsTheWholeTreeWithinItsMargins, ())
{
    const auto layout = layOutTree(anyTree(), *rc::gen::arbitrary<bool>());
    TreeView view;
    view.fit(layout, frame());
    for (const auto& it : layout.items)
    {
        const auto at = view.toPane(it.x, it.y);
        RC_ASSERT(at[0] >= 20 - 1e-9 && at[0] <= 580 + 1e-9);
        RC_ASSERT(at[1] >= 10 - 1e-9 && at[1] <= 260 + 1e-9);
    }
}

RC_GTEST_PROP(TreeView, ZoomsAboutThePointer, ())
{
    const auto layout = layOutTree(binaryTree(2000));
    TreeView view;
    view.fit(layout, frame());
    const double x = *rc::gen::inRange(25, 575), y = *rc::gen::inRange(12, 258);
    const auto before = view.toTree(x, y);
    for (int i = *rc::gen::inRange(1, 60); i > 0; --i) view.zoomAt(1.25, x, y);
    const auto after = view.toTree(x, y);
    RC_ASSERT(std::abs(after[0] - before[0]) < 1e-6);
    RC_ASSERT(std::abs(after[1] - before[1]) < 1e-6);
    RC_ASSERT(view.unitX() <= 120 && view.unitY() <= 120);
}

TEST(TreeView, ZoomsInUntilBothWaysAreTheLargestAndOutUntilItFits)
{
    const auto layout = layOutTree(binaryTree(20'000));
    TreeView view;
    view.fit(layout, frame());
    const double x = view.unitX(), y = view.unitY();
    EXPECT_LT(x, 0.1);
    for (int i = 0; i < 60; ++i) view.zoomAt(1.25, 300, 100);
    EXPECT_EQ(view.unitX(), 120);
    EXPECT_EQ(view.unitY(), 120);
    for (int i = 0; i < 60; ++i) view.zoomAt(0.8, 300, 100);
    EXPECT_EQ(view.unitX(), x);
    EXPECT_EQ(view.unitY(), y);
}

TEST(TreeView, StaysFittedUntilTheUserZooms)
{
    TreeView view;
    view.fit(layOutTree(binaryTree(31)), frame());
    view.adapt(layOutTree(binaryTree(3)), frame());
    EXPECT_EQ(view.unitX(), 60);
    view.adapt(layOutTree(binaryTree(31)), frame());
    EXPECT_FALSE(view.isZoomed());
    EXPECT_LT(view.unitX(), 40);
    view.zoomAt(1.5, 300, 100);
    const double chosen = view.unitX();
    view.adapt(layOutTree(binaryTree(40)), frame());
    EXPECT_TRUE(view.isZoomed());
    EXPECT_NEAR(view.unitX(), chosen, 1e-9);
}

TEST(TreeView, NeverLosesTheTree)
{
    const auto layout = layOutTree(binaryTree(31));
    TreeView view;
    view.fit(layout, frame());
    for (const auto& [dx, dy] : {std::pair{9e5, 0.}, {-9e5, 0.}, {0., 9e5}, {0., -9e5}})
    {
        view.pan(dx, dy);
        const auto low = view.toPane(0, layout.height), high = view.toPane(layout.width, 0);
        EXPECT_TRUE(low[0] <= 300 && high[0] >= 300) << dx;
        EXPECT_TRUE(low[1] <= 135 && high[1] >= 135) << dy;
    }
}

TEST(TreeView, RevealsWhatIsOutsideAndLeavesTheRest)
{
    const auto layout = layOutTree(binaryTree(2000));
    TreeView view;
    view.fit(layout, frame());
    view.centre(layout.items[0].x, 0, 50);
    EXPECT_EQ(view.unitX(), 50);
    EXPECT_NEAR(view.toPane(layout.items[0].x, 0)[0], 300, 1e-9);
    EXPECT_NEAR(view.toPane(layout.items[0].x, 0)[1], 135, 1e-9);

    view.reveal(layout.items[0].x + 1, 1);
    EXPECT_NEAR(view.toPane(layout.items[0].x, 0)[0], 300, 1e-9);
    view.reveal(layout.width, layout.height);
    const auto at = view.toPane(layout.width, layout.height);
    EXPECT_TRUE(at[0] >= 20 && at[0] <= 580 && at[1] >= 10 && at[1] <= 260);
}

} // namespace

} // namespace rt::viz
