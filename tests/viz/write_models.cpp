// Writes what glTF programs are to read: write_models FOLDER [LESSON SCENE]... One .glb and .gltf and .vtp for each scene, and
// trees that no lesson records. Prints a line for each: name, bytes of the three files, milliseconds of each.
#include <charconv>
#include <chrono>
#include <cmath>
#include <iostream>

#include <fmt/format.h>

#include "common/files/scene_file.h"
#include "common/files/text_file.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/registry.h"
#include "viz/export/export_gltf.h"
#include "viz/export/export_vtp.h"

namespace
{

using namespace rt;
using vec3 = Vec3<double>;

void write(const std::string& name, const RayTree& tree, const SceneDescription& scene)
{
    std::string line = fmt::format("{}: {} rays", name, tree.nodes.size());
    const auto add = [&](const char* ending, auto make) {
        const auto start = std::chrono::steady_clock::now();
        const std::string bytes = make(tree, scene);
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        writeTextFile(name + ending, bytes);
        line += fmt::format(", {} {} bytes {:.1f} ms", ending, bytes.size(), time.count());
    };
    add(".glb", viz::gltfBinary);
    add(".gltf", viz::gltfText);
    add(".vtp", viz::vtpText);
    std::cout << line << "\n";
}

RayTree::Shadow shadow(int node, const vec3& direction, double distance, bool visible)
{
    RayTree::Shadow made;
    made.node = node;
    made.direction = direction;
    made.distance = distance;
    made.visible = visible;
    return made;
}

/// A chain or a bush of `count` rays, with a shadow ray each.
RayTree large(int count, bool chain)
{
    RayTree tree;
    for (int i = 0; i < count; ++i)
    {
        const int parent = i == 0 ? -1 : chain ? i - 1 : (i - 1) / 2;
        const vec3 from = i == 0 ? vec3(0, 1, 6) : tree.nodes[std::size_t(parent)].hit->point;
        const vec3 D = unit(vec3(std::sin(i * 1.3), 0.4 * std::cos(i * 0.7), i == 0 ? -1 : std::cos(i * 1.3)));
        RayTree::Node node;
        node.id = i;
        node.parent = parent;
        node.depth = i == 0 ? 0 : tree.nodes[std::size_t(parent)].depth + 1;
        node.kind = i == 0 ? RayKind::camera : i % 2 ? RayKind::reflected : RayKind::transmitted;
        node.origin = from;
        node.direction = D;
        node.hit = RayTree::Hit{.t = 1, .point = from + D, .normal = -D, .primitive = "sphere0", .material = "m"};
        tree.nodes.push_back(node);
        tree.shadows.push_back(shadow(i, {0, 1, 0}, 5, i % 3 != 0));
    }
    return tree;
}

/// Every number that may be missing is, once in each ray.
RayTree poisoned(const RayTree& good)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    RayTree tree = good;
    for (int k = 0; k < 9; ++k)
    {
        RayTree::Node node = good.nodes[0];
        node.id = int(tree.nodes.size());
        node.parent = 0;
        node.depth = 1;
        if (!node.hit) node.hit.emplace();
        double* const numbers[] = {&node.origin.x,     &node.direction.y,   &node.hit->t,
                                   &node.hit->point.z, &node.weight,        &node.radiance.x,
                                   &node.throughput.y, &node.hit->normal.x, &node.contribution.z};
        *numbers[k] = k % 2 ? nan : infinity<double>;
        tree.nodes.push_back(node);
        tree.shadows.push_back(shadow(node.id, {nan, 1, 0}, infinity<double>, false));
        tree.shadows.push_back(shadow(node.id, {0, 0, 0}, 1e300, true));
    }
    return tree;
}

const std::string hostile = "\"}],\xff\xfe</DataArray>\n\\u0000<&'" + std::string(1, '\0') + "\xc3";

int run(int argc, char** argv)
{
    if (argc < 2 || argc % 2)
    {
        std::cerr << "usage: write_models FOLDER [LESSON SCENE]...\n";
        return 2;
    }
    const std::string folder = std::string(argv[1]) + "/";
    for (int i = 2; i + 1 < argc; i += 2)
    {
        const auto scene = loadScene(std::string(argv[i + 1]));
        const auto* lesson = findLesson(std::atoi(argv[i]));
        if (!lesson) throw std::runtime_error(fmt::format("there is no lesson {}", argv[i]));
        const std::string file = argv[i + 1], stem = file.substr(file.find_last_of('/') + 1);
        write(fmt::format("{}{}_{}", folder, argv[i], stem.substr(0, stem.find('.'))),
              lesson->inspect(scene, Precision::doubled, scene.pixel()), scene);
    }

    SceneDescription scene;
    scene.camera = {.eye = {0, 1, 6}, .target = {0, 1, 0}};
    write(folder + "empty_tree", {}, scene);
    scene.materials = {{.name = "m"}, {.name = "glass", .ior = 1.5}, {.name = "air", .ior = 1, .iorOutside = 1.5}};
    scene.spheres = {{{0, 1, 0}, 1, 0}, {{2, 1, 0}, 1, 1}, {{2, 1, 0}, 0.9, 2}};
    scene.planes = {{.hasChecker = true}};
    scene.lights = {{{0, 5, 0}, {60, 30, 0}}, {{1, 5, 0}, {0, 0, 0}}};
    write(folder + "bush", large(10000, false), scene);
    write(folder + "chain", large(1000, true), scene);

    SceneDescription bad = scene;
    bad.spheres.push_back({{1e300, 0, 0}, 1, 0});
    bad.triangles = {{{vec3(0), vec3(0), vec3(0)}, 0}, {{vec3(0), vec3(1e100, 0, 0), vec3(0, 1, 0)}, 0}};
    bad.lights.push_back({{1e300, 0, 0}, {1, 1, 1}});
    bad.lights.push_back({{0, 1, 0}, {1e300, 1, 1}});
    write(folder + "poisoned", poisoned(large(3, false)), bad);

    SceneDescription named = scene;
    named.title = named.file = hostile;
    for (auto& material : named.materials) material.name = hostile;
    RayTree tree = large(3, false);
    tree.scene = hostile;
    for (auto& node : tree.nodes) node.hit->primitive = node.hit->material = hostile;
    tree.shadows[0].blocker = {hostile, {0, 2, 0}};
    write(folder + "hostile_names", tree, named);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
