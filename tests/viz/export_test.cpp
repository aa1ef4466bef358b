// The files for other programs, read back. gltf_test.py asks the Khronos validator.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include "common/base/image.h"
#include "common/files/base64.h"
#include "common/files/picture_file.h"
#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "common/scene/scene.h"
#include "lessons/programs/registry.h"
#include "viz/drawing/rays.h"
#include "viz/export/export_gltf.h"
#include "viz/export/export_vtp.h"

namespace rt::viz
{

namespace
{

using Json = nlohmann::json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A .glb taken apart.
struct Glb
{
    Json json;
    std::string buffer;

    explicit Glb(const std::string& bytes)
    {
        const auto number = [&](std::size_t at) {
            std::uint32_t value = 0;
            std::memcpy(&value, bytes.data() + at, sizeof value);
            return std::size_t(value);
        };
        EXPECT_EQ(bytes.substr(0, 4), "glTF");
        EXPECT_EQ(number(4), 2U);
        EXPECT_EQ(number(8), bytes.size());
        const std::size_t size = number(12);
        EXPECT_EQ(bytes.substr(16, 4), "JSON");
        json = Json::parse(bytes.substr(20, size));
        if (20 + size == bytes.size()) return;
        EXPECT_EQ(bytes.substr(24 + size, 4), std::string("BIN\0", 4));
        buffer = bytes.substr(28 + size);
        EXPECT_EQ(number(20 + size), buffer.size());
        EXPECT_EQ(size % 4 + buffer.size() % 4, 0U) << "chunks end at multiples of 4";
        EXPECT_EQ(json["buffers"][0]["byteLength"], buffer.size());
    }

    /// Row by row; what the file says of type and place is followed.
    template <class Value>
    std::vector<Value> values(int accessor) const
    {
        const auto& a = json["accessors"].at(std::size_t(accessor));
        const auto& view = json["bufferViews"].at(a["bufferView"].get<std::size_t>());
        const auto components = a["type"] == "SCALAR" ? 1U : unsigned(a["type"].get<std::string>()[3] - '0');
        const std::size_t count = a["count"].get<std::size_t>() * components;
        const std::size_t start = a["byteOffset"].get<std::size_t>();
        EXPECT_LE(start + count * sizeof(Value), view["byteLength"].get<std::size_t>());
        EXPECT_TRUE(!view.contains("byteStride") || view["byteStride"] == components * sizeof(Value));
        std::vector<Value> found(count);
        std::memcpy(found.data(), buffer.data() + view["byteOffset"].get<std::size_t>() + start, count * sizeof(Value));
        return found;
    }

    std::vector<vec3> points(int accessor) const
    {
        EXPECT_EQ(json["accessors"][std::size_t(accessor)]["componentType"], 5126);
        const auto flat = values<float>(accessor);
        std::vector<vec3> found;
        for (std::size_t i = 0; i + 2 < flat.size(); i += 3) found.emplace_back(flat[i], flat[i + 1], flat[i + 2]);
        return found;
    }

    std::vector<std::size_t> indices(int accessor) const
    {
        const auto type = json["accessors"][std::size_t(accessor)]["componentType"].get<int>();
        std::vector<std::size_t> found;
        if (type == 5123)
            for (const auto i : values<std::uint16_t>(accessor)) found.push_back(i);
        else
            for (const auto i : values<std::uint32_t>(accessor)) found.push_back(i);
        return found;
    }

    /// The nodes of that name's beginning.
    std::vector<Json> named(const std::string& start) const
    {
        std::vector<Json> found;
        for (const auto& node : json["nodes"])
            if (node["name"].get<std::string>().rfind(start, 0) == 0) found.push_back(node);
        return found;
    }

    const Json& node(const std::string& name) const
    {
        for (const auto& node : json["nodes"])
            if (node["name"] == name) return node;
        throw std::runtime_error("no node is called " + name);
    }

