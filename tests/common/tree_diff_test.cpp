#include "common/tree/tree_diff.h"

#include <filesystem>
#include <functional>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/files/scene_file.h"
#include "lessons/programs/registry.h"
#include "tests/common/growth.h"
#include "tests/common/random_scene.h"

namespace rt
{

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string textOf(const std::optional<TreeDifference>& difference)
{
    return difference ? describe(*difference) : "no difference";
}

/// Some trees of random scenes that the lesson models.
std::vector<RayTree> treesOf(const LessonEntry& lesson, Precision precision, unsigned seeds = 8)
{
    std::vector<RayTree> trees;
    for (unsigned seed = 0; seed < seeds; ++seed)
    {
        const SceneDescription scene = randomScene(seed, lesson.models);
        for (unsigned i = 0; i < 12; ++i)
        {
            const int x = int((seed * 7 + i * 5) % unsigned(scene.camera.width));
            const int y = int((seed * 3 + i * 11) % unsigned(scene.camera.height));
            trees.push_back(lesson.inspect(scene, precision, std::array{x, y}));
        }
    }
    return trees;
}

const LessonEntry& everything()
{
    return *findLesson(8);
}

RayTree::Node child(int id, int parent, RayKind kind, const Vec3<double>& direction)
{
    RayTree::Node node;
    node.id = id;
    node.parent = parent;
    node.kind = kind;
    node.depth = 1;
    node.direction = direction;
    return node;
}

/// A camera ray and one ray from its hit point for each direction.
RayTree fan(const std::vector<Vec3<double>>& directions, RayKind kind = reflected)
{
    RayTree tree;
    tree.nodes.push_back(child(0, -1, RayKind::camera, {0, 0, -1}));
    tree.nodes[0].depth = 0;
    for (const auto& direction : directions) tree.nodes.push_back(child(int(tree.nodes.size()), 0, kind, direction));
    return tree;
}

class TreesOf : public testing::TestWithParam<const LessonEntry*>
{
};

TEST_P(TreesOf, ALessonDoNotDifferFromThemselves)
{
    for (const auto precision : {Precision::floating, Precision::doubled})
        for (const auto& tree : treesOf(*GetParam(), precision))
        {
            EXPECT_EQ(textOf(firstDifference(tree, tree, {0, 0})), "no difference");
            const auto match = matchTrees(tree, tree, {0, 0});
            for (std::size_t i = 0; i < tree.nodes.size(); ++i)
            {
                EXPECT_EQ(match.gotOf[i], int(i));
                EXPECT_EQ(match.expectedOf[i], int(i));
                EXPECT_FALSE(match.differs[i]);
            }
        }
}

TEST_P(TreesOf, ALessonInLongDoubleAgreeWithThoseInDouble)
{
    const auto expected = treesOf(*GetParam(), Precision::longDouble), got = treesOf(*GetParam(), Precision::doubled);
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(textOf(firstDifference(expected[i], got[i])), "no difference");
}

INSTANTIATE_TEST_SUITE_P(All, TreesOf, testing::ValuesIn(lessons().begin(), lessons().end()),
                         [](const auto& lesson) { return fmt::format("Lesson{:02}", lesson.param->number); });

/// Where a ray goes on to depends on rounding, at an edge or after many curved mirrors, float and double part. With one
/// pixel in five of each scene, 27 of 236544 trees differed; with a tenth of the tolerance 301.
TEST(TreeDiff, FindsFloatLikeDoubleOnAllScenes)
{
    int all = 0, differing = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(RAYTREE_SOURCE_DIR "/lessons"))
    {
        if (file.path().extension() != ".toml" || file.path().parent_path().filename() != "scenes") continue;
        // These lie beyond the horizon of float on purpose.
        if (file.path().string().find("/10_") != std::string::npos) continue;
        const auto scene = loadScene(file.path());
        const auto* lesson = smallestLesson(scene);
        if (!lesson) continue;
        for (int x = 3; x < scene.camera.width; x += 19)
            for (int y = 3; y < scene.camera.height; y += 19)
            {
                const auto expected = lesson->inspect(scene, Precision::doubled, std::array{x, y});
                const auto got = lesson->inspect(scene, Precision::floating, std::array{x, y});
                ++all;
                differing += firstDifference(expected, got, floatAgainstDouble()).has_value();
                EXPECT_TRUE(firstDifference(expected, got, {0, 0})) << "compares nothing";
            }
    }
    EXPECT_GT(all, 5000);
    EXPECT_LE(differing, all / 2000);
}

