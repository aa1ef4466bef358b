#include "viz/state/algorithm_line.h"

#include <algorithm>
#include <atomic>
#include <set>

#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"

namespace rt::viz
{

namespace
{

struct Source
{
    explicit Source(const std::string& file) : listing(readListing(file, projectFile(""))), algorithm(listing) {}

    Listing listing;
    AlgorithmLines algorithm;

    const std::string& text(int line) const { return listing.lines.at(std::size_t(line) - 1); }
};

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// What the recorder's statement is to lead to.
void check(const Source& source, int line)
{
    const auto& text = source.text(line);
    const auto at = text.find("rec.") + 4;
    const auto call = text.substr(at, text.find('(', at) - at);
    const auto& value = source.text(source.algorithm.of(line, Told::value));
    const auto& end = source.text(source.algorithm.of(line, Told::end));
    const auto where = source.listing.source + ":" + std::to_string(line) + ": ";
    if (call == "ray")
    {
        EXPECT_TRUE(has(value, "const auto hit = ") && has(value, "scene.intersect(ray")) << where << value;
        EXPECT_TRUE(has(end, "return")) << where << end; // of a miss
    }
    else if (call == "shadow")
        EXPECT_TRUE(has(value, "bool visible = ")) << where << value;
    else if (call == "own")
        EXPECT_TRUE(has(value, "color = ") || has(value, "sky = ")) << where << value;
    else if (call == "fresnel")
        EXPECT_TRUE(has(value, "Fr = ")) << where << value;
    else
    {
        EXPECT_TRUE(call == "color" || call == "capped" || call == "cutoff") << where << call;
        EXPECT_TRUE(has(end, "return ")) << where << end;
    }
}

TEST(AlgorithmLine, OfEachRecordersLineInEachLesson)
{
    for (const auto* lesson : lessons())
    {
        const Source source(lesson->source);
        int found = 0;
        for (int line = 1; line <= int(source.listing.lines.size()); ++line)
            if (source.text(line).find_first_not_of(' ') == source.text(line).find("rec.") &&
                has(source.text(line), "rec."))
            {
                check(source, line);
                ++found;
            }
            else
                EXPECT_EQ(source.algorithm.of(line, Told::value), line);
        EXPECT_GE(found, 3) << lesson->source;
    }
}

/// Stepping never lights a recorder, whatever happens.
TEST(AlgorithmLine, OfEachEventInEachLesson)
{
    const std::atomic<bool> goOn = false;
    for (const auto* lesson : lessons())
    {
        const Source source(lesson->source);
        auto scene = loadScene(projectFile(lesson->scene));
        std::set<Event::Kind> kinds;
        for (const int depth : {0, 4})
        {
            scene.trace.maxDepth = depth;
            const auto tree = lesson->inspect(scene, Precision::doubled, scene.pixel(), &goOn);
            for (const auto& event : eventsOf(tree))
            {
                kinds.insert(event.kind);
                const auto& text = source.text(source.algorithm.of(event));
                const char* expected = event.kind == Event::Kind::follow   ? "scene.intersect(ray"
                                       : event.kind == Event::Kind::shadow ? "!scene.occluded("
                                                                           : "return ";
                EXPECT_TRUE(has(text, expected)) << lesson->source << ", " << describe(tree, event) << ": " << text;
                const int call = source.algorithm.callOf(tree, event);
                const bool isSent =
                    event.kind == Event::Kind::notFollowed ||
                    (event.kind == Event::Kind::follow && tree.nodes[std::size_t(event.node)].parent >= 0);
                EXPECT_EQ(call > 0, isSent) << lesson->source << ", " << describe(tree, event);
                EXPECT_TRUE(call == 0 || has(source.text(call), "trace(ray.spawn("));
            }
        }
        EXPECT_TRUE(kinds.contains(Event::Kind::returns)) << lesson->source;
    }
}

/// A reflected ray at glass is sent by another line than one at a mirror.
TEST(AlgorithmLine, OfACallIsThatOfTheRaysKindAndSurface)
{
    const Source source(findLesson(6)->source);
    RayTree tree;
    tree.nodes.resize(2);
    tree.nodes[1].parent = 0;
    tree.nodes[1].kind = RayKind::reflected;
    for (int line = 1; line <= int(source.listing.lines.size()); ++line)
        if (has(source.text(line), "rec.ray(")) tree.nodes[0].line = line;
    const Event event{.kind = Event::Kind::follow, .node = 1};
    EXPECT_TRUE(has(source.text(source.algorithm.callOf(tree, event)), "color += s * "));
    tree.nodes[0].n1 = 1;
    EXPECT_TRUE(has(source.text(source.algorithm.callOf(tree, event)), "color += Fr * "));
    tree.nodes[1].kind = RayKind::transmitted;
    EXPECT_TRUE(has(source.text(source.algorithm.callOf(tree, event)), "color += Ft * "));
}

TEST(AlgorithmLine, OfStrangersSourcesIsTheirOwn)
{
    const AlgorithmLines lines(listingOf("rec.ray(ray, hit);\nint f()\n{\n    hit == 1;\n    rec.ray(ray, hit);\n    "
                                         "\"return\"; // return\n    rec.color(a + b);\n}\nreturn;\n"));
    for (int line = -1; line < 12; ++line)
        for (const auto told : {Told::value, Told::end}) EXPECT_EQ(lines.of(line, told), line);
    EXPECT_EQ(AlgorithmLines({}).of(3, Told::end), 3);
}

} // namespace

} // namespace rt::viz