    /// All points of a node's mesh.
    std::vector<vec3> pointsOf(const Json& node) const
    {
        std::vector<vec3> all;
        if (!node.contains("mesh")) return all;
        for (const auto& primitive : json["meshes"][node["mesh"].get<std::size_t>()]["primitives"])
            for (const auto& p : points(primitive["attributes"]["POSITION"])) all.push_back(p);
        return all;
    }
};

struct Traced
{
    SceneDescription scene;
    RayTree tree;
};

Traced trace(const std::string& file)
{
    const auto scene = loadScene(projectFile(file));
    return {scene, smallestLesson(scene)->inspect(scene, Precision::doubled, scene.pixel())};
}

const std::vector<std::string> files{
    "lessons/02_mirrors/scenes/pure_specular.toml", "lessons/03_partial_reflection/scenes/half_specular.toml",
    "lessons/05_refraction/scenes/slab.toml",       "lessons/06_fresnel/scenes/half_and_glass.toml",
    "lessons/06_fresnel/scenes/gem.toml",           "lessons/07_recursion_caps/scenes/mirror_box.toml",
    "lessons/08_phong/scenes/everything.toml"};
const std::string glass = "lessons/06_fresnel/scenes/half_and_glass.toml";

std::string nameOf(const RayTree::Node& ray)
{
    return "[" + std::to_string(ray.id) + "] " + name(ray.kind) + " depth " + std::to_string(ray.depth);
}

void expectSame(const Json& extras, const char* key, const vec3& v)
{
    EXPECT_EQ(extras[key], Json({v.x, v.y, v.z})) << key;
}

/// The nodes below a node, it included.
std::set<int> below(const Json& json, int root, int* levels = nullptr)
{
    std::set<int> found;
    std::vector<std::pair<int, int>> waiting{{root, 1}};
    while (!waiting.empty())
    {
        const auto [index, level] = waiting.back();
        waiting.pop_back();
        EXPECT_TRUE(found.insert(index).second) << "node " << index << " has two parents";
        if (levels) *levels = std::max(*levels, level);
        const auto& node = json["nodes"][std::size_t(index)];
        if (node.contains("children"))
            for (const auto& child : node["children"]) waiting.emplace_back(child.get<int>(), level + 1);
    }
    return found;
}

RayTree chain(int count)
{
    RayTree tree;
    for (int i = 0; i < count; ++i)
    {
        RayTree::Node ray;
        ray.id = ray.depth = i;
        ray.parent = i - 1;
        ray.origin = {i % 2, 0, 0};
        ray.direction = {i % 2 ? -1 : 1, 0, 0};
        ray.hit.emplace();
        ray.hit->t = 1;
        ray.hit->point = {1 - i % 2, 0, 0};
        ray.hit->normal = -ray.direction;
        tree.nodes.push_back(ray);
    }
    return tree;
}

// glTF.

TEST(Gltf, HasANodeForEachRayWithItsNumbers)
{
    for (const auto& file : files)
    {
        const auto [scene, tree] = trace(file);
        const Glb glb(gltfBinary(tree, scene));
        EXPECT_EQ(glb.named("[").size(), tree.nodes.size()) << file;
        for (const auto& ray : tree.nodes)
        {
            const Json extras = glb.node(nameOf(ray))["extras"];
            EXPECT_EQ(extras["id"], ray.id);
            EXPECT_EQ(extras["parent"], ray.parent);
            EXPECT_EQ(extras["kind"], name(ray.kind));
            EXPECT_EQ(extras["depth"], ray.depth);
            EXPECT_EQ(extras["weight"], ray.weight);
            EXPECT_EQ(extras["tir"], ray.tir);
            EXPECT_EQ(extras["line"], ray.line);
            expectSame(extras, "origin", ray.origin);
            expectSame(extras, "direction", ray.direction);
            expectSame(extras, "throughput", ray.throughput);
            expectSame(extras, "radiance", ray.radiance);
            expectSame(extras, "own", ray.own);
            expectSame(extras, "contribution", ray.contribution);
            EXPECT_EQ(extras.contains("end"), ray.end != End::none);
            if (ray.end != End::none)
            {
                EXPECT_EQ(extras["end"], name(ray.end));
            }
            EXPECT_EQ(extras.contains("n1"), ray.n1.has_value());
            if (ray.n1)
            {
                EXPECT_EQ(extras["n1"], *ray.n1);
            }
            if (ray.n2)
            {
                EXPECT_EQ(extras["n2"], *ray.n2);
            }
            if (ray.fresnel)
            {
                EXPECT_EQ(extras["fresnel"], *ray.fresnel);
            }
            ASSERT_EQ(extras.contains("hit"), ray.hit.has_value());
            if (!ray.hit) continue;
            EXPECT_EQ(extras["hit"]["t"], ray.hit->t);
            EXPECT_EQ(extras["hit"]["primitive"], ray.hit->primitive);
            EXPECT_EQ(extras["hit"]["material"], ray.hit->material);
            EXPECT_EQ(extras["hit"]["inside"], ray.hit->inside);
            expectSame(extras["hit"], "point", ray.hit->point);
            expectSame(extras["hit"], "normal", ray.hit->normal);
            expectSame(extras["hit"], "color", ray.hit->color);
        }
    }
}

TEST(Gltf, NestsTheRaysAsTheTreeDoes)
{
    const auto [scene, tree] = trace(glass);
    const Glb glb(gltfBinary(tree, scene));
    ASSERT_GT(tree.nodes.size(), 10U);
    for (const auto& ray : tree.nodes)
    {
        const auto parent = ray.parent < 0 ? "rays" : nameOf(tree.nodes[std::size_t(ray.parent)]);
        bool found = false;
        for (const auto& child : glb.node(parent)["children"])
            found = found || glb.json["nodes"][child.get<std::size_t>()]["name"] == nameOf(ray);
        EXPECT_TRUE(found) << nameOf(ray) << " is not below " << parent;
    }
}

TEST(Gltf, NestsDeepTreesOnlySoFarAndLosesNoRay)
{
    const auto tree = chain(1200);
    const Glb glb(gltfBinary(tree, {}));
    int levels = 0;
    std::size_t reached = 0;
    for (const auto& root : glb.json["scenes"][0]["nodes"]) reached += below(glb.json, root, &levels).size();
    EXPECT_EQ(reached, glb.json["nodes"].size());
    EXPECT_EQ(glb.named("[").size(), tree.nodes.size());
    EXPECT_LE(levels, 110);
    EXPECT_GE(levels, 100);
}

TEST(Gltf, DrawsEachRayFromItsOriginToItsHitPoint)
{
    for (const auto& file : files)
    {
        const auto [scene, tree] = trace(file);
        const Extent objects = objectExtent(scene);
        const Glb glb(gltfBinary(tree, scene));
        for (const auto& ray : tree.nodes)
        {
            const Json node = glb.node(nameOf(ray));
            EXPECT_FALSE(node.contains("translation") || node.contains("scale") || node.contains("matrix"));
            if (ray.weight == 0) continue;
            const auto points = glb.pointsOf(node);
            ASSERT_FALSE(points.empty()) << nameOf(ray);
            double first = infinity<double>, last = -infinity<double>, widest = 0, largest = 0;
            for (const auto& p : points)
            {
                const vec3 offset = p - ray.origin;
                const double along = dot(offset, ray.direction);
                first = std::min(first, along);
                last = std::max(last, along);
                widest = std::max(widest, length(offset - along * ray.direction));
                largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
            }
            // Three coordinates, each rounded to float.
            const double rounding = 3 * largest * std::numeric_limits<float>::epsilon();
            EXPECT_NEAR(first, 0, rounding) << file << nameOf(ray);
            if (ray.hit)
                EXPECT_NEAR(last, ray.hit->t, rounding) << file << nameOf(ray);
            else
                EXPECT_GT(last, objects.radius * 0.5);
            EXPECT_LT(widest, 0.05 * objects.radius);
        }
    }
}

TEST(Gltf, HasEachShadowRayBelowTheRayThatAsksForTheLight)
{
    const auto [scene, tree] = trace(glass);
    const Glb glb(gltfBinary(tree, scene));
    ASSERT_GT(tree.shadows.size(), 4U);
    bool blocked = false, visible = false;
    for (const auto& shadow : tree.shadows)
    {
        const auto title = "light " + std::to_string(shadow.light) + " from [" + std::to_string(shadow.node) + "]";
        bool found = false;
        for (const auto& child : glb.node(nameOf(tree.nodes[std::size_t(shadow.node)]))["children"])
        {
            const Json node = glb.json["nodes"][child.get<std::size_t>()];
            if (node["name"] != title) continue;
            found = true;
            const Json extras = node["extras"];
            EXPECT_EQ(extras["node"], shadow.node);
            EXPECT_EQ(extras["light"], shadow.light);
            EXPECT_EQ(extras["visible"], shadow.visible);
            EXPECT_EQ(extras["distance"], shadow.distance);
            expectSame(extras, "direction", shadow.direction);
            ASSERT_EQ(extras.contains("blocker"), shadow.blocker.has_value());
            if (shadow.blocker)
            {
                EXPECT_EQ(extras["blocker"]["primitive"], shadow.blocker->primitive);
                expectSame(extras["blocker"], "point", shadow.blocker->point);
            }
            const auto material =
                glb.json["materials"][glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0]["material"]
                                          .get<std::size_t>()]["name"];
            EXPECT_EQ(material, shadow.visible ? "shadow ray, visible" : "shadow ray, blocked");
            (shadow.visible ? visible : blocked) = true;
        }
        EXPECT_TRUE(found) << title;
    }
    EXPECT_TRUE(visible && blocked) << "the scene no longer shows both";
}

TEST(Gltf, SaysWhichRaysWereNotFollowed)
{
    auto [scene, ignored] = trace(glass);
    scene.trace.maxDepth = 1;
    const auto tree = smallestLesson(scene)->inspect(scene, Precision::doubled, scene.pixel());
    ASSERT_FALSE(tree.capped.empty());
    const Glb glb(gltfBinary(tree, scene));
    const auto found = glb.named("not followed: ");
    ASSERT_EQ(found.size(), tree.capped.size());
    EXPECT_EQ(found[0]["extras"]["reason"], name(tree.capped[0].reason));
    EXPECT_EQ(found[0]["extras"]["weight"], tree.capped[0].weight);
    EXPECT_TRUE(found[0].contains("mesh"));
}

TEST(Gltf, KnowsTheBoundsOfItsPositions)
{
    for (const auto& file : files)
    {
        const auto [scene, tree] = trace(file);
        const Glb glb(gltfBinary(tree, scene));
        for (const auto& mesh : glb.json["meshes"])
            for (const auto& primitive : mesh["primitives"])
            {
                const int accessor = primitive["attributes"]["POSITION"];
                vec3 low(infinity<double>), high(-infinity<double>);
                for (const auto& p : glb.points(accessor))
                {
                    low = min(low, p);
                    high = max(high, p);
                }
                const auto& stated = glb.json["accessors"][std::size_t(accessor)];
                EXPECT_EQ(stated["min"], Json({low.x, low.y, low.z}));
                EXPECT_EQ(stated["max"], Json({high.x, high.y, high.z}));
            }
    }
}

TEST(Gltf, KeepsItsBufferViewsAlignedAndInside)
{
    const auto [scene, tree] = trace(glass);
    const Glb glb(gltfBinary(tree, scene));
    std::size_t end = 0;
    for (const auto& view : glb.json["bufferViews"])
    {
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
        EXPECT_GE(view["byteOffset"].get<std::size_t>(), end) << "views overlap";
        end = view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>();
    }
    EXPECT_GT(end, 0U);
    EXPECT_LE(end, glb.buffer.size());
}

TEST(Gltf, TurnsEveryTriangleOutwards)
{
    for (const auto& file : files)
    {
        const auto [scene, tree] = trace(file);
        const Glb glb(gltfBinary(tree, scene));
        for (const auto& mesh : glb.json["meshes"])
            for (const auto& primitive : mesh["primitives"])
            {
                const auto points = glb.points(primitive["attributes"]["POSITION"]);
                const auto normals = glb.points(primitive["attributes"]["NORMAL"]);
                const auto indices = glb.indices(primitive["indices"]);
                ASSERT_EQ(points.size(), normals.size());
                for (std::size_t i = 0; i < indices.size(); i += 3)
                {
                    const auto a = indices[i], b = indices[i + 1], c = indices[i + 2];
                    ASSERT_LT(std::max({a, b, c}), points.size());
                    const vec3 ab = points[b] - points[a], ac = points[c] - points[a], N = cross(ab, ac);
                    // Slivers at the tips of cones and the poles of balls have no reliable normal in float.
                    if (length(N) < 1e-3 * dot(ab, ab) || length(N) < 1e-3 * dot(ac, ac)) continue;
                    EXPECT_GT(dot(N, normals[a] + normals[b] + normals[c]), 0) << file << " " << mesh["name"];
                }
            }
    }
}

TEST(Gltf, GivesObjectsTheNamesThatHitsUse)
{
    for (const auto& file : files)
    {
        const auto [scene, tree] = trace(file);
        const Glb glb(gltfBinary(tree, scene));
        for (const auto& ray : tree.nodes)
            if (ray.hit && ray.hit->primitive.rfind("mesh", 0) != 0)
            {
                EXPECT_EQ(glb.node(ray.hit->primitive)["extras"]["material"], ray.hit->material) << file;
            }
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        {
            const auto& sphere = scene.spheres[i];
            const Json node = glb.node("sphere" + std::to_string(i));
            expectSame(node, "translation", sphere.center);
            expectSame(node, "scale", vec3(sphere.radius));
            expectSame(node["extras"], "center", sphere.center);
            EXPECT_EQ(node["extras"]["radius"], sphere.radius);
        }
        for (std::size_t i = 0; i < scene.planes.size(); ++i)
        {
            const Json& extras = glb.node("plane" + std::to_string(i))["extras"];
            expectSame(extras, "point", scene.planes[i].point);
            expectSame(extras, "normal", scene.planes[i].normal);
        }
    }
}

TEST(Gltf, SharesOneBallAmongAllSpheres)
{
    const auto [scene, tree] = trace(glass);
    ASSERT_GE(scene.spheres.size(), 3U);
    const Glb glb(gltfBinary(tree, scene));
    std::set<int> positions;
    for (const auto& node : glb.named("sphere"))
        positions.insert(
            glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0]["attributes"]["POSITION"].get<int>());
    EXPECT_EQ(positions.size(), 1U);
    for (const auto& p : glb.points(*positions.begin())) EXPECT_NEAR(length(p), 1, 1e-6);
}