/// One field of the tree is given another value.
struct Change
{
    const char* field;
    std::function<void(RayTree&, std::size_t)> change;
};

void turn(Vec3<double>& v)
{
    v = unit(Vec3<double>(v.y + 0.1, v.z - 0.2, v.x + 0.3));
}

double& some(std::optional<double>& x)
{
    return x ? *x : x.emplace(0);
}

const std::vector<Change>& nodeChanges()
{
    static const std::vector<Change> changes{
        {"depth", [](RayTree& tree, std::size_t i) { ++tree.nodes[i].depth; }},
        {"orphan", [](RayTree& tree, std::size_t i) { tree.nodes[i].orphan ^= true; }},
        {"origin", [](RayTree& tree, std::size_t i) { tree.nodes[i].origin.y += 1e-5; }},
        {"direction", [](RayTree& tree, std::size_t i) { turn(tree.nodes[i].direction); }},
        {"weight", [](RayTree& tree, std::size_t i) { tree.nodes[i].weight += 1e-6; }},
        {"throughput", [](RayTree& tree, std::size_t i) { tree.nodes[i].throughput.z += 1e-6; }},
        {"n1", [](RayTree& tree, std::size_t i) { some(tree.nodes[i].n1) += 0.5; }},
        {"n2", [](RayTree& tree, std::size_t i) { some(tree.nodes[i].n2) += 0.5; }},
        {"fresnel", [](RayTree& tree, std::size_t i) { some(tree.nodes[i].fresnel) = nan; }},
        {"tir", [](RayTree& tree, std::size_t i) { tree.nodes[i].tir ^= true; }},
        {"end", [](RayTree& tree, std::size_t i) { tree.nodes[i].end = End((int(tree.nodes[i].end) + 1) % 6); }},
        {"return", [](RayTree& tree, std::size_t i) { tree.nodes[i].returnStep = 0; }},
        {"own", [](RayTree& tree, std::size_t i) { tree.nodes[i].own.x += 1e-5; }},
        {"radiance", [](RayTree& tree, std::size_t i) { tree.nodes[i].radiance.y = infinity<double>; }},
        {"contribution", [](RayTree& tree, std::size_t i) { tree.nodes[i].contribution.z += 1e-3; }},
    };
    return changes;
}

const std::vector<Change>& hitChanges()
{
    static const std::vector<Change> changes{
        {"hit", [](RayTree& tree, std::size_t i) { tree.nodes[i].hit.reset(); }},
        {"hit.t", [](RayTree& tree, std::size_t i) { tree.nodes[i].hit->t += 1e-5; }},
        {"hit.point", [](RayTree& tree, std::size_t i) { tree.nodes[i].hit->point.x += 1e-5; }},
        {"hit.normal", [](RayTree& tree, std::size_t i) { turn(tree.nodes[i].hit->normal); }},
        {"hit.inside", [](RayTree& tree, std::size_t i) { tree.nodes[i].hit->inside ^= true; }},
        {"hit.primitive", [](RayTree& tree, std::size_t i) { tree.nodes[i].hit->primitive += "0"; }},
        {"hit.material", [](RayTree& tree, std::size_t i) { tree.nodes[i].hit->material = "other"; }},
        {"hit.color", [](RayTree& tree, std::size_t i) { tree.nodes[i].hit->color.y += 1e-5; }},
    };
    return changes;
}

const std::vector<Change>& shadowChanges()
{
    static const std::vector<Change> changes{
        {"direction", [](RayTree& tree, std::size_t i) { turn(tree.shadows[i].direction); }},
        {"distance", [](RayTree& tree, std::size_t i) { tree.shadows[i].distance += 1e-5; }},
        {"visible", [](RayTree& tree, std::size_t i) { tree.shadows[i].visible ^= true; }},
        {"tint", [](RayTree& tree, std::size_t i) { tree.shadows[i].tint.x = 0.5; }},
        {"light", [](RayTree& tree, std::size_t i) { tree.shadows[i].light = 99; }},
        {"blocker",
         [](RayTree& tree, std::size_t i) {
             auto& blocker = tree.shadows[i].blocker;
             if (blocker)
                 blocker.reset();
             else
                 blocker.emplace();
         }},
    };
    return changes;
}

