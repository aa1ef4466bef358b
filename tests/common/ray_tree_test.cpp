#include "common/tree/ray_tree.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/files/scene_file.h"
#include "common/tree/explain.h"
#include "lessons/programs/formulas.h"
#include "lessons/programs/registry.h"
#include "tests/common/random_scene.h"

namespace rt
{

namespace
{

/// The bits of a colour, so that 0 and -0 or two NaNs are told apart.
template <class Real>
std::array<Real, 3> channels(const Vec3<Real>& v)
{
    return {v.x, v.y, v.z};
}

class OnRandomScenes : public testing::TestWithParam<std::tuple<const LessonEntry*, Precision>>
{
protected:
    /// Trees of random rays in a random scene that the lesson models.
    template <class Visit>
    void forTrees(Visit&& visit)
    {
        const auto [lesson, precision] = GetParam();
        for (unsigned seed = 0; seed < 16; ++seed)
        {
            const SceneDescription scene = randomScene(seed, lesson->models);
            ASSERT_TRUE(missing(required(scene), lesson->models).empty());
            const Image picture = lesson->render(scene, precision, {});
            for (int i = 0; i < 12; ++i)
            {
                const int x = int((seed * 7U + unsigned(i) * 5U) % unsigned(scene.camera.width));
                const int y = int((seed * 3U + unsigned(i) * 11U) % unsigned(scene.camera.height));
                visit(scene, lesson->inspect(scene, precision, std::array{x, y}), picture.at(x, y));
            }
        }
    }
};

TEST_P(OnRandomScenes, TheRootsRadianceIsThePixelBitForBit)
{
    int lit = 0;
    forTrees([&](const SceneDescription&, const RayTree& tree, const Vec3<double>& pixel) {
        EXPECT_EQ(channels(tree.nodes.at(0).radiance), channels(pixel));
        lit += pixel != Vec3<double>(0);
    });
    EXPECT_GT(lit, 50) << "the scenes are too dark to tell anything";
}

TEST_P(OnRandomScenes, EvaluatingTheTreeGivesTheSameBits)
{
    const auto precision = std::get<1>(GetParam());
    forTrees([&](const SceneDescription&, const RayTree& tree, const Vec3<double>& pixel) {
        if (precision == Precision::floating)
            EXPECT_EQ(channels(Vec3<double>(evaluate<float>(tree))), channels(pixel));
        else if (precision == Precision::doubled)
            EXPECT_EQ(channels(evaluate<double>(tree)), channels(pixel));
        else // the tree holds long double numbers rounded to double
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(double(evaluate<long double>(tree)[c]), pixel[c], 1e-14 * std::abs(pixel[c]));
    });
}

TEST_P(OnRandomScenes, ContributionsSumToTheRadiance)
{
    const double ulp = std::get<1>(GetParam()) == Precision::floating ? 0x1p-23 : 0x1p-52;
    forTrees([&](const SceneDescription&, const RayTree& tree, const Vec3<double>&) {
        Vec3<double> sum(0);
        for (const auto& node : tree.nodes) sum += node.contribution;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(sum[c], tree.nodes[0].radiance[c], 32 * ulp * tree.nodes[0].radiance[c]);
    });
}

TEST_P(OnRandomScenes, JsonReadsBackToTheSameTree)
{
    forTrees([&](const SceneDescription&, const RayTree& tree, const Vec3<double>&) {
        const std::string json = toJson(tree);
        EXPECT_EQ(toJson(rayTreeFromJson(json)), json);
    });
}

TEST_P(OnRandomScenes, LinksAreInPreorder)
{
    forTrees([&](const SceneDescription& scene, const RayTree& tree, const Vec3<double>&) {
        const int further = scene.trace.atCap == AtCap::direct; // that policy looks one ray further
        for (const auto& node : tree.nodes)
        {
            EXPECT_FALSE(node.orphan);
            EXPECT_LE(node.depth, tree.maxDepth + further);
            if (node.id == 0)
                EXPECT_EQ(node.parent, -1);
            else
            {
                ASSERT_GE(node.parent, 0);
                EXPECT_LT(node.parent, node.id);
                EXPECT_EQ(tree.nodes[std::size_t(node.parent)].depth, node.depth - 1);
            }
            EXPECT_EQ(node.end == End::none, !tree.childrenOf(node.id).empty());
            EXPECT_GT(node.line, 0);
            EXPECT_GT(node.returnLine, 0);
        }
        for (const auto& shadow : tree.shadows) EXPECT_EQ(shadow.visible, !shadow.blocker.has_value());
    });
}

std::string paramName(const testing::TestParamInfo<OnRandomScenes::ParamType>& info)
{
    const auto [lesson, precision] = info.param;
    constexpr const char* names[] = {"Float", "Double", "LongDouble"};
    return fmt::format("Lesson{:02}{}", lesson->number, names[int(precision)]);
}

INSTANTIATE_TEST_SUITE_P(All, OnRandomScenes,
                         testing::Combine(testing::ValuesIn(lessons().begin(), lessons().end()),
                                          testing::Values(Precision::floating, Precision::doubled,
                                                          Precision::longDouble)),
                         paramName);

SceneDescription oneMirror()
{
    return parseScene(R"(
[materials.m]
color = [0.5, 0.5, 0.5]
mirror = 1.0
[[sphere]]
center = [0, 0, -3]
radius = 1
material = "m"
[[light]]
position = [0, 5, 0]
color = [1, 1, 1]
)",
                      "one_mirror.toml");
}

TEST(TreeRecorder, FlagsARayOfUnknownParentAsAnOrphan)
{
    const Scene<double> scene(oneMirror());
    RayTree tree;
    TreeRecorder<double> rec(tree, scene);
    const Ray<double> first{.O = {0, 0, 0}, .D = {0, 0, -1}};
    rec.ray(first, scene.intersect(first));
    rec.ray(first, scene.intersect(first)); // depth 0 again: a student forgot to spawn
    auto deep = first;
    deep.depth = 7;
    rec.ray(deep, scene.intersect(deep));
    rec.color({1, 1, 1});
    rec.color({1, 1, 1});
    rec.color({1, 1, 1});
    rec.color({1, 1, 1});
    ASSERT_EQ(tree.nodes.size(), 3U);
    EXPECT_FALSE(tree.nodes[0].orphan);
    EXPECT_TRUE(tree.nodes[1].orphan);
    EXPECT_TRUE(tree.nodes[2].orphan);
}

TEST(TreeRecorder, TakesEventsInAnyOrder)
{
    const Scene<double> scene(oneMirror());
    EXPECT_TRUE(rc::check("no sequence of calls makes it crash, and its links stay sound",
                          [&](const std::vector<unsigned>& calls) {
                              RayTree tree;
                              TreeRecorder<double> rec(tree, scene);
                              for (const unsigned call : calls)
                              {
                                  Ray<double> ray{.O = {0, 0, 0}, .D = {0, call % 2 ? 1.0 : 0.0, -1}};
                                  ray.depth = call % 97 == 0 ? std::numeric_limits<int>::max() : int(call / 8 % 5) - 1;
                                  const Point<double> I{{0, 0, -2}, 0};
                                  if (call % 8 < 3) rec.ray(ray, scene.intersect(ray));
                                  if (call % 8 == 3) rec.shadow(scene.lights[0], I, {0, 1, 0}, 3, call % 16 == 3);
                                  if (call % 8 == 4) rec.own({1, 1, 1});
                                  if (call % 8 == 5) rec.capped(ray);
                                  if (call % 8 > 5) rec.color({1, 2, 3});
                              }
                              for (const auto& node : tree.nodes) RC_ASSERT(node.parent < node.id);
                              for (const auto& shadow : tree.shadows) RC_ASSERT(shadow.node < int(tree.nodes.size()));
                              RC_ASSERT(!toText(tree).empty());
                              RC_ASSERT(toJson(rayTreeFromJson(toJson(tree))) == toJson(tree));
                          }));
}

TEST(TreeRecorder, WithoutATreeRecordsNothing)
{
    TreeRecorder<double> rec;
    rec.ray({}, std::nullopt);
    rec.shadow({}, {}, {}, 1, true);
    rec.own({});
    rec.capped({});
    rec.color({});
}

std::string without(std::string json, const std::string& what, const std::string& instead)
{
    const auto at = json.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return json.replace(at, what.size(), instead);
}

TEST(RayTreeJson, NamesThePlaceOfWhatIsWrong)
{
    const auto good = toJson(lessons()[1]->inspect(oneMirror(), Precision::doubled, GivenRay{{0, 0, 0}, {0, 0, -1}}));
    const std::vector<std::tuple<std::string, std::string, std::string>> faults{
        {"\"version\": 1", "\"version\": 2", "tree.version: expected a whole number from 1 to 1"},
        {"\"parent\": 0", "\"parent\": 1", "nodes[1].parent: expected a whole number from -1 to 0"},
        {"\"kind\": \"reflected\"", "\"kind\": \"bent\"",
         "nodes[1].kind: expected one of camera, reflected, transmitted"},
        {"\"parent\": 0", "\"parent\": 18446744073709551615", "nodes[1].parent: expected a whole number"},
        {"\"depth\": 1", "\"depth\": 1.5", "nodes[1].depth: expected a whole number"},
        {"\"parent\": -1", "\"parent\": 1", "nodes[0].parent: expected a whole number from -1 to -1"},
        {"\"id\": 1", "\"id\": 0", "nodes[1].id: expected a whole number from 1 to 1"},
        {"\"id\": 1", "\"id\": null", "nodes[1].id: expected a whole number"},
        {"\"depth\": 1", "\"depth\": 1048577", "nodes[1].depth: expected a whole number from 0 to 1048576"},
        {"\"weight\": 1.0", "\"weight\": \"1\"", "nodes[0].weight: expected a number, or null"},
        {"\"weight\": 1.0", "\"weight\": Nan", "not JSON: line 40, column 14: unexpected Nan"},
        {"\"weight\": 1.0", "\"weight\": 1e999", "nodes[0]: a number is larger than a double can be"},
        {"\"origin\": [0.0, 0.0, 0.0],\n   \"d", "\"origin\": [0.0, 0.0],\n   \"d",
         "nodes[0].origin: expected an array of 3 numbers"},
        {"one_mirror.toml\"", "\xff\"", "not JSON: line 4, column 12: unexpected byte"},
        {"one_mirror.toml", std::string("a\0b", 3), "not JSON: byte"},
        {"one_mirror.toml", "a\\u0000b", "tree.scene: expected at most 4096 bytes, none of them zero"},
        {"one_mirror.toml", std::string(4097, 'a'), "tree.scene: expected at most 4096 bytes"},
        {"\"lesson\": 2", "\"pixel\": [4294967296, 0]", "tree.pixel: expected an array of 2 whole numbers from"},
        {"\"lesson\": 2", "\"pixel\": [0, -2147483649]", "tree.pixel: expected an array of 2 whole numbers from"},
        {"\"lesson\": 2", "\"lesson\": 2, \"lesson\": 2", "tree.lesson: is there twice"},
        {"\"shadows\": []", "\"shadows\": [], \"nodes\": []", "nodes: is there twice"},
        {"\"shadows\": []", "\"shadows\": [7]", "shadows[0]: expected an object"},
        {"\"shadows\": []", "\"shadow\": []", "tree: the key \"shadows\" is missing"},
        {"\"capped\": []", "\"capped\": 0", "capped: expected an array"},
        {"\n}\n", "\n", "the text ends too early"},
        {"\n}\n", "\n}\n}", "unexpected }"},
        {"\n}\n", std::string("\n}\n\0", 4), "not JSON: byte"},
        {"\"depth\": 0", "\"deep\": 0", "nodes[0]: the key \"depth\" is missing"},
        {"\"shadows\": []", "\"shadows\": {}", "shadows: expected an array"},
        {"{", "[", "tree: expected an object"},
        {"{", "{{", "not JSON: line 1, column 2: unexpected {"},
    };
    for (const auto& [what, instead, expected] : faults) try
        {
            rayTreeFromJson(without(good, what, instead));
            ADD_FAILURE() << "accepted: " << instead;
        }
        catch (const std::runtime_error& error)
        {
            EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
        }
}

std::string refusal(const std::string& json)
{
    try
    {
        rayTreeFromJson(json);
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "accepted";
}

std::string repeated(const std::string& what, int times)
{
    std::string all;
    for (int i = 0; i < times; ++i) all += what;
    return all;
}

TEST(RayTreeJson, RefusesDeepNestingAtOnce)
{
    const std::string tooDeep = "arrays and objects are more than 64 deep in one another";
    EXPECT_EQ(refusal(std::string(1 << 20, '[')), "tree: expected an object");
    EXPECT_EQ(refusal("{\"version\":" + std::string(100000, '[') + std::string(100000, ']') + "}"),
              "tree.version: " + tooDeep);
    EXPECT_EQ(refusal(repeated("{\"a\":", 1000000)), "tree: " + tooDeep);
    EXPECT_EQ(refusal("{\"nodes\":[{\"hit\":" + repeated("{\"hit\":", 1000000)), "nodes[0]: " + tooDeep);
}

TEST(RayTreeJson, DoesNotKeepMoreThanATreeHolds)
{
    const std::string many = repeated("[],", 100000) + "[]";
    EXPECT_EQ(refusal("{\"nodes\":[{\"id\":[" + many + "]}]}"), "nodes[0]: holds more than 200 values");
    EXPECT_EQ(refusal("{\"pixel\":[" + many + "]}"), "tree.pixel: holds more than 200 values");
    EXPECT_EQ(refusal("{\"unknown\":[" + many + "],\"version\":1,\"nodes\":[],\"shadows\":[]}"), "accepted");
    EXPECT_EQ(refusal(std::string((64 << 20) + 1, ' ')), "67108865 bytes of JSON, at most 67108864 are read");
}

/// A node with what the schema requires and no more.
std::string smallNode(int id, int parent, const std::string& more = "")
{
    return fmt::format(
        R"({{"id":{},"parent":{},"kind":"reflected","depth":0,"origin":[0,0,0],"direction":[0,0,1],"hit":null,)"
        R"("weight":0.5,"throughput":[1,1,1],"radiance":[{},0,0],"contribution":[0,0,0],"end":null{}}})",
        id, parent, 8 >> id, more);
}

TEST(RayTreeJson, ReadsATreeOfAnotherTracer)
{
    // Lists in another order, keys of its own, whole numbers with a point, no `own`, a second root.
    const auto tree = rayTreeFromJson(
        R"({"shadows":[{"node":1.0,"light":0,"direction":[0,1,0],"distance":2,"visible":false,"blocker":null}],)"
        R"("generator":{"name":"another","id":[[1,{"id":2}],[3]]},"nodes":[)" +
        smallNode(0, -1, R"(,"samples":[[1,2],{"id":5,"kind":[]}],"tir":true)") + "," + smallNode(1, 0) + "," +
        smallNode(2, -1) + R"(],"version":1})");
    ASSERT_EQ(tree.nodes.size(), 3U);
    EXPECT_TRUE(tree.nodes[0].tir);
    EXPECT_EQ(tree.nodes[0].own, Vec3<double>(6, 0, 0)) << "8 without half of 4";
    EXPECT_EQ(tree.nodes[1].own, Vec3<double>(4, 0, 0));
    EXPECT_FALSE(tree.nodes[0].orphan);
    EXPECT_TRUE(tree.nodes[2].orphan);
    ASSERT_EQ(tree.shadows.size(), 1U);
    EXPECT_EQ(tree.shadows[0].node, 1);
}

TEST(RayTreeJson, RefusesWhatLeavesANodeThatIsNotThere)
{
    EXPECT_EQ(refusal(R"({"version":1,"nodes":[],"shadows":[{"node":0,"light":0,"direction":[0,1,0],"distance":2,)"
                      R"("visible":true}]})"),
              "shadows[0].node: there is no node 0");
    EXPECT_EQ(refusal(R"({"version":1,"shadows":[],"capped":[{"node":1,"kind":"reflected","direction":[0,1,0],)"
                      R"("weight":2,"radiance":[0,0,0],"reason":"cap"}],"nodes":[)" +
                      smallNode(0, -1) + "]}"),
              "capped[0].node: there is no node 1");
}

TEST(RayTreeJson, KeepsATreeWithNumbersThatAreNotFinite)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    auto tree = lessons()[1]->inspect(oneMirror(), Precision::doubled, GivenRay{{0, 0, 0}, {0, 0, -1}});
    tree.shadows.emplace_back().direction.x = nan;
    tree.shadows[0].distance = infinity<double>;
    tree.capped.emplace_back().radiance = {infinity<double>, 1, 2};
    tree.capped[0].weight = tree.capped[0].direction.y = nan;
    for (auto& node : tree.nodes)
    {
        node.origin.x = node.direction.y = node.radiance.z = -infinity<double>;
        node.weight = node.throughput.x = node.contribution.y = node.own.x = nan;
        if (node.hit) node.hit->t = node.hit->point.x = node.hit->normal.y = node.hit->color.z = nan;
    }
    const auto json = toJson(tree);
    const auto back = rayTreeFromJson(json);
    EXPECT_EQ(toJson(back), json);
    EXPECT_TRUE(std::isnan(back.nodes[0].weight));
    EXPECT_TRUE(std::isnan(back.nodes[0].origin.x)) << "infinity, too, is null";
    EXPECT_EQ(back.nodes[0].radiance.x, tree.nodes[0].radiance.x);
    EXPECT_TRUE(std::isnan(back.nodes[0].hit->t));
    EXPECT_TRUE(std::isnan(back.shadows[0].distance));
    EXPECT_TRUE(std::isnan(back.capped[0].radiance.x));
    EXPECT_EQ(back.capped[0].radiance.y, 1);

    // As Python, JavaScript and printf write them; in strings they stay what they are.
    tree.scene = "NaN, -inf and \\\"nan";
    const auto expected = toJson(tree);
    for (const std::string word : {"NaN", "-NaN", "nan", "-nan", "Infinity", "-Infinity", "inf", "-inf"})
    {
        auto other = expected;
        for (std::size_t at = 0; (at = other.find("null", at)) != std::string::npos; at += word.size())
            other.replace(at, 4, word);
        EXPECT_EQ(toJson(rayTreeFromJson(other)), expected) << word;
    }
    EXPECT_THROW(rayTreeFromJson("{\"version\": Nan}"), std::runtime_error);
    EXPECT_THROW(rayTreeFromJson("{\"version\": infinite}"), std::runtime_error);
}

TEST(RayTreeJson, KeepsAnyName)
{
    auto tree = lessons()[1]->inspect(oneMirror(), Precision::doubled, GivenRay{{0, 0, 0}, {0, 0, -1}});
    for (const std::string name : {"", "NaN", "-inf", "\"", "\\", "a\\\"[1,2  3]\n{}", "[", "glÄs \t\x01", ", "})
    {
        tree.scene = tree.source = tree.real = name;
        tree.nodes[0].hit->primitive = tree.nodes[0].hit->material = name;
        const auto back = rayTreeFromJson(toJson(tree));
        EXPECT_EQ(back.scene, name);
        EXPECT_EQ(back.nodes[0].hit->primitive, name);
        EXPECT_EQ(back.nodes[0].hit->material, name);
    }
}

TEST(RayTreeJson, ReadsATreeOfNinetyThousandNodes)
{
    const int nodes = 90000;
    RayTree tree;
    for (int i = 0; i < nodes; ++i)
    {
        RayTree::Node node;
        node.id = i;
        node.parent = i - 1;
        node.depth = i;
        node.hit.emplace().primitive = "sphere12";
        node.origin = Vec3<double>(1.0 / (3 + i), i, -i);
        tree.nodes.push_back(node);
    }
    EXPECT_EQ(rayTreeFromJson(toJson(tree)).nodes[89999].origin, tree.nodes[89999].origin);
}

TEST(RayTreeText, ReadsLikeTheSlide)
{
    const auto tree = lessons()[1]->inspect(oneMirror(), Precision::doubled, GivenRay{{0, 0, 0}, {0, 0, -1}});
    EXPECT_EQ(toText(tree),
              "one ray of one_mirror.toml, lesson 02, double, MAXDEPTH 8\n"
              "\n"
              "[0] Trace( camera ray, O = (0, 0, 0), D = (0, 0, -1) )\n"
              "    IntersectScene: sphere0, t = 2, I = (0, 0, -2), N = (0, 0, 1), mat = m, color = (0.5, 0.5, 0.5)\n"
              "    [1] (0.5, 0.5, 0.5) * Trace( reflected ray, O = (0, 0, -2), D = (0, 0, 1) )\n"
              "        IntersectScene: nothing\n"
              "        return (0, 0, 0)   // miss\n"
              "    return (0, 0, 0)\n");
}

/// A grey floor below a lamp, with more lines for its material.
SceneDescription greyFloor(const std::string& more = "")
{
    return parseScene(R"(
[[plane]]
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
[[light]]
position = [0, 2, 0]
color = [8, 8, 8]
[materials.floor]
color = [0.5, 0.5, 0.5]
)" + more,
                      "floor.toml");
}