TEST(Gltf, PaintsRaysInThePalettesColours)
{
    const auto [scene, tree] = trace(glass);
    const Glb glb(gltfBinary(tree, scene));
    const auto colorOfNode = [&](const std::string& name) {
        const auto& mesh = glb.json["meshes"][glb.node(name)["mesh"].get<std::size_t>()];
        const auto& material = glb.json["materials"][mesh["primitives"][0]["material"].get<std::size_t>()];
        EXPECT_TRUE(material["extensions"].contains("KHR_materials_unlit")) << "the same in any light";
        const auto c = material["pbrMetallicRoughness"]["baseColorFactor"].get<std::array<double, 4>>();
        return Rgba{toSrgb8(c[0]), toSrgb8(c[1]), toSrgb8(c[2])};
    };
    std::set<RayKind> seen;
    for (const auto& ray : tree.nodes)
    {
        const auto role = ray.kind == RayKind::camera      ? RayRole::camera
                          : ray.kind == RayKind::reflected ? RayRole::reflected
                                                           : RayRole::transmitted;
        EXPECT_EQ(colorOfNode(nameOf(ray)), colorOf(role)) << nameOf(ray);
        seen.insert(ray.kind);
    }
    EXPECT_EQ(seen.size(), 3U);
}

TEST(Gltf, MakesGlassClearAndMirrorsMetallic)
{
    for (const auto& file : files)
    {
        const auto [scene, tree] = trace(file);
        const Glb glb(gltfBinary(tree, scene));
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        {
            const auto& mat = scene.materials[std::size_t(scene.spheres[i].material)];
            const auto& mesh = glb.json["meshes"][glb.node("sphere" + std::to_string(i))["mesh"].get<std::size_t>()];
            const auto& made = glb.json["materials"][mesh["primitives"][0]["material"].get<std::size_t>()];
            const auto& look = made["pbrMetallicRoughness"];
            EXPECT_EQ(made["name"], mat.name);
            EXPECT_EQ(made["extras"]["mirror"], mat.mirror);
            EXPECT_EQ(made["extras"]["ior"], mat.ior);
            EXPECT_EQ(made.contains("alphaMode"), mat.isDielectric());
            EXPECT_EQ(look["baseColorFactor"][3] < 0.5, mat.isDielectric());
            EXPECT_EQ(look["metallicFactor"] > 0.0, mat.mirror > 0 && !mat.isDielectric());
            if (mat.isDielectric() && mat.ior > mat.iorOutside)
            {
                EXPECT_EQ(made["extensions"]["KHR_materials_ior"]["ior"], mat.ior / mat.iorOutside);
            }
            for (int c = 0; c < 3; ++c) EXPECT_EQ(look["baseColorFactor"][std::size_t(c)], mat.color[c]);
        }
    }
}