const std::vector<Change>& cappedChanges()
{
    static const std::vector<Change> changes{
        {"direction", [](RayTree& tree, std::size_t i) { turn(tree.capped[i].direction); }},
        {"weight", [](RayTree& tree, std::size_t i) { tree.capped[i].weight += 1e-6; }},
        {"radiance", [](RayTree& tree, std::size_t i) { tree.capped[i].radiance.z = nan; }},
        {"reason",
         [](RayTree& tree, std::size_t i) {
             tree.capped[i].reason = tree.capped[i].reason == End::cap ? End::cutoff : End::cap;
         }},
    };
    return changes;
}

/// The node, or the node that the i-th shadow ray or ray not followed leaves.
template <class Item>
int nodeOf(const Item& item)
{
    if constexpr (requires { item.id; })
        return item.id;
    else
        return item.node;
}

/// Each of the changes alone, at every place: it is what is found, and it alone is marked.
template <class Item, class Is>
int findsEach(const RayTree& tree, const std::vector<Change>& changes, std::vector<Item> RayTree::*items, Is&& applies)
{
    int tried = 0;
    for (const auto& [field, change] : changes)
        for (std::size_t i = 0; i < (tree.*items).size(); ++i)
        {
            if (!applies((tree.*items)[i])) continue;
            RayTree changed = tree;
            change(changed, i);
            const auto difference = firstDifference(tree, changed);
            const int node = nodeOf((tree.*items)[i]);
            if (!difference)
            {
                ADD_FAILURE() << field << " of " << i << " of " << node << " is not found";
                continue;
            }
            EXPECT_EQ(difference->field, field);
            EXPECT_EQ(difference->expectedNode, node);
            EXPECT_EQ(difference->gotNode, node);
            EXPECT_NE(difference->expected, difference->got) << field;
            EXPECT_EQ(difference->angle.has_value(),
                      field == std::string("direction") || field == std::string("hit.normal"));
            EXPECT_NE(describe(*difference).find(fmt::format("[{}]", node)), std::string::npos);
            const auto match = matchTrees(tree, changed);
            for (std::size_t k = 0; k < tree.nodes.size(); ++k)
            {
                EXPECT_EQ(match.gotOf[k], int(k));
                // A radiance that differs makes its parent's a sum that does not add up.
                const bool isParent =
                    field == std::string("radiance") && tree.nodes[std::size_t(node)].parent == int(k);
                EXPECT_TRUE(isParent || match.differs[k] == (int(k) == node)) << field << " of " << node << " at " << k;
            }
            ++tried;
        }
    return tried;
}

TEST(TreeDiff, FindsEachFieldThatIsChanged)
{
    int nodes = 0, hits = 0, shadows = 0, capped = 0;
    const auto always = [](const auto&) { return true; };
    for (const auto& tree : treesOf(everything(), Precision::doubled, 40))
    {
        nodes += findsEach(tree, nodeChanges(), &RayTree::nodes, always);
        hits += findsEach(tree, hitChanges(), &RayTree::nodes, [](const auto& node) { return node.hit.has_value(); });
        shadows += findsEach(tree, shadowChanges(), &RayTree::shadows, always);
        capped += findsEach(tree, cappedChanges(), &RayTree::capped, always);
    }
    EXPECT_GT(nodes, 1000);
    EXPECT_GT(hits, 500);
    EXPECT_GT(shadows, 500);
    EXPECT_GT(capped, 50);
}

TEST(TreeDiff, IgnoresWhatATracerNeedNotAgreeOn)
{
    for (const auto& tree : treesOf(everything(), Precision::doubled, 4))
    {
        RayTree other = tree;
        other.lesson = 3;
        other.scene = other.source = other.real = "else";
        other.pixel = std::array{1, 2};
        other.maxDepth += 5;
        for (auto& node : other.nodes) node.line = node.returnLine = node.step = node.returnStep = 0;
        for (auto& shadow : other.shadows) shadow.line = shadow.step = 0;
        for (auto& capped : other.capped) capped.line = capped.step = 0;
        EXPECT_EQ(textOf(firstDifference(tree, other)), "no difference");
        EXPECT_EQ(textOf(firstDifference(other, tree)), "no difference");
    }
}

