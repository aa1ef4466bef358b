#include "viz/drawing/object_meshes.h"

#include <algorithm>
#include <cmath>

#include "common/base/image.h"

namespace rt::viz
{

namespace
{

Rgba screenColor(const vec3& linear)
{
    return {toSrgb8(linear.x), toSrgb8(linear.y), toSrgb8(linear.z)};
}

/// The part of a huge sphere nearest to what is shown, as a grid laid onto it.
void addBackdrop(Mesh& mesh, const SphereDescription& sphere, const Extent& shown, const Rgba& color)
{
    constexpr int n = 40;
    vec3 N = unit(shown.centre - sphere.center);
    if (N == vec3(0)) N = vec3(0, 1, 0);
    const auto [u, v] = across(N);
    const double half = std::min(1.6 * shown.radius, 0.9 * sphere.radius);
    const int first = int(mesh.points.size());
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
        {
            const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
            const vec3 out = unit(sphere.radius * N + half * (x * u + y * v));
            mesh.points.push_back(sphere.center + sphere.radius * out);
            mesh.normals.push_back(out);
            const double fade = std::clamp((1 - std::hypot(x, y)) / 0.4, 0.0, 1.0);
            mesh.colors.push_back(color.withAlpha(fade * fade * (3 - 2 * fade)));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
        {
            const int p = first + j * (n + 1) + i;
            mesh.triangles.push_back({p, p + 1, p + n + 1});
            mesh.triangles.push_back({p + 1, p + n + 2, p + n + 1});
        }
}

} // namespace

ObjectMeshes objectMeshes(const SceneDescription& scene, const Extent& shown)
{
    ObjectMeshes meshes;
    const auto meshFor = [&](const Material<double>& material) -> Mesh& {
        return material.isDielectric() ? meshes.glass : material.mirror >= 0.5 ? meshes.chrome : meshes.matte;
    };
    const int sides = scene.spheres.size() > 200 ? 20 : scene.spheres.size() > 40 ? 36 : 72;
    for (const auto& sphere : scene.spheres)
    {
        const auto& material = scene.materials[std::size_t(sphere.material)];
        const Rgba color = screenColor(material.color);
        if (isBackdrop(sphere, scene.camera))
            addBackdrop(meshes.backdrop, sphere, shown, color);
        else
            addSphere(meshFor(material), sphere.center, sphere.radius, sides, color);
    }
    forEachTriangle(scene, [&](const std::array<vec3, 3>& corners, int index) {
        const auto& material = scene.materials[std::size_t(index)];
        addTriangle(meshFor(material), corners[0], corners[1], corners[2], screenColor(material.color));
    });
    return meshes;
}

Mesh cameraMesh(const ImagePlane& plane, double thickness)
{
    Mesh mesh;
    const Rgba edge = color::textFaint, frame = color::textDim;
    const vec3 corners[] = {plane.at(0, 0), plane.at(1, 0), plane.at(1, 1), plane.at(0, 1)};
    for (int i = 0; i < 4; ++i)
    {
        addTube(mesh, plane.eye, corners[i], 0.6 * thickness, edge, edge);
        addTube(mesh, corners[i], corners[(i + 1) % 4], thickness, frame, frame);
    }
    addSphere(mesh, plane.eye, 3.2 * thickness, 20, frame);
    return mesh;
}

Rgba lightColor(const Light<double>& light)
{
    const double brightest = largestChannel(light.color);
    if (!(brightest > 0) || !std::isfinite(brightest)) return {90, 90, 90};
    return screenColor(light.color / brightest);
}

Mesh lightMesh(const SceneDescription& scene, double radius)
{
    Mesh mesh;
    for (const auto& light : scene.lights)
        if (isFinite(light.position)) addSphere(mesh, light.position, radius, 24, lightColor(light));
    return mesh;
}

} // namespace rt::viz
