// How long the viewer takes from a click to the complete redraw, in a window of 1600x900. Needs a display:
//     xvfb-run -a build/release/bin/viewer_bench
#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "common/files/scene_file.h"
#include "common/program/guarded_main.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"
#include "viz/window/window.h"

namespace
{

using namespace rt;
using namespace rt::viz;

using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Median and extremes of wall time in ms.
void report(const std::string& what, std::size_t nodes, std::vector<double> ms)
{
    std::sort(ms.begin(), ms.end());
    std::cout << fmt::format("{:<26} {:>6} nodes   median {:7.1f} ms   {:7.1f} to {:7.1f}\n", what, nodes,
                             ms[ms.size() / 2], ms.front(), ms.back());
}

void report(const std::string& what, std::size_t nodes, int times, const std::function<void(int)>& act)
{
    std::vector<double> ms;
    for (int i = 0; i <= times; ++i)
    {
        const auto start = Clock::now();
        act(i);
        if (i > 0) ms.push_back(msSince(start)); // the first warms up
    }
    report(what, nodes, std::move(ms));
}

/// Another depth cap: until the coarse picture is on the screen, until all panes are, until the final picture is; then
/// the slider is dragged, with 60 movements a second, and each call is timed that keeps the window from listening.
void measureRefining(Controller& controller, Window& window)
{
    constexpr auto tickTime = std::chrono::milliseconds(80), moveTime = std::chrono::milliseconds(16);
    const int cap = controller.maxDepth();
    const auto nodes = controller.tree().nodes.size();
    Clock::time_point start;
    std::optional<double> seen;
    const auto draw = controller.changed;
    controller.changed = [&](unsigned changes) {
        draw(changes);
        if (!seen && (changes & (changedPass | changedPicture))) seen = msSince(start);
    };
    const auto finish = [&] {
        while (controller.isRefining())
        {
            std::this_thread::sleep_for(tickTime);
            window.tick();
        }
    };
    std::vector<double> coarse, whole, final;
    for (int i = 0; i <= 20; ++i)
    {
        start = Clock::now();
        seen.reset();
        controller.setMaxDepth(cap - i % 2);
        const double drawn = msSince(start);
        finish();
        if (i == 0) continue;
        coarse.push_back(*seen);
        whole.push_back(drawn);
        final.push_back(msSince(start));
    }
    report("MAXDEPTH: coarse picture", nodes, coarse);
    report("  all panes", nodes, whole);
    report("  final picture", nodes, final);

    std::vector<double> stalls;
    auto ticked = Clock::now();
    const auto timed = [&](const auto& act) {
        const auto begun = Clock::now();
        act();
        stalls.push_back(msSince(begun));
    };
    for (int i = 0; i < 60; ++i)
    {
        timed([&] { controller.setMaxDepth(std::abs(i % (2 * cap) - cap)); }); // to 0 and back
        if (Clock::now() - ticked >= tickTime)
        {
            timed([&] { window.tick(); });
            ticked = Clock::now();
        }
        std::this_thread::sleep_for(moveTime);
    }
    finish();
    report("  drag the slider", nodes, stalls);
    controller.setMaxDepth(cap);
    controller.wait();
    controller.changed = draw;
}

Session sessionOf(int lesson, int depth)
{
    Session session;
    session.scene = loadScene(projectFile(findLesson(lesson)->scene));
    session.scene.trace.maxDepth = depth;
    session.source = lessonSource(*findLesson(lesson), Precision::doubled);
    session.probe = session.scene.pixel();
    return session;
}

/// As many rays, two from each.
RayTree largeTree(int count)
{
    RayTree tree;
    for (int id = 0; id < count; ++id)
    {
        RayTree::Node node;
        node.id = id;
        node.parent = (id + 1) / 2 - 1;
        node.kind = id == 0 ? RayKind::camera : id % 2 ? RayKind::reflected : RayKind::transmitted;
        node.depth = id == 0 ? 0 : tree.nodes[std::size_t(node.parent)].depth + 1;
        node.direction = {0, 0, -1};
        node.hit.emplace();
        node.hit->t = 1;
        node.hit->point = {0.01 * id, 0, -1.0 - node.depth};
        node.hit->normal = {0, 0, 1};
        node.hit->primitive = "sphere0";
        node.throughput = Vec3<double>(std::pow(0.7, node.depth));
        tree.nodes.push_back(node);
    }
    return tree;
}

void measure(Session session, const std::string& title)
{
    Controller controller(std::move(session));
    Window window(controller, {.width = 1600, .height = 900}, true);
    window.picture();
    std::cout << title << '\n';
    const auto pixel = controller.pixel().value_or(std::array{0, 0});
    const auto nodes = controller.tree().nodes.size();
    if (!controller.source().isFixed)
    {
        // Two neighbours, whose trees are much the same.
        report("click on a pixel", nodes, 20, [&](int i) { controller.choosePixel(pixel[0] + i % 2, pixel[1]); });
        controller.choosePixel(pixel[0], pixel[1]);
    }
    report("choose a ray", nodes, 20, [&](int i) { controller.selectNode(i % int(nodes)); });
    controller.stepTo(0);
    report("one step", nodes, 20, [&](int i) { controller.stepTo(1 + i % controller.lastStep()); });
    controller.stepTo(controller.lastStep());
    report("point at a ray in the tree", nodes, 20, [&](int i) { controller.hover(i % int(nodes)); });
    // The wheel; viz/base/layout.cpp says where the panes are.
    report("zoom the tree", nodes, 20, [&](int i) { window.wheel(1300, 600, i % 4 < 2); });
    report("zoom the scene", nodes, 20, [&](int i) { window.wheel(800, 600, i % 4 < 2); });
    report("show or hide a kind", nodes, 20, [&](int) { controller.toggle(Kind::reflected); });
    if (!controller.source().isFixed) measureRefining(controller, window);
    if (nodes > 1000) report("go to a ray by its number", nodes, 20, [&](int i) { controller.selectNode(37 * i); });
}

int run()
{
    measure(sessionOf(2, 8), "lesson 02, pure specular");
    measure(sessionOf(6, 8), "lesson 06, glass");
    measure(sessionOf(6, 40), "lesson 06, glass, MAXDEPTH 40");
    measure(sessionOf(7, 14), "lesson 07, mirror box, MAXDEPTH 14");
    Session large = sessionOf(6, 8);
    large.source = fileSource(largeTree(10000), "large.json");
    measure(std::move(large), "a tree from a file");
    return 0;
}

} // namespace

int main(int, char** argv)
{
    return rt::guarded(argv, [] { return run(); });
}