TEST(Explain, GivesEveryFormulaItsNumbers)
{
    const auto scene = greyFloor();
    const auto tree = lessons()[0]->inspect(scene, Precision::doubled, GivenRay{{0, 1, 0}, {0, -1, 0}});
    const auto formulas = explainNode(tree, scene, lectureFormulas(), 0);
    ASSERT_EQ(formulas.size(), 4U);
    EXPECT_EQ(formulas[0].numbers, "(0, 1, 0) + 1 (0, -1, 0) = (0, 0, 0)\non plane0, material floor");
    EXPECT_EQ(formulas[1].symbolic, "lightColor * max(0, N.L) / dist²");
    EXPECT_EQ(formulas[1].numbers, "L = (0, 1, 0), dist = 2\n(8, 8, 8) * max(0, 1) * 0.25 = (2, 2, 2)");
    EXPECT_EQ(formulas[2].symbolic, "material color * DirectIllumination");
    EXPECT_EQ(formulas[2].numbers, "(0.5, 0.5, 0.5) * (2, 2, 2) = (1, 1, 1)");
    EXPECT_EQ(formulas[3].numbers, "(1, 1, 1) * (1, 1, 1) = (1, 1, 1)");
}

TEST(Explain, APartlySpecularSurfaceKeepsTheOtherShare)
{
    const auto scene = greyFloor("mirror = 0.25");
    const auto tree = lessons()[2]->inspect(scene, Precision::doubled, GivenRay{{0, 1, 0}, {0, -1, 0}});
    const auto formulas = explainNode(tree, scene, lectureFormulas(), 0);
    const auto& color = formulas.at(formulas.size() - 2);
    EXPECT_EQ(color.symbolic, "(1 - s) * material color * DirectIllumination + 0.25 * material color * Trace([1])");
    EXPECT_EQ(color.numbers, "(1 - 0.25) * (0.5, 0.5, 0.5) * (2, 2, 2) + 0.25 * (0.5, 0.5, 0.5) * (0, 0, 0) "
                             "= (0.75, 0.75, 0.75)");
}

} // namespace

} // namespace rt