/// Removes nodes[gone] and everything below it, and closes the gaps.
RayTree without(const RayTree& tree, int gone)
{
    RayTree out = tree;
    out.nodes.clear();
    std::vector<int> newId(tree.nodes.size(), -1);
    for (const auto& node : tree.nodes)
        if (node.id != gone && (node.parent < 0 || newId[std::size_t(node.parent)] >= 0))
        {
            newId[std::size_t(node.id)] = int(out.nodes.size());
            out.nodes.push_back(node);
            out.nodes.back().id = newId[std::size_t(node.id)];
            if (node.parent >= 0) out.nodes.back().parent = newId[std::size_t(node.parent)];
        }
    const auto close = [&](auto& items) {
        std::erase_if(items, [&](const auto& item) { return newId[std::size_t(item.node)] < 0; });
        for (auto& item : items) item.node = newId[std::size_t(item.node)];
    };
    close(out.shadows);
    close(out.capped);
    return out;
}

TEST(TreeDiff, NamesAMissingRayAndOnlyThat)
{
    int tried = 0;
    for (const auto& tree : treesOf(everything(), Precision::doubled, 60))
        for (const auto& node : tree.nodes)
        {
            if (node.id == 0) continue;
            const auto less = without(tree, node.id);
            auto difference = firstDifference(tree, less);
            ASSERT_TRUE(difference);
            EXPECT_EQ(difference->field, "missing ray");
            EXPECT_EQ(difference->expectedNode, node.id);
            EXPECT_EQ(difference->gotNode, -1);
            difference = firstDifference(less, tree);
            ASSERT_TRUE(difference);
            EXPECT_EQ(difference->field, "extra ray");
            EXPECT_EQ(difference->expectedNode, -1);
            EXPECT_EQ(difference->gotNode, node.id);

            // All others find their partner.
            const auto match = matchTrees(tree, less);
            int missing = 0;
            for (std::size_t i = 0; i < tree.nodes.size(); ++i)
            {
                const int partner = match.gotOf[i];
                if (partner < 0)
                    ++missing;
                else
                {
                    EXPECT_EQ(less.nodes[std::size_t(partner)].direction, tree.nodes[i].direction);
                    EXPECT_FALSE(match.differs[i]) << i;
                }
            }
            EXPECT_EQ(missing, int(tree.nodes.size() - less.nodes.size()));
            ++tried;
        }
    EXPECT_GT(tried, 100);
}

TEST(TreeDiff, NamesAMissingShadowRayAndOnlyThat)
{
    int tried = 0;
    for (const auto& tree : treesOf(everything(), Precision::doubled, 4))
        for (std::size_t i = 0; i < tree.shadows.size(); ++i)
        {
            RayTree less = tree;
            less.shadows.erase(less.shadows.begin() + std::ptrdiff_t(i));
            auto difference = firstDifference(tree, less);
            ASSERT_TRUE(difference);
            EXPECT_EQ(difference->field, "missing shadow ray");
            EXPECT_EQ(difference->shadowLight, tree.shadows[i].light);
            EXPECT_EQ(difference->expectedNode, tree.shadows[i].node);
            difference = firstDifference(less, tree);
            ASSERT_TRUE(difference);
            EXPECT_EQ(difference->field, "extra shadow ray");
            ++tried;
        }
    EXPECT_GT(tried, 100);
}

TEST(TreeDiff, FindsTheOneChangeInARandomTree)
{
    EXPECT_TRUE(rc::check("any shape of tree, one change", [] {
        RayTree tree;
        const auto shape = *rc::gen::nonEmpty(rc::gen::arbitrary<std::vector<unsigned>>());
        for (const unsigned number : shape)
        {
            const int id = int(tree.nodes.size());
            auto node = child(id, id == 0 ? -1 : int(number % unsigned(id)), RayKind(number % 3),
                              unit(Vec3<double>(number % 7, number % 11, 1 + number % 5)));
            node.weight = 1 + id; // so that no two are alike
            if (number % 4) node.hit.emplace().t = id;
            node.end = End(number % 6);
            tree.nodes.push_back(node);
            if (number % 5 == 0) tree.shadows.emplace_back().node = id;
            if (number % 6 == 0) tree.capped.emplace_back().node = id;
        }
        const auto i = *rc::gen::inRange<std::size_t>(0, tree.nodes.size());
        const auto& changes = tree.nodes[i].hit && *rc::gen::arbitrary<bool>() ? hitChanges() : nodeChanges();
        const auto& [field, change] = changes[*rc::gen::inRange<std::size_t>(0, changes.size())];
        if (field == std::string("return")) return; // this tree knows no steps
        RayTree changed = tree;
        change(changed, i);
        const auto difference = firstDifference(tree, changed);
        RC_ASSERT(difference.has_value());
        // Equal siblings may be paired otherwise when one is turned: then the other pair differs first, in its weight.
        if (field != std::string("direction"))
        {
            RC_ASSERT(difference->field == field);
            RC_ASSERT(difference->expectedNode == int(i));
            RC_ASSERT(difference->gotNode == int(i));
        }
    }));
}

