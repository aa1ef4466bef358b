#include "viz/drawing/rays.h"

#include <cmath>

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"
#include "lessons/programs/registry.h"
#include "viz/drawing/planes.h"
#include "viz/drawing/ray_mesh.h"

namespace rt::viz
{

namespace
{

struct Drawn
{
    SceneDescription scene;
    RayTree tree;
    Extent objects;
    RayDrawing drawing;

    Drawn(const SceneDescription& described, const RayTree& traced)
        : scene(described), tree(traced), objects(objectExtent(scene)), drawing(drawRays(tree, scene, objects))
    {
    }

    std::vector<Segment> of(RayRole role) const
    {
        std::vector<Segment> found;
        for (const auto& segment : drawing.segments)
            if (segment.role == role) found.push_back(segment);
        return found;
    }
};

Drawn draw(const std::string& file, const Probe& probe)
{
    const auto scene = loadScene(projectFile(file));
    return {scene, smallestLesson(scene)->inspect(scene, Precision::doubled, probe)};
}

const std::string diffuse = "lessons/01_direct_illumination/scenes/diffuse_spheres.toml";
const std::string mirrors = "lessons/02_mirrors/scenes/pure_specular.toml";
const std::string facing = "lessons/02_mirrors/scenes/facing_mirrors.toml";

TEST(Rays, EachRunsFromItsOriginToItsHitPoint)
{
    const auto drawn = draw(mirrors, std::array{360, 250});
    ASSERT_GE(drawn.tree.nodes.size(), 3U);
    std::size_t rays = 0;
    for (const auto role : {RayRole::camera, RayRole::reflected, RayRole::transmitted})
        for (const auto& segment : drawn.of(role))
        {
            const auto& node = drawn.tree.nodes[std::size_t(segment.node)];
            EXPECT_EQ(segment.from, node.origin);
            EXPECT_EQ(segment.to, node.hit->point);
            EXPECT_EQ(role == RayRole::camera, node.kind == RayKind::camera);
            EXPECT_TRUE(segment.hasHead && !segment.fades);
            ++rays;
        }
    EXPECT_EQ(rays, drawn.tree.nodes.size());
    EXPECT_EQ(drawn.drawing.nodes, int(drawn.tree.nodes.size()));
}

TEST(Rays, AChildStartsWhereItsParentEnds)
{
    const auto drawn = draw(facing, std::array{326, 213});
    const auto rays = drawn.of(RayRole::reflected);
    ASSERT_GE(rays.size(), 2U);
    for (std::size_t i = 1; i < rays.size(); ++i) EXPECT_LT(length(rays[i].from - rays[i - 1].to), 1e-12);
}

TEST(Rays, ABlockedShadowRayIsCutAtItsBlocker)
{
    const auto drawn = draw(diffuse, std::array{392, 345});
    ASSERT_EQ(drawn.of(RayRole::reaches).size(), 1U);
    ASSERT_EQ(drawn.of(RayRole::blocked).size(), 1U);
    ASSERT_EQ(drawn.of(RayRole::beyond).size(), 1U);
    ASSERT_EQ(drawn.drawing.blockers.size(), 1U);
    const auto solid = drawn.of(RayRole::blocked)[0], dashed = drawn.of(RayRole::beyond)[0];
    const auto& mark = drawn.drawing.blockers[0];
    EXPECT_EQ(solid.from, drawn.tree.nodes[0].hit->point);
    EXPECT_EQ(solid.to, mark.point);
    EXPECT_EQ(dashed.from, mark.point);
    EXPECT_LT(length(dashed.to - drawn.scene.lights[std::size_t(mark.light)].position), 1e-9);
    EXPECT_FALSE(solid.hasHead) << "its arrow would say that the light arrives";
    const auto reaching = drawn.of(RayRole::reaches)[0];
    EXPECT_LT(length(reaching.to - drawn.scene.lights[std::size_t(reaching.light)].position), 1e-9);
    EXPECT_TRUE(reaching.hasHead);
}

TEST(Rays, AMissHasAFiniteLengthAndFades)
{
    const auto drawn = draw(diffuse, std::array{0, 0});
    ASSERT_FALSE(drawn.tree.nodes[0].hit);
    ASSERT_EQ(drawn.drawing.segments.size(), 1U);
    const auto& ray = drawn.drawing.segments[0];
    EXPECT_TRUE(ray.fades);
    EXPECT_LT(ray.length(), 4 * (drawn.objects.radius + length(ray.from - drawn.objects.centre)));
    EXPECT_LT(length(unit(ray.to - ray.from) - drawn.tree.nodes[0].direction), 1e-12);
    EXPECT_FALSE(buildRayMesh(drawn.drawing, {}).fading.empty());
}

TEST(Rays, AHitFarAwayIsNotDrawnToItsEnd)
{
    auto drawn = draw(diffuse, std::array{392, 345});
    drawn.tree.nodes[0].hit->t = 1e7;
    drawn.tree.nodes[0].hit->point = drawn.tree.nodes[0].origin + 1e7 * drawn.tree.nodes[0].direction;
    const Drawn far(drawn.scene, drawn.tree);
    EXPECT_TRUE(far.of(RayRole::camera).at(0).fades);
    EXPECT_LT(far.of(RayRole::camera).at(0).length(), 100);
}

TEST(Rays, NormalsStandOnTheSideThatTheRayCameFrom)
{
    auto drawn = draw(facing, std::array{326, 213});
    ASSERT_GE(drawn.tree.nodes.size(), 2U);
    // As if the second surface were met from its inner side: its outward normal is the other one.
    auto& hit = *drawn.tree.nodes[1].hit;
    hit.inside = !hit.inside;
    hit.normal = -hit.normal;
    const Drawn turned(drawn.scene, drawn.tree);
    EXPECT_EQ(turned.of(RayRole::normal).size(), drawn.tree.nodes.size());
    for (const auto& normal : turned.of(RayRole::normal))
    {
        const auto& node = drawn.tree.nodes[std::size_t(normal.node)];
        EXPECT_EQ(normal.from, node.hit->point);
        EXPECT_LT(dot(normal.to - normal.from, node.direction), 0);
        EXPECT_LT(normal.length(), 0.5 * drawn.objects.radius);
    }
}

TEST(Rays, WhatTheCapForbadeIsHintedAt)
{
    auto scene = loadScene(projectFile(facing));
    scene.trace.maxDepth = 2;
    const Drawn drawn(scene, findLesson(2)->inspect(scene, Precision::doubled, scene.pixel()));
    ASSERT_EQ(drawn.tree.capped.size(), 1U);
    const auto isHint = [](const Segment& segment) { return segment.notTraced(); };
    ASSERT_EQ(std::count_if(drawn.drawing.segments.begin(), drawn.drawing.segments.end(), isHint), 1);
    EXPECT_EQ(drawn.of(RayRole::reflected).size(), 3U) << "two traced ones and the hint";
}

TEST(Rays, OrphansAreDrawnFromWhereTheyStart)
{
    auto drawn = draw(mirrors, std::array{360, 250});
    drawn.tree.nodes[1].parent = -1;
    drawn.tree.nodes[1].orphan = true;
    const Drawn orphaned(drawn.scene, drawn.tree);
    EXPECT_EQ(orphaned.drawing.segments.size(), drawn.drawing.segments.size());
}

TEST(Rays, WithoutWeightOrWithNumbersThatAreNotFiniteTheyAreLeftOut)
{
    auto drawn = draw(mirrors, std::array{360, 250});
    drawn.tree.nodes[1].weight = 0;
    drawn.tree.nodes[2].origin.x = std::nan("");
    const Drawn some(drawn.scene, drawn.tree);
    for (const auto& segment : some.of(RayRole::reflected)) ADD_FAILURE() << "node " << segment.node << " is drawn";
    EXPECT_EQ(some.of(RayRole::camera).size(), 1U);
}

TEST(Rays, OfAHugeTreeTheLeastDeepOnesAreDrawn)
{
    RayTree tree;
    for (int i = 0; i < 5000; ++i)
    {
        RayTree::Node node;
        node.id = i;
        node.parent = i == 0 ? -1 : (i - 1) / 2;
        node.depth = int(std::log2(i + 1));
        node.kind = i == 0 ? RayKind::camera : RayKind::reflected;
        node.direction = {0, 0, -1};
        tree.nodes.push_back(node);
    }
    const Drawn drawn({}, tree);
    EXPECT_EQ(drawn.drawing.nodes, 1023);
    for (const auto& segment : drawn.drawing.segments) EXPECT_LT(tree.nodes[std::size_t(segment.node)].depth, 10);
}

TEST(Rays, AnEmptyTreeInAnEmptySceneDrawsNothing)
{
    const Drawn drawn({}, {});
    EXPECT_TRUE(drawn.drawing.segments.empty());
    EXPECT_GT(drawn.objects.radius, 0);
    EXPECT_TRUE(buildRayMesh(drawn.drawing, {}).solid.empty());
}

TEST(Labels, NameTheLecturesLettersWithTheNodesNumber)
{
    EXPECT_EQ(labelOf({.role = RayRole::camera, .node = 0}), "D₀");
    EXPECT_EQ(labelOf({.role = RayRole::reflected, .node = 12}), "R₁₂");
    EXPECT_EQ(labelOf({.role = RayRole::transmitted, .node = 3}), "T₃");
    // Of a shadow ray: the lamp's number, not the ray's.
    EXPECT_EQ(labelOf({.role = RayRole::blocked, .node = 4, .light = 1}), "L₁");
    EXPECT_EQ(labelOf({.role = RayRole::reaches, .node = 4, .light = 0}), "L₀");
    EXPECT_EQ(labelOf({.role = RayRole::normal, .node = 5}), "N₅");
}

TEST(Extent, AFloorOrADomeThatIsAHugeSphereDoesNotCount)
{
    SceneDescription scene;
    scene.camera.eye = {0, 1, 6};
    scene.camera.target = {0, 1, 0};
    scene.spheres = {{{0, -1000, 0}, 1000, 0}, {{0, 1, 2}, 500, 0}, {{0, 1, 0}, 1, 0}};
    const Extent extent = objectExtent(scene);
    EXPECT_LT(extent.radius, 3);
    EXPECT_LT(length(extent.centre - vec3(0, 1, 0)), 1e-9);
}

TEST(ImagePlane, ItsPixelsLieOnTheirCameraRays)
{
    const auto scene = loadScene(projectFile(mirrors));
    const auto plane = imagePlane(scene.camera, objectExtent(scene));
    const Camera<double> camera(scene.camera);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {640.0, 480.0}, {100.5, 300.5}})
    {
        const vec3 direction = unit(plane.at(x / 640, y / 480) - scene.camera.eye);
        EXPECT_LT(length(direction - camera.ray(x, y).D), 1e-12);
    }
}

