#include "common/files/text_file.h"
#include "viz/html/export_html.h"

#include <limits>
#include <regex>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "common/tree/events.h"
#include "lessons/programs/formulas.h"
#include "lessons/programs/registry.h"
#include "viz/state/algorithm_line.h"

namespace rt::viz
{

namespace
{

using Json = nlohmann::json;

struct Sample
{
    SceneDescription scene = loadScene(projectFile("lessons/06_fresnel/scenes/half_and_glass.toml"));
    RayTree tree = findLesson(6)->inspect(scene, Precision::doubled, scene.pixel());
    Image picture{80, 60};
    std::string title = "Lesson 06: Fresnel", source = "one\ntwo\n";

    std::string page() const { return htmlPage({tree, scene, picture, title, source, lectureFormulas()}); }
    Json data() const { return dataOf(page()); }

    static Json dataOf(const std::string& page)
    {
        const std::string open = "id=\"data\">";
        const auto start = page.find(open) + open.size();
        return Json::parse(page.substr(start, page.find("</script>", start) - start));
    }
};

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(HtmlPage, RefersToNothingOutsideOfItself)
{
    const auto page = Sample().page();
    const std::regex reference("(src|href)=\"([^\"]*)\"|url\\(|@import|\\bimport\\b");
    for (auto match = std::sregex_iterator(page.begin(), page.end(), reference); match != std::sregex_iterator();
         ++match)
        EXPECT_EQ((*match)[2].str().substr(0, 5), "data:") << match->str().substr(0, 80);
    // A namespace is a name, not an address.
    EXPECT_EQ(count(page, "http"), 2U);
    EXPECT_EQ(count(page, "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';"), 1U);
    EXPECT_EQ(count(page, "\"http://www.w3.org/2000/svg\""), 1U);
    EXPECT_EQ(count(page, "{{"), 0U);
}

TEST(HtmlPage, TextsOfStrangersNeitherRunNorLeaveTheirPlace)
{
    const std::string hostile =
        "</script><script>alert(1)</script><img src=x onerror=alert(2)>\u2028{{data}}<!-- & \"'";
    Sample sample;
    sample.title = sample.source = sample.scene.title = sample.tree.source = sample.tree.real = hostile;
    for (auto& material : sample.scene.materials) material.name = hostile;
    for (auto& node : sample.tree.nodes)
        if (node.hit) node.hit->primitive = node.hit->material = hostile;
    for (auto& shadow : sample.tree.shadows)
        if (shadow.blocker) shadow.blocker->primitive = hostile;
    const auto page = sample.page();
    EXPECT_EQ(count(page, "<script"), 2U);
    EXPECT_EQ(count(page, "</script"), 2U);
    EXPECT_EQ(count(page, "<img "), 1U);
    EXPECT_EQ(count(page, "<!--"), 0U);
    const auto data = Sample::dataOf(page);
    EXPECT_EQ(data["title"], hostile);
    EXPECT_EQ(data["source"]["text"], hostile);
    EXPECT_EQ(data["nodes"][0]["hit"], hostile);
}

TEST(HtmlPage, TextThatIsNotUtf8IsReplaced)
{
    Sample sample;
    sample.scene.title = "caf\xe9";
    EXPECT_EQ(sample.data()["scene"], "caf\uFFFD");
}

TEST(HtmlPage, SaysWhatTheTreeAndItsExplanationSay)
{
    const Sample sample;
    const auto data = sample.data();
    ASSERT_EQ(data["nodes"].size(), sample.tree.nodes.size());
    for (const auto& node : sample.tree.nodes)
    {
        const auto formulas = explainNode(sample.tree, sample.scene, lectureFormulas(), node.id);
        const auto& shown = data["nodes"][std::size_t(node.id)];
        ASSERT_EQ(shown["formulas"].size(), formulas.size());
        for (std::size_t i = 0; i < formulas.size(); ++i)
        {
            const auto& name = data["formulas"][shown["formulas"][i][0].get<std::size_t>()];
            EXPECT_EQ(name[0], formulas[i].title);
            EXPECT_EQ(name[1], formulas[i].symbolic);
            EXPECT_EQ(shown["formulas"][i][1], formulas[i].numbers);
        }
    }
    const auto events = eventsOf(sample.tree);
    ASSERT_EQ(data["events"].size(), events.size());
    for (std::size_t i = 0; i < events.size(); ++i)
    {
        EXPECT_EQ(data["events"][i][1], events[i].node);
        EXPECT_EQ(data["events"][i][3], events[i].line);
        EXPECT_EQ(data["events"][i][4], describe(sample.tree, events[i]));
    }
}

TEST(HtmlPage, LightsTheAlgorithmsLinesAndHidesMarksOfExercises)
{
    Sample sample;
    sample.source = listingText(findLesson(6)->source);
    const auto data = sample.data();
    const auto listing = listingOf(sample.source);
    const AlgorithmLines algorithm(listing);
    const auto textOf = [&](const Json& line) { return listing.lines.at(line.get<std::size_t>() - 1); };
    const auto events = eventsOf(sample.tree);
    for (std::size_t i = 0; i < events.size(); ++i)
    {
        EXPECT_EQ(data["events"][i][3], algorithm.of(events[i]));
        EXPECT_EQ(textOf(data["events"][i][3]).find("rec."), std::string::npos);
    }
    for (const auto& node : data["nodes"]) EXPECT_NE(textOf(node["line"]).find("scene.intersect("), std::string::npos);
    ASSERT_FALSE(data["source"]["hidden"].empty());
    for (const auto& line : data["source"]["hidden"]) EXPECT_TRUE(isExerciseMark(textOf(line))) << textOf(line);
}

TEST(HtmlPage, HasNullForWhatIsNoNumber)
{
    Sample sample;
    for (auto& node : sample.tree.nodes)
        node.radiance = node.throughput = node.direction = Vec3<double>(std::numeric_limits<double>::quiet_NaN());
    sample.tree.nodes[1].weight = infinity<double>;
    const auto data = sample.data();
    EXPECT_TRUE(data["nodes"][0]["weight"].is_null());
    EXPECT_TRUE(data["nodes"][1]["share"].is_null());
    EXPECT_EQ(data["nodes"][0]["swatch"], "");
    EXPECT_EQ(data["energy"]["broken"], sample.tree.nodes.size());
}

TEST(HtmlPage, ExistsForATreeWithoutRays)
{
    Sample sample;
    sample.tree.nodes.clear();
    sample.tree.shadows.clear();
    sample.tree.capped.clear();
    sample.picture = {};
    const auto page = sample.page();
    EXPECT_EQ(Sample::dataOf(page)["events"].size(), 0U);
    EXPECT_EQ(count(page, "src=\"\""), 1U);
}

/// A tree in which every ray has two children, each asking one light.
RayTree grown(const RayTree& small, int nodes)
{
    RayTree tree = small;
    tree.nodes.clear();
    tree.shadows.clear();
    tree.capped.clear();
    for (int id = 0; id < nodes; ++id)
    {
        auto node = small.nodes[0];
        node.id = id;
        node.parent = id == 0 ? -1 : (id - 1) / 2;
        node.depth = id == 0 ? 0 : tree.nodes[std::size_t(node.parent)].depth + 1;
        node.step = node.returnStep = 0;
        tree.nodes.push_back(node);
        tree.shadows.emplace_back().node = id;
    }
    return tree;
}

TEST(HtmlPage, ShowsTheLeastDeepRaysOfALargeTreeAndSaysSo)
{
    Sample sample;
    const int all = mostHtmlNodes + 5000;
    sample.tree = grown(sample.tree, all);
    // Another tracer may say anything of a depth: this node's parent is not shown, so it is not either.
    sample.tree.nodes.back().depth = 0;
    sample.tree.nodes.back().parent = all - 2;
    const auto data = sample.data();
    const int shown = mostHtmlNodes - 1;
    EXPECT_EQ(data["nodes"].size(), std::size_t(shown));
    EXPECT_EQ(data["hidden"], all - shown);
    std::set<int> ids;
    int explained = 0;
    for (const auto& node : data["nodes"])
    {
        ids.insert(node["id"].get<int>());
        explained += node.contains("formulas");
        const int parent = node["parent"].get<int>();
        EXPECT_TRUE(parent == -1 || ids.count(parent)) << node["id"];
    }
    EXPECT_EQ(explained, mostExplained);
    EXPECT_EQ(data["unexplained"], shown - mostExplained);
    for (const auto& event : data["events"])
    {
        ASSERT_TRUE(ids.count(event[1].get<int>()));
        if (event[0] != int(Event::Kind::shadow)) continue;
        ASSERT_EQ(data["shadows"][event[2].get<std::size_t>()]["node"], event[1]);
    }
}

TEST(HtmlPage, ReducesAPictureUntilItIsSmall)
{
    Sample sample;
    sample.picture = Image(1280, 960);
    unsigned noise = 1;
    for (auto& pixel : sample.picture.pixels)
        pixel = Vec3<double>(double((noise = noise * 1664525U + 1013904223U) >> 24) / 255);
    EXPECT_LT(sample.page().size(), 500'000U);
    sample.picture = Image(1, 1);
    EXPECT_EQ(count(sample.page(), "src=\"data:image/png;base64,iVBORw0KGgo"), 1U);
}

TEST(HtmlPage, OfALessonIsSmall)
{
    Sample sample;
    sample.source = readTextFile(projectFile(findLesson(6)->source));
    sample.picture = findLesson(6)->render(sample.scene, Precision::doubled, {});
    EXPECT_LT(sample.page().size(), 180'000U);
}

} // namespace

} // namespace rt::viz