TEST(Gltf, ShowsMeshesManyTrianglesAndTheNearPartOfHugeSpheres)
{
    SceneDescription scene;
    scene.camera = {.eye = {0, 1, 6}, .target = {0, 1, 0}};
    scene.materials.resize(1);
    scene.materials[0].name = "stone";
    scene.spheres = {{{0, -1000, 0}, 1000, 0}};
    const std::array<vec3, 3> corners{vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0)};
    scene.meshes.resize(1);
    scene.meshes[0].file = "stone.obj";
    scene.meshes[0].triangles = std::make_shared<const std::vector<std::array<vec3, 3>>>(2, corners);
    scene.triangles.assign(2, {corners, 0});
    {
        const Glb glb(gltfBinary({}, scene));
        const auto points = glb.pointsOf(glb.node("mesh0"));
        ASSERT_EQ(points.size(), 6U);
        EXPECT_EQ(points[4], corners[1]);
        EXPECT_EQ(glb.node("mesh0")["extras"]["file"], "stone.obj");
        EXPECT_EQ(glb.pointsOf(glb.node("triangle1")).size(), 3U);
        const Json& floor = glb.node("sphere0");
        EXPECT_FALSE(floor.contains("scale"));
        for (const auto& p : glb.pointsOf(floor)) EXPECT_LT(length(p), 60) << "far from all there is to see";
        const auto& made = glb.json["meshes"][floor["mesh"].get<std::size_t>()]["primitives"][0];
        const auto colors = glb.values<unsigned char>(made["attributes"]["COLOR_0"]);
        EXPECT_EQ(colors[3], 0) << "its rim is faded";
        EXPECT_EQ(colors[colors.size() / 2 / 4 * 4 + 3], 255) << "its middle is not";
    }
    scene.triangles.assign(501, {corners, 0});
    const Glb glb(gltfBinary({}, scene));
    EXPECT_TRUE(glb.named("triangle5").empty());
    EXPECT_EQ(glb.pointsOf(glb.node("triangles of stone")).size(), 3U * 501);
}