TEST(TreeDiff, PairsSiblingsByDirectionWhenOneIsMissing)
{
    std::vector<Vec3<double>> directions;
    for (int i = 0; i < 40; ++i) directions.push_back(unit(Vec3<double>(std::sin(i), std::cos(i), i * 0.1)));
    const auto expected = fan(directions);
    for (std::size_t gone = 0; gone < directions.size(); ++gone)
    {
        auto fewer = directions;
        fewer.erase(fewer.begin() + std::ptrdiff_t(gone));
        const auto match = matchTrees(expected, fan(fewer));
        for (std::size_t i = 0; i < directions.size(); ++i)
            EXPECT_EQ(match.gotOf[i + 1], i < gone ? int(i + 1) : i == gone ? -1 : int(i));
        EXPECT_EQ(matchTrees(fan(fewer), expected).expectedOf, match.gotOf);
        EXPECT_EQ(firstDifference(expected, fan(fewer))->path, fmt::format("camera > reflected #{}", gone + 1));
    }
    auto difference = firstDifference(expected, fan({directions.begin() + 1, directions.end()}));
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->path, "camera > reflected #1");
    EXPECT_EQ(difference->field, "missing ray");
}

TEST(TreeDiff, DoesNotBlameAParentForItsChild)
{
    const auto expected = fan({{0, 1, 0}, {1, 0, 0}});
    auto got = expected;
    got.nodes[0].radiance.x = got.nodes[2].radiance.x = 1;
    EXPECT_EQ(matchTrees(expected, got).differs, (std::vector<bool>{false, false, true}));
    EXPECT_EQ(firstDifference(expected, got)->gotNode, 2);
    got.nodes[2].radiance.x = 0;
    EXPECT_EQ(matchTrees(expected, got).differs, (std::vector<bool>{true, false, false}));
    EXPECT_EQ(matchTrees(expected, fan({{1, 0, 0}})).differs, (std::vector<bool>{false, true, false}));
}

TEST(TreeDiff, ComparesShadowRaysThenOwnLightThenTheRaysThatLeave)
{
    auto expected = fan({{0, 1, 0}});
    expected.shadows.emplace_back();
    auto got = expected;
    got.nodes[1].direction = {1, 0, 0};
    EXPECT_EQ(firstDifference(expected, got)->field, "direction");
    got.nodes[0].own.x = 1;
    EXPECT_EQ(firstDifference(expected, got)->field, "own");
    got.shadows[0].visible = true;
    EXPECT_EQ(firstDifference(expected, got)->field, "visible");
    // Where no lamp is asked a recorder infers `own` from what comes back: then it says nothing about lamps.
    got = expected;
    got.nodes[0].own.x = got.nodes[0].radiance.x = 1;
    expected.shadows.clear();
    got.shadows.clear();
    EXPECT_EQ(firstDifference(expected, got)->field, "radiance");
}

TEST(TreeDiff, TakesARayWhoseParentComesLaterForAnOrphan)
{
    auto expected = fan({{0, 1, 0}, {1, 0, 0}});
    expected.nodes[1].parent = 2;
    expected.nodes[2].parent = 1;
    auto got = expected;
    got.nodes[1].weight = 7;
    const auto difference = firstDifference(expected, got);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->path, "orphan reflected");
    EXPECT_EQ(difference->field, "weight");
}

TEST(TreeDiff, TellsARayOfTheWrongKind)
{
    const auto difference = firstDifference(fan({{0, 1, 0}}, transmitted), fan({{0, 1, 0}}, reflected));
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->field, "kind");
    EXPECT_EQ(difference->expected, "transmitted");
    EXPECT_EQ(difference->got, "reflected");
}

