// A scene in other units of length.
#pragma once

#include "common/scene/scene_description.h"

namespace rt
{

/// The scene times `factor`: lengths; light that falls off with the distance squared times its square. The picture is to
/// stay as it is, to the last bit if factor is a power of two.
inline SceneDescription scaled(SceneDescription scene, double factor)
{
    scene.camera.eye *= factor;
    scene.camera.target *= factor;
    for (auto& sphere : scene.spheres)
    {
        sphere.center *= factor;
        sphere.radius *= factor;
    }
    for (auto& plane : scene.planes)
    {
        plane.point *= factor;
        plane.checkerSize *= factor;
    }
    for (auto& triangle : scene.triangles)
        for (auto& vertex : triangle.vertices) vertex *= factor;
    for (auto& mesh : scene.meshes)
    {
        auto triangles = *mesh.triangles;
        for (auto& triangle : triangles)
            for (auto& vertex : triangle) vertex *= factor;
        mesh.triangles = std::make_shared<const decltype(triangles)>(triangles);
    }
    for (auto& light : scene.lights)
    {
        light.position *= factor;
        light.color *= factor * factor;
    }
    return scene;
}

} // namespace rt