TEST(Gltf, StaysSmall)
{
    const auto [scene, tree] = trace(glass);
    ASSERT_GT(tree.nodes.size(), 10U);
    EXPECT_LT(gltfBinary(tree, scene).size(), 600'000U);
}

TEST(Gltf, LooksThroughTheScenesCamera)
{
    const auto [scene, tree] = trace(glass);
    const Glb glb(gltfBinary(tree, scene));
    const Json node = glb.node("camera"), lens = glb.json["cameras"][0]["perspective"];
    expectSame(node, "translation", scene.camera.eye);
    const auto q = node["rotation"].get<std::array<double, 4>>();
    const auto turned = [&](const vec3& v) {
        const vec3 axis(q[0], q[1], q[2]);
        return v + 2.0 * cross(axis, cross(axis, v) + q[3] * v);
    };
    // The corner of the picture: x to the right, y up, as the camera of glTF has them.
    const double h = std::tan(lens["yfov"].get<double>() / 2), w = h * lens["aspectRatio"].get<double>();
    const vec3 corner = unit(turned({w, h, -1}));
    const vec3 expected = Camera<double>(scene.camera).ray(scene.camera.width, 0).D;
    EXPECT_LT(length(corner - expected), 1e-14);
}

TEST(Gltf, LightsAreAsBrightAsTheLectures)
{
    const auto [scene, tree] = trace(glass);
    const Glb glb(gltfBinary(tree, scene));
    const auto& lamps = glb.json["extensions"]["KHR_lights_punctual"]["lights"];
    ASSERT_EQ(lamps.size(), scene.lights.size());
    for (std::size_t i = 0; i < lamps.size(); ++i)
    {
        expectSame(glb.node("light " + std::to_string(i)), "translation", scene.lights[i].position);
        const auto color = lamps[i]["color"].get<std::array<double, 3>>();
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(color[c] * lamps[i]["intensity"].get<double>() / std::numbers::pi,
                        scene.lights[i].color[int(c)], 1e-12 * largestChannel(scene.lights[i].color));
    }
}

TEST(Gltf, PlanesHaveTheirCheckers)
{
    const auto [scene, tree] = trace(glass);
    const Scene<double> derived(scene);
    const Glb glb(gltfBinary(tree, scene));
    int checked = 0;
    for (std::size_t i = 0; i < scene.planes.size(); ++i)
    {
        if (!scene.planes[i].hasChecker) continue;
        const Json node = glb.node("plane" + std::to_string(i));
        const Json primitive = glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
        const auto points = glb.points(primitive["attributes"]["POSITION"]);
        const auto uv = glb.values<float>(primitive["attributes"]["TEXCOORD_0"]);
        const auto indices = glb.indices(primitive["indices"]);
        for (std::size_t k = 0; k < indices.size(); k += 3)
            for (double s = 0.02; s < 1; s += 0.07)
                for (double t = 0.013; s + t < 1; t += 0.05)
                {
                    vec3 point(0);
                    double u = 0, v = 0;
                    const double share[] = {1 - s - t, s, t};
                    for (std::size_t c = 0; c < 3; ++c)
                    {
                        point += share[c] * points[indices[k + c]];
                        u += share[c] * double(uv[2 * indices[k + c]]);
                        v += share[c] * double(uv[2 * indices[k + c] + 1]);
                    }
                    const auto edge = [](double x) { return std::abs(2 * x - std::round(2 * x)) < 1e-4; };
                    if (edge(u) || edge(v)) continue;
                    const bool even = (std::floor(2 * u) + std::floor(2 * v)) / 2 ==
                                      std::floor((std::floor(2 * u) + std::floor(2 * v)) / 2);
                    EXPECT_EQ(even, derived.planes[i].materialAt(point) == derived.planes[i].material);
                    ++checked;
                }
    }
    EXPECT_GT(checked, 200);
}

TEST(Gltf, PaintsTheFirstCellInTheMaterialsColour)
{
    const auto [scene, tree] = trace(glass);
    ASSERT_TRUE(scene.planes[0].hasChecker);
    const Glb glb(gltfBinary(tree, scene));
    const auto& view = glb.json["bufferViews"][glb.json["images"][0]["bufferView"].get<std::size_t>()];
    Image expected(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            expected.at(x, y) = (x < 32) == (y < 32) ? scene.materials[std::size_t(scene.planes[0].material)].color
                                                     : scene.planes[0].checkerColor;
    EXPECT_TRUE(glb.buffer.substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>()) ==
                pngBytes(expected));
}

TEST(Gltf, LeavesOutWhatIsNotFinite)
{
    auto [scene, tree] = trace(glass);
    tree.nodes[1].weight = nan;
    tree.nodes[1].radiance.y = infinity<double>;
    tree.nodes[2].origin.x = nan;
    tree.nodes[3].throughput.x = nan;
    tree.nodes[0].hit->t = -infinity<double>;
    const Glb glb(gltfBinary(tree, scene));
    const Json second = glb.node(nameOf(tree.nodes[1]));
    EXPECT_FALSE(second["extras"].contains("weight"));
    EXPECT_FALSE(second["extras"].contains("radiance"));
    EXPECT_TRUE(second["extras"].contains("throughput"));
    EXPECT_TRUE(second.contains("mesh"));
    EXPECT_FALSE(glb.node(nameOf(tree.nodes[2])).contains("mesh")) << "it has no place";
    EXPECT_TRUE(glb.node(nameOf(tree.nodes[3])).contains("mesh")) << "its place is known";
    EXPECT_FALSE(glb.node(nameOf(tree.nodes[0]))["extras"]["hit"].contains("t"));
    EXPECT_EQ(glb.json.dump().find("null"), std::string::npos);
}

TEST(Gltf, TextHoldsTheSameAsBinary)
{
    const auto [scene, tree] = trace(glass);
    const Glb glb(gltfBinary(tree, scene));
    Json text = Json::parse(gltfText(tree, scene));
    EXPECT_EQ(text["buffers"][0]["uri"], "data:application/octet-stream;base64," + base64(glb.buffer));
    text["buffers"][0].erase("uri");
    EXPECT_EQ(text, glb.json);
}

TEST(Gltf, ReplacesNamesThatAreNotUtf8)
{
    auto [scene, tree] = trace(glass);
    tree.nodes[0].hit->primitive = "\"\xff\n";
    const Glb glb(gltfBinary(tree, scene));
    EXPECT_EQ(glb.node(nameOf(tree.nodes[0]))["extras"]["hit"]["primitive"], "\"\xef\xbf\xbd\n");
}

TEST(Gltf, OfNothingIsStillAScene)
{
    const Glb glb(gltfBinary({}, {}));
    EXPECT_TRUE(glb.named("[").empty());
    EXPECT_EQ(glb.json["scenes"].size(), 1U);
    EXPECT_TRUE(glb.node("camera").contains("camera"));
}

TEST(Base64, IsThatOfRfc4648)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xfb\xff\xfe"), "+//+");
}