TEST(TreeDiff, TellsWhatStandsInThePlaceOfAMissingRay)
{
    const auto expected = fan({{0, 1, 0}});
    EXPECT_EQ(textOf(firstDifference(expected, fan({{0, -1, 0}}, transmitted))),
              "reflected ray [1] (camera > reflected): missing, expected a reflected ray in direction (0, 1, 0), got a "
              "transmitted ray in direction (0, -1, 0) instead\n"
              "The hit that it should leave agrees: look at when a ray is followed.");
    auto got = fan({});
    got.capped.emplace_back().direction = {0, 1, 0};
    EXPECT_EQ(firstDifference(expected, got)->got, "not followed: deeper than MAXDEPTH");
    EXPECT_EQ(firstDifference(got, expected)->field, "missing capped ray");
    got = fan({});
    got.nodes.push_back(child(1, -1, RayKind::reflected, {0, 1, 0}));
    EXPECT_EQ(firstDifference(expected, got)->got.find("nothing, but ray [1] of depth 1 has no parent"), 0U);
    got = fan({});
    got.nodes[0].step = 1;
    EXPECT_EQ(firstDifference(expected, got)->got, "nothing: the trace stopped here and did not return");
    EXPECT_EQ(firstDifference(expected, RayTree{})->got, "a tree without rays");
    EXPECT_EQ(firstDifference(expected, RayTree{})->path, "camera");
    EXPECT_EQ(textOf(firstDifference(RayTree{}, RayTree{})), "no difference");
}

TEST(TreeDiff, TakesNanForNanAndForNothingElse)
{
    auto expected = fan({{0, 1, 0}}), got = expected;
    for (auto* tree : {&expected, &got}) tree->nodes[1].radiance = {nan, infinity<double>, -infinity<double>};
    EXPECT_EQ(textOf(firstDifference(expected, got)), "no difference");
    for (const double other : {0.0, infinity<double>, 1e308})
    {
        got.nodes[1].radiance.x = other;
        EXPECT_NE(textOf(firstDifference(expected, got)), "no difference");
        EXPECT_NE(textOf(firstDifference(got, expected)), "no difference");
    }
    got = expected;
    got.nodes[1].radiance.y = 1e308; // not near infinity
    EXPECT_NE(textOf(firstDifference(expected, got)), "no difference");
    got = expected;
    got.nodes[1].direction = {nan, nan, nan};
    const auto difference = firstDifference(expected, got);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->gotNode, 1) << "paired although it has no direction";
    EXPECT_FALSE(difference->angle);
    EXPECT_NE(describe(*difference).find("not a number"), std::string::npos);
}

TEST(TreeDiff, ComparesColoursByChannelAndPositionsByTheirReach)
{
    const TreeTolerance tolerance{.relative = 1e-3, .absolute = 0};
    auto expected = fan({});
    expected.nodes[0].radiance = {1000, 0.5, 0};
    expected.nodes[0].hit.emplace().t = 100;
    expected.nodes[0].hit->point = {100, 1e-9, 0};
    auto got = expected;
    got.nodes[0].hit->point.y = 0.05; // of 100
    EXPECT_EQ(textOf(firstDifference(expected, got, tolerance)), "no difference");
    got.nodes[0].hit->point.y = 0.2;
    EXPECT_EQ(firstDifference(expected, got, tolerance)->field, "hit.point");
    got = expected;
    got.nodes[0].radiance.y = 0.502;
    EXPECT_EQ(firstDifference(expected, got, tolerance)->field, "radiance");
}

/// Lesson 05's glass with a mistake: what a student is told of it.
template <class Mistake>
std::string toldOf(Mistake&& mistake, int lesson = 6)
{
    const auto scene = parseScene(R"(
[camera]
eye = [0, 0.6, 4]
target = [0, 0, 0]
[trace]
max_depth = 4
[sky]
color = [0.2, 0.3, 0.5]
[materials.glass]
ior = 1.5
[materials.floor]
color = [0.8, 0.8, 0.8]
[[sphere]]
center = [0, 0, 0]
radius = 1
material = "glass"
[[plane]]
point = [0, -1, 0]
normal = [0, 1, 0]
material = "floor"
[[light]]
position = [3, 5, 2]
color = [20, 20, 20]
)",
                                  "ball.toml");
    const auto expected = findLesson(lesson)->inspect(scene, Precision::doubled, std::array{300, 200});
    auto got = expected;
    mistake(got);
    return textOf(firstDifference(expected, got));
}

