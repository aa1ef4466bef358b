#include "common/ray_tree.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/explain.h"
#include "common/scene_file.h"
#include "lessons/formulas.h"
#include "lessons/registry.h"
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
        {"\"weight\": 1.0", "\"weight\": null", "nodes[0].weight: expected a finite number"},
        {"\"depth\": 0", "\"deep\": 0", "nodes[0]: the key \"depth\" is missing"},
        {"\"shadows\": []", "\"shadows\": {}", "shadows: expected an array"},
        {"{", "[", "not JSON"},
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

TEST(RayTreeJson, SurvivesDeepNesting)
{
    EXPECT_THROW(rayTreeFromJson(std::string(1 << 20, '[')), std::runtime_error);
    EXPECT_THROW(rayTreeFromJson("{\"version\":" + std::string(100000, '[') + std::string(100000, ']') + "}"),
                 std::runtime_error);
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

TEST(Explain, GivesEveryFormulaItsNumbers)
{
    const auto scene = parseScene(R"(
[materials.floor]
color = [0.5, 0.5, 0.5]
[[plane]]
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
[[light]]
position = [0, 2, 0]
color = [8, 8, 8]
)",
                                  "floor.toml");
    const auto tree = lessons()[0]->inspect(scene, Precision::doubled, GivenRay{{0, 1, 0}, {0, -1, 0}});
    const auto formulas = explainNode(tree, scene, lectureFormulas(), 0);
    ASSERT_EQ(formulas.size(), 4U);
    EXPECT_EQ(formulas[0].numbers, "(0, 1, 0) + 1 (0, -1, 0) = (0, 0, 0)\non plane0, material floor");
    EXPECT_EQ(formulas[1].symbolic, "lightColor * max(0, N.L) / dist²");
    EXPECT_EQ(formulas[1].numbers, "L = (0, 1, 0), dist = 2\n(8, 8, 8) * max(0, 1) * 0.25 = (2, 2, 2)");
    EXPECT_EQ(formulas[3].numbers, "(1, 1, 1) * (1, 1, 1) = (1, 1, 1)");
}

} // namespace

} // namespace rt