// ParaView's, read by VTK's own reader.

struct Lines
{
    vtkNew<vtkXMLPolyDataReader> reader;
    vtkPolyData* data = nullptr;

    explicit Lines(const std::string& text)
    {
        reader->ReadFromInputStringOn();
        reader->SetInputString(text);
        reader->Update();
        EXPECT_EQ(reader->GetErrorCode(), 0U);
        data = reader->GetOutput();
    }

    double number(const char* name, int cell, int component = 0) const
    {
        auto* array = data->GetCellData()->GetArray(name);
        if (!array || array->GetNumberOfTuples() != data->GetNumberOfCells())
        {
            ADD_FAILURE() << "no array " << name << ", or not as long as there are cells";
            return nan;
        }
        return array->GetComponent(cell, component);
    }

    vec3 triple(const char* name, int cell) const
    {
        return {number(name, cell, 0), number(name, cell, 1), number(name, cell, 2)};
    }

    std::string text(const char* name, int cell) const
    {
        auto* array = vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray(name));
        if (!array || array->GetNumberOfValues() != data->GetNumberOfCells())
        {
            ADD_FAILURE() << "no text array " << name << ", or not as long as there are cells";
            return {};
        }
        return array->GetValue(cell);
    }

    vec3 end(int cell, int which) const
    {
        vtkNew<vtkIdList> ids;
        data->GetCellPoints(cell, ids);
        EXPECT_EQ(ids->GetNumberOfIds(), 2);
        double p[3];
        data->GetPoint(ids->GetId(which), p);
        return {p[0], p[1], p[2]};
    }
};

