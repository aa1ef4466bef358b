// A mesh is its triangles: whatever shows a scene shows both alike.
#include <gtest/gtest.h>

#include "lessons/programs/registry.h"
#include "viz/drawing/object_meshes.h"
#include "viz/drawing/rays.h"
#include "viz/drawing/view.h"

namespace rt::viz
{

namespace
{

/// A box of twelve triangles above the origin, and a lamp; as triangles of the scene, or as a mesh.
SceneDescription boxScene(bool asMesh)
{
    SceneDescription scene;
    scene.materials = {{.name = "red", .color = {0.8, 0.3, 0.2}}};
    scene.camera.eye = {4, 3, 6};
    scene.camera.target = {0, 0, 0};
    scene.lights = {{{3, 6, 5}, {60, 60, 60}}};
    std::vector<std::array<vec3, 3>> triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
        {
            vec3 N(0), U(0), V(0);
            N[axis] = side, U[(axis + 1) % 3] = side, V[(axis + 2) % 3] = 1;
            triangles.push_back({N - U - V, N + U - V, N + U + V});
            triangles.push_back({N - U - V, N + U + V, N - U + V});
        }
    if (asMesh)
        scene.meshes = {{"box.obj", std::make_shared<const std::vector<std::array<vec3, 3>>>(triangles), 0}};
    else
        for (const auto& corners : triangles) scene.triangles.push_back({corners, 0});
    return scene;
}

const SceneDescription mesh = boxScene(true), loose = boxScene(false);

TEST(Meshes, AreDrawn)
{
    const auto drawn = objectMeshes(mesh, objectExtent(mesh)), expected = objectMeshes(loose, objectExtent(loose));
    ASSERT_EQ(expected.matte.triangles.size(), 12U);
    EXPECT_EQ(drawn.matte.points, expected.matte.points);
    EXPECT_EQ(drawn.matte.triangles, expected.matte.triangles);
}

TEST(Meshes, CountForTheSizeOfTheScene)
{
    EXPECT_EQ(objectExtent(mesh).centre, objectExtent(loose).centre);
    EXPECT_EQ(objectExtent(mesh).radius, objectExtent(loose).radius);
    EXPECT_DOUBLE_EQ(sizeOf(mesh, "mesh0.triangle7").value(), std::sqrt(3.0));
    EXPECT_FALSE(sizeOf(mesh, "mesh1.triangle0"));
}

/// From where rays between two walls are best seen, of which the one at x = `side` is opaque, and a mesh.
vec3 directionPast(double side)
{
    SceneDescription scene = boxScene(false);
    scene.materials.push_back({.name = "glass", .ior = 1.5});
    const auto wallAt = [](double x) {
        return std::vector<std::array<vec3, 3>>{{vec3(x, -9, -9), vec3(x, 9, -9), vec3(x, 9, 9)},
                                                {vec3(x, -9, -9), vec3(x, 9, 9), vec3(x, -9, 9)}};
    };
    for (const double x : {-2.0, 2.0})
        scene.meshes.push_back(
            {"wall.obj", std::make_shared<const std::vector<std::array<vec3, 3>>>(wallAt(x)), x == side ? 0 : 1});
    scene.camera.eye = {0, 0, 6};
    const auto tree =
        findLesson(1)->inspect(scene, Precision::doubled, std::array{scene.camera.width / 2, scene.camera.height / 2});
    return bestDirection(drawRays(tree, scene, objectExtent(scene)), scene);
}

TEST(Meshes, HideWhatIsBehindThem)
{
    EXPECT_LT(directionPast(2).x, 0);
    EXPECT_GT(directionPast(-2).x, 0);
}

} // namespace

} // namespace rt::viz