TEST(RayMesh, ArrowHeadsPointAlongTheRay)
{
    RayDrawing drawing;
    drawing.segments = {{.role = RayRole::camera, .from = {0, 0, 0}, .to = {0, 0, -5}}};
    const Mesh mesh = buildRayMesh(drawing, {}).solid;
    // The tip is the only point at the very end; the widest ring lies a little before it.
    double widest = 0, where = 0, furthest = 0;
    for (const auto& p : mesh.points)
    {
        furthest = std::min(furthest, p.z);
        if (const double r = std::hypot(p.x, p.y); r > widest)
        {
            widest = r;
            where = p.z;
        }
    }
    EXPECT_DOUBLE_EQ(furthest, -5);
    EXPECT_GT(widest, 2 * tubeRadius(drawing));
    EXPECT_LT(where, -4.5);
    EXPECT_GT(where, -5);
}

TEST(RayMesh, KindsDifferByMoreThanColour)
{
    std::vector<std::size_t> sizes;
    for (const auto role : {RayRole::camera, RayRole::reflected, RayRole::transmitted, RayRole::beyond})
    {
        RayDrawing drawing;
        drawing.segments = {{.role = role, .from = {0, 0, 0}, .to = {0, 0, -5}}};
        sizes.push_back(buildRayMesh(drawing, {}).solid.triangles.size());
    }
    for (std::size_t i = 0; i < sizes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(sizes[i], sizes[j]) << "the same shape: " << j << " and " << i;
}

TEST(RayMesh, TheSelectedRayGlows)
{
    const auto drawn = draw(mirrors, std::array{360, 250});
    EXPECT_TRUE(buildRayMesh(drawn.drawing, {}).glow.empty());
    EXPECT_FALSE(buildRayMesh(drawn.drawing, {.selected = 1}).glow.empty());
}

TEST(RayMesh, NormalsCanBeLeftOut)
{
    const auto drawn = draw(diffuse, std::array{392, 345});
    const auto with = buildRayMesh(drawn.drawing, {}), without = buildRayMesh(drawn.drawing, {.withNormals = false});
    EXPECT_GT(with.solid.points.size(), without.solid.points.size());
}

TEST(Mesh, TrianglesTurnTheirFrontOutwards)
{
    Mesh mesh;
    addSphere(mesh, {1, 2, 3}, 2, 24, {});
    addTube(mesh, {0, 0, 0}, {1, 2, -1}, 0.3, {}, {});
    addCone(mesh, {0, 0, 0}, {0, 3, 0}, 0.5, {});
    for (const auto& [a, b, c] : mesh.triangles)
    {
        const auto& p = mesh.points;
        const vec3 face = cross(p[std::size_t(b)] - p[std::size_t(a)], p[std::size_t(c)] - p[std::size_t(a)]);
        const vec3 shading = mesh.normals[std::size_t(a)] + mesh.normals[std::size_t(b)] + mesh.normals[std::size_t(c)];
        EXPECT_GE(dot(face, shading), -1e-12);
    }
    for (const auto& N : mesh.normals) EXPECT_NEAR(length(N), 1, 1e-9);
}

TEST(Planes, WallsOfARoomEndAtOneAnother)
{
    SceneDescription scene;
    scene.camera.eye = {0, 1, 3};
    scene.camera.target = {0, 1, 0};
    scene.materials.push_back({});
    scene.planes = {{{0, 0, 0}, {0, 1, 0}, 0}, {{0, 0, -2}, {0, 0, 1}, 0}, {{-2, 0, 0}, {-1, 0, 0}, 0}};
    const auto patches = planePatches(scene, {{0, 1, 0}, 4});
    ASSERT_EQ(patches.size(), 3U);
    for (const auto& patch : patches)
        for (const auto& [u, v] : patch.outline)
        {
            const vec3 corner = patch.at(u, v);
            EXPECT_GE(corner.y, -1e-9);
            EXPECT_GE(corner.z, -2 - 1e-9);
            EXPECT_GE(corner.x, -2 - 1e-9);
        }
    EXPECT_TRUE(patches[0].isFloor);
    EXPECT_FALSE(patches[1].isFloor);
    EXPECT_GT(dot(cross(patches[2].right, patches[2].forward), vec3(1, 0, 0)), 0) << "it faces the eye, not its normal";
}

TEST(Planes, ShowTheCheckerOfTheScene)
{
    SceneDescription scene;
    scene.materials.push_back({.name = "floor", .color = {0.8, 0.8, 0.8}});
    scene.camera.eye = {0, 1, 5};
    scene.planes = {
        {.point = {0, 0, 0}, .normal = {0, 1, 0}, .material = 0, .hasChecker = true, .checkerColor = {0.1, 0.1, 0.1}}};
    const auto patches = planePatches(scene, {{0, 0, 0}, 4});
    ASSERT_EQ(patches.size(), 1U);
    const int side = 240;
    const auto picture = paintPatch(patches[0], scene, side);
    const auto at = [&](double x, double z) {
        const auto& patch = patches[0];
        const vec3 d = vec3(x, 0, z) - patch.corner;
        const int i = int(dot(d, patch.right) / dot(patch.right, patch.right) * side);
        const int j = int(dot(d, patch.forward) / dot(patch.forward, patch.forward) * side);
        return picture.pixels[std::size_t(j * side + i)];
    };
    EXPECT_GT(at(0.5, 0.5).r, 2 * at(1.5, 0.5).r);
    EXPECT_EQ(at(0.5, 0.5), at(1.5, 1.5));
    EXPECT_EQ(at(-0.5, 0.5), at(1.5, 0.5));
    EXPECT_EQ(picture.pixels[0].a, 0) << "a patch fades out towards its corners";
}

TEST(Planes, ShowTheShadowsOfTheScene)
{
    SceneDescription scene;
    scene.materials.push_back({.name = "grey", .color = {0.8, 0.8, 0.8}});
    scene.camera.eye = {0, 1, 5};
    scene.planes = {{{0, 0, 0}, {0, 1, 0}, 0}};
    scene.spheres = {{{0, 1, 0}, 0.5, 0}};
    scene.lights = {{{0, 4, 0}, {10, 10, 10}}};
    const auto patch = planePatches(scene, {{0, 0, 0}, 4}).at(0);
    const auto picture = paintPatch(patch, scene, 101);
    const auto middle = picture.pixels[50 * 101 + 50], beside = picture.pixels[50 * 101 + 62];
    EXPECT_LT(middle.r * 2, beside.r);
}

} // namespace

} // namespace rt::viz