/// Same bits, or both no number.
void expectSame(double a, double b)
{
    if (std::isnan(a))
        EXPECT_TRUE(std::isnan(b));
    else
        EXPECT_EQ(a, b);
}

TEST(Vtp, HasALineForEachRayWithItsNumbers)
{
    for (const auto& file : files)
    {
        const auto [scene, tree] = trace(file);
        const Lines lines(vtpText(tree, scene));
        ASSERT_EQ(lines.data->GetNumberOfCells(), vtkIdType(tree.nodes.size() + tree.shadows.size())) << file;
        for (const auto& ray : tree.nodes)
        {
            const int cell = ray.id;
            EXPECT_EQ(lines.number("id", cell), ray.id);
            EXPECT_EQ(lines.number("parent", cell), ray.parent);
            EXPECT_EQ(lines.number("kind", cell), int(ray.kind));
            EXPECT_EQ(lines.text("kind_name", cell), name(ray.kind));
            EXPECT_EQ(lines.number("depth", cell), ray.depth);
            EXPECT_EQ(lines.number("weight", cell), ray.weight);
            EXPECT_EQ(lines.triple("throughput", cell), ray.throughput);
            EXPECT_EQ(lines.triple("radiance", cell), ray.radiance);
            EXPECT_EQ(lines.triple("own", cell), ray.own);
            EXPECT_EQ(lines.triple("contribution", cell), ray.contribution);
            EXPECT_EQ(lines.text("end", cell), name(ray.end));
            EXPECT_EQ(lines.number("tir", cell), int(ray.tir));
            EXPECT_EQ(lines.number("line", cell), ray.line);
            EXPECT_EQ(lines.number("visible", cell), -1);
            expectSame(lines.number("n1", cell), ray.n1.value_or(nan));
            expectSame(lines.number("n2", cell), ray.n2.value_or(nan));
            expectSame(lines.number("fresnel", cell), ray.fresnel.value_or(nan));
            expectSame(lines.number("t", cell), ray.hit ? ray.hit->t : nan);
            EXPECT_EQ(lines.text("primitive", cell), ray.hit ? ray.hit->primitive : "");
            EXPECT_EQ(lines.text("material", cell), ray.hit ? ray.hit->material : "");
            EXPECT_EQ(lines.number("inside", cell), int(ray.hit && ray.hit->inside));
            EXPECT_EQ(lines.end(cell, 0), ray.origin);
            if (ray.hit)
            {
                EXPECT_EQ(lines.end(cell, 1), ray.hit->point);
            }
        }
    }
}

