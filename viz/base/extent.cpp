#include "viz/base/extent.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace rt::viz
{

namespace
{

/// Distance that the camera looks: the scale of what the scene's author meant to show.
double lookingDistance(const CameraDescription& camera)
{
    const double d = length(camera.target - camera.eye);
    return d > 0 && std::isfinite(d) ? d : 1;
}

bool isNear(const vec3& point, const CameraDescription& camera)
{
    return isFinite(point) && length(point - camera.target) < 8 * lookingDistance(camera);
}

} // namespace

std::optional<std::array<vec3, 2>> boxOf(const MeshDescription& mesh, const std::function<bool(const vec3&)>& counts)
{
    std::array<vec3, 2> box{vec3(infinity<double>), vec3(-infinity<double>)};
    if (!mesh.triangles) return std::nullopt;
    for (const auto& corners : *mesh.triangles)
        for (const auto& p : corners)
            if (!counts || counts(p)) box = {min(box[0], p), max(box[1], p)};
    if (box[0].x <= box[1].x) return box;
    return std::nullopt;
}

Extent around(const std::vector<vec3>& points, const Extent& fallback)
{
    vec3 low(infinity<double>), high(-infinity<double>);
    for (const auto& p : points)
        if (isFinite(p))
        {
            low = min(low, p);
            high = max(high, p);
        }
    if (!(low.x <= high.x)) return fallback;
    Extent extent{0.5 * (low + high), 0};
    for (const auto& p : points)
        if (isFinite(p)) extent.radius = std::max(extent.radius, length(p - extent.centre));
    if (!(extent.radius > 0)) extent.radius = fallback.radius;
    return extent;
}

bool isBackdrop(const SphereDescription& sphere, const CameraDescription& camera)
{
    return sphere.radius > 4 * lookingDistance(camera) || !isNear(sphere.center, camera);
}

Extent extentOf(const SceneDescription& scene, const RayTree& tree)
{
    const Extent objects = objectExtent(scene);
    const bool isEmpty =
        scene.spheres.empty() && scene.planes.empty() && scene.triangles.empty() && scene.meshes.empty();
    std::vector<vec3> points;
    for (const auto& node : tree.nodes)
    {
        if (node.hit) points.push_back(node.hit->point);
        if (node.hit || node.parent >= 0) points.push_back(node.origin);
    }
    return isEmpty ? around(points, objects) : objects;
}

std::vector<vec3> objectPoints(const SceneDescription& scene)
{
    std::vector<vec3> points;
    for (const auto& sphere : scene.spheres)
        if (!isBackdrop(sphere, scene.camera))
            for (int corner = 0; corner < 8; ++corner)
                points.push_back(sphere.center +
                                 0.8 * sphere.radius *
                                     vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    for (const auto& triangle : scene.triangles)
        for (const auto& vertex : triangle.vertices)
            if (isNear(vertex, scene.camera)) points.push_back(vertex);
    for (const auto& mesh : scene.meshes)
        if (const auto box = boxOf(mesh, [&](const vec3& p) { return isNear(p, scene.camera); }))
            for (int corner = 0; corner < 8; ++corner)
                points.emplace_back((*box)[corner & 1].x, (*box)[corner >> 1 & 1].y, (*box)[corner >> 2].z);
    return points;
}

Extent objectExtent(const SceneDescription& scene)
{
    const double distance = lookingDistance(scene.camera);
    Extent extent = around(objectPoints(scene), {scene.camera.target, 0.4 * distance});
    extent.radius = std::max(extent.radius, 0.3 * distance);
    return extent;
}

std::optional<double> sizeOf(const SceneDescription& scene, const std::string& primitive)
{
    const auto digit = primitive.find_first_of("0123456789");
    if (digit == std::string::npos) return std::nullopt;
    std::size_t index = 0;
    if (std::from_chars(primitive.data() + digit, primitive.data() + primitive.size(), index).ec != std::errc())
        return std::nullopt;
    const auto kind = primitive.substr(0, digit);
    if (kind == "sphere" && index < scene.spheres.size()) return scene.spheres[index].radius;
    if (kind == "triangle" && index < scene.triangles.size())
    {
        const auto& [a, b, c] = scene.triangles[index].vertices;
        return std::max({length(b - a), length(c - b), length(a - c)}) / 2;
    }
    if (kind == "mesh" && index < scene.meshes.size())
    {
        if (const auto box = boxOf(scene.meshes[index])) return length((*box)[1] - (*box)[0]) / 2;
    }
    return std::nullopt;
}

ImagePlane imagePlane(const CameraDescription& camera, const Extent& extent)
{
    // The same basis as Camera<Real>; here only for drawing.
    const vec3 f = unit(camera.target - camera.eye), r = unit(cross(f, unit(camera.up))), u = cross(r, f);
    const double tangent = std::tan(camera.verticalFov * std::numbers::pi / 360);
    const double aspect = double(camera.width) / camera.height;
    // As wide as a good part of the scene, but well before what the camera looks at.
    const double widest = 2 * tangent * std::max(1.0, aspect);
    const double distance = std::min(0.9 * extent.radius / widest, 0.45 * lookingDistance(camera));
    const double h = tangent * distance;
    ImagePlane plane;
    plane.eye = camera.eye;
    plane.right = 2 * h * aspect * r;
    plane.down = -2 * h * u;
    plane.topLeft = camera.eye + distance * f - 0.5 * plane.right - 0.5 * plane.down;
    return plane;
}

} // namespace rt::viz