TEST(TreeDiff, NamesTheCauseAndNotTheConsequence)
{
    // n1 and n2 swapped where a ray enters: everything below and every colour above differs, too.
    const auto spoil = [](RayTree& tree) {
        for (auto& node : tree.nodes)
        {
            if (node.id > 0) turn(node.direction);
            node.radiance *= 0.9;
            node.own *= 0.8;
            node.contribution *= 0.7;
            if (node.fresnel) *node.fresnel *= 0.5;
        }
    };
    const auto swapped = toldOf([&](RayTree& tree) {
        spoil(tree);
        std::swap(tree.nodes[0].n1, tree.nodes[0].n2);
    });
    EXPECT_EQ(swapped, "camera ray [0]: n1 expected 1, got 1.5\n"
                       "The hit agrees: look at which side of the surface the ray comes from.");
    const auto fresnel = toldOf(spoil);
    EXPECT_EQ(fresnel.find("camera ray [0]: fresnel expected "), 0U) << fresnel;
    const auto direction = toldOf([&](RayTree& tree) {
        tree.nodes[2].direction = unit(tree.nodes[2].direction + Vec3<double>(0.2, 0, 0));
        tree.nodes[0].radiance *= 2;
        tree.nodes[2].hit->t *= 2;
    });
    EXPECT_EQ(direction.find("transmitted ray [2] (camera > transmitted): direction expected ("), 0U) << direction;
    EXPECT_NE(direction.find(" degrees apart\nThe point that it leaves agrees, with its normal, n1 and n2: look at the "
                             "transmitted vector."),
              std::string::npos)
        << direction;
}

/// A lesson that traces with the two indices of refraction taken for each other in one place.
struct SwappedRefraction
{
    static constexpr int number = 5;

    template <std::floating_point Real, RayRecorder<Real> Recorder = NoRecorder>
    struct Tracer
    {
        const Scene<Real>& scene;
        Recorder rec = {};

        Vec3<Real> trace(const Ray<Real>& ray)
        {
            if (ray.depth > scene.settings.maxDepth)
            {
                rec.capped(ray);
                return Vec3<Real>(0);
            }
            const auto hit = scene.intersect(ray);
            rec.ray(ray, hit);
            if (!hit)
            {
                const auto sky = scene.sky.color(ray.D);
                rec.own(sky);
                return sky;
            }
            const auto& [I, N, mat] = *hit;
            Vec3<Real> color(0);
            if (mat.isDielectric())
            {
                const Real ratio = hit->n2 / hit->n1, cos1 = -dot(N, ray.D); // n1 / n2
                const Real k = 1 - ratio * ratio * (1 - cos1 * cos1);
                const auto T = ratio * ray.D + (ratio * cos1 - std::sqrt(std::max(k, Real(0)))) * N;
                color = mat.color * trace(ray.spawn(transmitted, I, T));
            }
            rec.color(color);
            return color;
        }
    };
};

TEST(TreeDiff, LeadsToSwappedIndicesOfRefraction)
{
    const auto scene = parseScene(R"(
[sky]
color = [0.2, 0.3, 0.5]
[trace]
fresnel = "exact"
[materials.glass]
ior = 1.5
[[sphere]]
center = [0, 0, -4]
radius = 1
material = "glass"
)",
                                  "ball.toml");
    const Probe probe = GivenRay{{0, 0, 0}, {0.1, 0.05, -1}};
    const auto expected = findLesson(5)->inspect(scene, Precision::doubled, probe);
    const auto difference =
        firstDifference(expected, inspectLesson<SwappedRefraction>(scene, Precision::doubled, probe));
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->path, "camera > transmitted");
    EXPECT_EQ(difference->field, "direction");
    ASSERT_TRUE(difference->angle);
    EXPECT_GT(*difference->angle, 5);
    EXPECT_LT(*difference->angle, 60);
}

TEST(TreeDiff, ShowsAsManyDigitsAsItTakes)
{
    auto expected = fan({}), got = expected;
    expected.nodes[0].weight = 0.25;
    got.nodes[0].weight = 0.250001;
    EXPECT_EQ(firstDifference(expected, got)->got, "0.250001");
    EXPECT_EQ(firstDifference(expected, got)->expected, "0.25");
    got.nodes[0].weight = std::nextafter(0.25, 1);
    EXPECT_NE(firstDifference(expected, got, {0, 0})->got, firstDifference(expected, got, {0, 0})->expected);
    got.nodes[0].weight = 0.75;
    got.nodes[0].n1 = 1.5;
    EXPECT_EQ(firstDifference(expected, got)->got, "0.75");
    got.nodes[0].weight = 0.25;
    EXPECT_EQ(firstDifference(expected, got)->expected, "nothing");
    EXPECT_EQ(firstDifference(expected, got)->got, "1.5");
}