TEST(Vtp, EndsRaysThatMeetNothingBehindTheScene)
{
    const auto [scene, traced] = trace(glass);
    RayTree tree;
    tree.nodes.emplace_back();
    tree.nodes[0].origin = scene.camera.eye;
    tree.nodes[0].direction = unit(scene.camera.target - scene.camera.eye);
    tree.nodes[0].weight = 0;
    const Lines lines(vtpText(tree, scene));
    ASSERT_EQ(lines.data->GetNumberOfCells(), 1) << "of no weight, but a ray";
    const vec3 way = lines.end(0, 1) - tree.nodes[0].origin;
    EXPECT_TRUE(isFinite(way));
    EXPECT_NEAR(dot(unit(way), tree.nodes[0].direction), 1, 1e-15);
    EXPECT_GT(length(way), length(scene.camera.target - scene.camera.eye));
}

TEST(Vtp, HasALineForEachShadowRay)
{
    const auto [scene, tree] = trace(glass);
    const Lines lines(vtpText(tree, scene));
    const int first = int(tree.nodes.size());
    bool blocked = false;
    for (int i = 0; i < int(tree.shadows.size()); ++i)
    {
        const auto& shadow = tree.shadows[std::size_t(i)];
        const int cell = first + i;
        EXPECT_EQ(lines.number("id", cell), -1);
        EXPECT_EQ(lines.number("shadow", cell), i);
        EXPECT_EQ(lines.number("parent", cell), shadow.node);
        EXPECT_EQ(lines.number("kind", cell), 3);
        EXPECT_EQ(lines.text("kind_name", cell), "shadow");
        EXPECT_EQ(lines.number("light", cell), shadow.light);
        EXPECT_EQ(lines.number("visible", cell), int(shadow.visible));
        EXPECT_EQ(lines.number("distance", cell), shadow.distance);
        EXPECT_EQ(lines.triple("tint", cell), shadow.tint);
        EXPECT_TRUE(std::isnan(lines.number("weight", cell)));
        EXPECT_EQ(lines.text("primitive", cell), shadow.blocker ? shadow.blocker->primitive : "");
        const vec3 I = tree.nodes[std::size_t(shadow.node)].hit->point;
        EXPECT_EQ(lines.end(cell, 0), I);
        if (!shadow.blocker)
        {
            EXPECT_EQ(lines.end(cell, 1), I + shadow.distance * shadow.direction);
        }
        if (!shadow.blocker) continue;
        blocked = true;
        EXPECT_EQ(lines.end(cell, 1), shadow.blocker->point);
    }
    EXPECT_TRUE(blocked) << "the scene no longer shows one";
}

TEST(Vtp, LeavesOutLinesThatHaveNoPlaceAndKeepsNumbersThatAreNone)
{
    auto [scene, tree] = trace(glass);
    const auto all = tree.nodes.size() + tree.shadows.size();
    tree.shadows.clear();
    ASSERT_GT(all, 4U);
    tree.nodes[1].origin.x = nan;
    tree.nodes[2].weight = nan;
    tree.nodes[2].radiance.y = infinity<double>;
    const Lines lines(vtpText(tree, scene));
    ASSERT_EQ(lines.data->GetNumberOfCells(), vtkIdType(tree.nodes.size()) - 1);
    EXPECT_EQ(lines.number("id", 0), 0);
    EXPECT_EQ(lines.number("id", 1), 2);
    EXPECT_TRUE(std::isnan(lines.number("weight", 1)));
    EXPECT_EQ(lines.number("radiance", 1, 1), infinity<double>);
}

TEST(Vtp, KeepsNamesThatAreNotXml)
{
    auto [scene, tree] = trace(glass);
    tree.nodes[0].hit->primitive = "</DataArray>\"&\xff\n\xe2\x82\x81";
    tree.nodes[0].hit->material = std::string("before\0after", 12);
    const Lines lines(vtpText(tree, scene));
    EXPECT_EQ(lines.text("primitive", 0), tree.nodes[0].hit->primitive);
    EXPECT_EQ(lines.text("material", 0), "before") << "a zero ends a string there";
    EXPECT_EQ(lines.text("primitive", 1), tree.nodes[1].hit->primitive);
}

TEST(Vtp, OfNothingIsAnEmptyDataSet)
{
    const Lines lines(vtpText({}, {}));
    EXPECT_EQ(lines.data->GetNumberOfCells(), 0);
    EXPECT_EQ(lines.data->GetNumberOfPoints(), 0);
}

} // namespace

} // namespace rt::viz
