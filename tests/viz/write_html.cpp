// Writes the page of a pixel, or of a tree that no tracer would make, for html_test.py to look at.
#include <filesystem>
#include <iostream>
#include <limits>

#include <fmt/format.h>

#include "common/files/scene_file.h"
#include "common/files/text_file.h"
#include "common/program/cli.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/formulas.h"
#include "lessons/programs/registry.h"
#include "viz/html/export_html.h"

namespace rt::viz
{

namespace
{

const std::string hostile =
    "</script><script>document.title='broken out'</script><img src=x onerror=alert(1)>\u2028{{data}}<!--&amp;\"'";

/// A tree in which every ray of the last level has two children, until it has so many nodes.
RayTree grown(const RayTree& tree, std::size_t nodes)
{
    RayTree large = tree;
    large.nodes.resize(1);
    large.shadows.clear();
    large.capped.clear();
    const auto first = large.nodes[0];
    while (large.nodes.size() < nodes)
    {
        auto node = first;
        node.id = int(large.nodes.size());
        node.parent = (node.id - 1) / 2;
        const auto& parent = large.nodes[std::size_t(node.parent)];
        node.kind = node.id % 2 == 1 ? RayKind::reflected : RayKind::transmitted;
        node.depth = parent.depth + 1;
        node.throughput = parent.throughput * 0.5;
        large.nodes.push_back(node);
    }
    for (auto& node : large.nodes) node.step = node.returnStep = 0;
    return large;
}

void change(const std::string& variant, RayTree& tree, SceneDescription& scene)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (variant == "empty")
        tree.nodes.clear(), tree.shadows.clear(), tree.capped.clear();
    else if (variant == "nan")
        for (auto& node : tree.nodes)
        {
            node.radiance = node.contribution = node.throughput = node.direction = Vec3<double>(nan);
            node.weight = nan;
            if (node.hit) node.hit->t = nan, node.hit->normal = Vec3<double>(nan);
        }
    else if (variant == "huge")
        for (auto& node : tree.nodes)
        {
            node.radiance = node.contribution = node.throughput = Vec3<double>(1e308);
            if (node.id > 0) node.origin = Vec3<double>(1e300, -1e300, 1e300);
        }
    else if (variant == "orphans")
        for (auto& node : tree.nodes)
        {
            node.parent = -1;
            node.depth = 0;
            node.orphan = true;
        }
    else if (variant == "large")
        tree = grown(tree, 10000);
    else if (variant == "hostile")
    {
        scene.title = scene.file = tree.scene = tree.source = tree.real = hostile;
        for (auto& material : scene.materials) material.name = hostile;
        for (auto& node : tree.nodes)
            if (node.hit) node.hit->primitive = node.hit->material = hostile;
        for (auto& shadow : tree.shadows)
            if (shadow.blocker) shadow.blocker->primitive = hostile;
    }
    else if (!variant.empty())
        throw std::runtime_error(variant + ": expected empty, nan, huge, orphans, large or hostile");
}

int run(int argc, char** argv)
{
    if (argc < 5 || argc > 6)
    {
        std::cerr << "usage: write_html SCENE LESSON x,y|- OUT [empty|nan|huge|orphans|large|hostile]\n";
        return exitBadInput;
    }
    const std::string variant = argc > 5 ? argv[5] : "", pixel = argv[3];
    auto scene = loadScene(std::filesystem::absolute(argv[1]).string());
    const auto* lesson = findLesson(std::stoi(argv[2]));
    if (!lesson) throw std::runtime_error(fmt::format("{}: there is no such lesson", argv[2]));
    if (variant == "" && pixel == "0,0") scene.camera.width = scene.camera.height = 1; // a picture of one pixel
    Probe probe = scene.pixel();
    if (pixel != "-")
    {
        const auto xy = numbers(pixel, 2, "pixel");
        probe = std::array{int(xy[0]), int(xy[1])};
    }
    auto tree = lesson->inspect(scene, Precision::doubled, probe);
    tree.source = lesson->source;
    auto camera = scene;
    if (!variant.empty()) camera.camera.width = 80, camera.camera.height = 60; // a tree like this is no picture's
    const auto picture = lesson->render(camera, Precision::doubled, {});
    change(variant, tree, scene);
    const auto title = variant == "hostile" ? hostile : fmt::format("Lesson {:02}: {}", lesson->number, lesson->title);
    const auto source = readTextFile(projectFile(lesson->source)) + (variant == "hostile" ? hostile : "");
    writeTextFile(argv[4], htmlPage({tree, scene, picture, title, source, lectureFormulas()}));
    return exitDone;
}

} // namespace

} // namespace rt::viz

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::viz::run(argc, argv); });
}