TEST(TreeDiff, MeasuresTheAngleInDegrees)
{
    EXPECT_NEAR(*firstDifference(fan({{0, 0, 1}}), fan({{0, 1, 0}}))->angle, 90, 1e-12);
    EXPECT_NEAR(*firstDifference(fan({{0, 0, 1}}), fan({{0, 1e-7, 1}}))->angle, 1e-7 * 57.29577951308232, 1e-14);
}

/// Compares a tree of so many rays, one below the other or all below one, with trees that differ in one place each.
void compareLarge(int nodes, bool deep)
{
    RayTree tree;
    for (int i = 0; i < nodes; ++i)
    {
        const auto turned = unit(Vec3<double>(std::sin(i), std::cos(i), 0.5 * std::sin(7 * i)));
        tree.nodes.push_back(child(i, deep ? i - 1 : i == 0 ? -1 : 0, reflected, turned));
        tree.shadows.emplace_back().node = deep ? i : 0;
        tree.capped.emplace_back().node = deep ? i : 0;
    }
    RayTree changed = tree;
    changed.nodes.back().weight = 2;
    for (auto& shadow : changed.shadows) shadow.distance = 1;
    EXPECT_EQ(firstDifference(tree, changed)->field, "distance");
    const auto match = matchTrees(tree, changed);
    EXPECT_EQ(match.gotOf.back(), nodes - 1);
    EXPECT_TRUE(match.differs.back());
    changed.shadows = tree.shadows;
    const auto difference = firstDifference(tree, changed);
    EXPECT_EQ(difference->field, "weight");
    EXPECT_EQ(difference->gotNode, nodes - 1);
    EXPECT_LT(difference->path.size(), 200U) << difference->path;
    changed.nodes.pop_back();
    changed.shadows.pop_back();
    changed.capped.pop_back();
    EXPECT_EQ(firstDifference(tree, changed)->field, deep ? "missing ray" : "missing shadow ray");
    changed.nodes.erase(changed.nodes.begin() + 1);
    EXPECT_TRUE(firstDifference(tree, changed));
}

TEST(TreeDiff, TakesDeepAndWideTreesInLinearTime)
{
    for (const bool deep : {true, false})
        EXPECT_LT(growthByEight(12500, [&](int nodes) { compareLarge(nodes, deep); }), aboutLinear) << deep;
}

TEST(TreeDiff, AcceptsAnyTwoTrees)
{
    EXPECT_TRUE(rc::check("no links, however broken, make it crash or go on for ever", [] {
        const auto broken = [] {
            RayTree tree;
            for (const int number : *rc::gen::arbitrary<std::vector<int>>())
            {
                auto node = child(number, number, RayKind(unsigned(number) % 3), {double(number), nan, 0});
                if (number % 2) node.parent = number % 7;
                if (number % 3 == 0) node.hit.emplace().t = nan;
                node.step = number;
                tree.nodes.push_back(node);
                tree.shadows.emplace_back().node = number % 5;
                tree.capped.emplace_back().node = -number;
            }
            return tree;
        };
        const auto a = broken(), b = broken();
        RC_ASSERT(!firstDifference(a, a));
        const auto difference = firstDifference(a, b);
        RC_ASSERT(difference.has_value() == firstDifference(b, a).has_value());
        if (difference) RC_ASSERT(!describe(*difference).empty());
        const auto match = matchTrees(a, b);
        RC_ASSERT(match.gotOf.size() == a.nodes.size());
        RC_ASSERT(match.expectedOf.size() == b.nodes.size());
        RC_ASSERT(match.differs.size() == a.nodes.size());
        for (std::size_t i = 0; i < a.nodes.size(); ++i)
        {
            const int partner = match.gotOf[i];
            const bool mutual = partner < 0 || match.expectedOf[std::size_t(partner)] == int(i);
            RC_ASSERT(mutual);
        }
    }));
}

} // namespace

} // namespace rt
