#include <algorithm>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "common/scene/scene.h"
#include "viz/drawing/object_meshes.h"
#include "viz/drawing/planes.h"
#include "viz/drawing/view.h"
#include "viz/html/html_data.h"

namespace rt::viz
{

using Json = nlohmann::json;

namespace
{

/// The page draws so many triangles of files and meshes, evenly picked.
constexpr std::size_t mostTriangles = 900;
constexpr std::size_t mostSpheres = 400;

const char* lookOf(const Material<double>& material)
{
    return material.isDielectric() ? "glass" : material.mirror >= 0.5 ? "chrome" : "matte";
}

Json spheresJson(const SceneDescription& scene)
{
    Json spheres = Json::array();
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
    {
        const auto& sphere = scene.spheres[i];
        if (isBackdrop(sphere, scene.camera) || spheres.size() >= mostSpheres) continue;
        const auto& material = scene.materials[std::size_t(sphere.material)];
        spheres.push_back({{"center", shortTriple(sphere.center)},
                           {"radius", shortNumber(sphere.radius)},
                           {"color", hexOf(material.color)},
                           {"look", lookOf(material)},
                           {"name", fmt::format("sphere{}", i)}});
    }
    return spheres;
}

Json trianglesJson(const SceneDescription& scene)
{
    using Corners = std::array<vec3, 3>;
    std::vector<std::pair<const Corners*, int>> all;
    forEachTriangle(scene, [&](const Corners& corners, int material) { all.emplace_back(&corners, material); });
    Json triangles = Json::array();
    const std::size_t stride = 1 + all.size() / mostTriangles;
    for (std::size_t i = 0; i < all.size(); i += stride)
    {
        const auto& [corners, index] = all[i];
        const auto& material = scene.materials[std::size_t(index)];
        triangles.push_back({shortTriple((*corners)[0]), shortTriple((*corners)[1]), shortTriple((*corners)[2]),
                             hexOf(material.color), lookOf(material)});
    }
    return triangles;
}

/// A patch as a grid of cells along U and V; (u, v) of the outline are in those axes.
Json gridJson(const vec3& corner, const vec3& U, const vec3& V, const std::vector<vec3>& outline, const vec3& centre,
              double radius)
{
    Json corners = Json::array();
    for (const auto& p : outline) corners.push_back({shortNumber(dot(p - corner, U)), shortNumber(dot(p - corner, V))});
    return {{"origin", shortTriple(corner)},
            {"u", shortTriple(U)},
            {"v", shortTriple(V)},
            {"outline", corners},
            {"centre", {shortNumber(dot(centre - corner, U)), shortNumber(dot(centre - corner, V))}},
            {"radius", shortNumber(radius)}};
}

Json planesJson(const SceneDescription& scene, const Extent& shown)
{
    const Scene<double> traced(scene);
    Json planes = Json::array();
    for (const auto& patch : planePatches(scene, shown))
    {
        const auto& described = scene.planes[std::size_t(patch.plane)];
        const auto& plane = traced.planes[std::size_t(patch.plane)];
        const auto& material = scene.materials[std::size_t(described.material)];
        std::vector<vec3> outline;
        for (const auto& [u, v] : patch.outline) outline.push_back(patch.at(u, v));
        // The point of the plane where the checker's axes start.
        const vec3 start = dot(plane.P, plane.N) * plane.N;
        Json json = gridJson(start, plane.U, plane.V, outline, patch.at(0.5, 0.5), 0.5 * length(patch.right));
        json["normal"] = shortTriple(unit(cross(patch.right, patch.forward)));
        json["color"] = hexOf(material.color);
        json["look"] = lookOf(material);
        json["floor"] = patch.isFloor;
        if (described.hasChecker) json["checker"] = {hexOf(described.checkerColor), shortNumber(described.checkerSize)};
        planes.push_back(json);
    }
    // Spheres that serve as a floor are nearly flat where they are seen.
    for (const auto& sphere : scene.spheres)
    {
        if (!isBackdrop(sphere, scene.camera)) continue;
        vec3 N = unit(shown.centre - sphere.center);
        if (N == vec3(0)) N = vec3(0, 1, 0);
        const auto [U, V] = across(N);
        const vec3 top = sphere.center + sphere.radius * N;
        const double half = std::min(1.5 * shown.radius, 0.9 * sphere.radius);
        Json json = gridJson(top, U, V,
                             {top - half * U - half * V, top + half * U - half * V, top + half * U + half * V,
                              top - half * U + half * V},
                             top, half);
        json["normal"] = shortTriple(N);
        json["color"] = hexOf(scene.materials[std::size_t(sphere.material)].color);
        json["look"] = "matte";
        json["floor"] = true;
        planes.push_back(json);
    }
    return planes;
}

/// What the first view must show, as the window chooses it.
std::vector<vec3> shownPoints(const SceneDescription& scene, const RayDrawing& drawing, const Extent& objects,
                              const ImagePlane& screen, bool withLights)
{
    auto points = objectPoints(scene);
    for (const auto& p : rayPoints(drawing, withLights)) points.push_back(p);
    if (withLights)
        for (const auto& light : scene.lights) points.push_back(light.position);
    for (const auto& [x, y] : {vec2{0, 0}, {1, 0}, {0, 1}, {1, 1}}) points.push_back(screen.at(x, y));
    // What is too far away to be part of the scene would make all the rest tiny.
    std::erase_if(points, [&](const vec3& p) { return !(length(p - objects.centre) < 12 * objects.radius); });
    points.push_back(screen.eye);
    return points;
}

/// Those of the points that lie furthest out in some direction: to fit them is to fit all, nearly.
Json outermost(const std::vector<vec3>& points)
{
    std::vector<std::size_t> chosen;
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z)
            {
                const vec3 towards(x, y, z);
                const auto furthest = std::max_element(points.begin(), points.end(), [&](const vec3& a, const vec3& b) {
                    return dot(a, towards) < dot(b, towards);
                });
                if (furthest != points.end()) chosen.push_back(std::size_t(furthest - points.begin()));
            }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    Json json = Json::array();
    for (const auto i : chosen) json.push_back(shortTriple(points[i]));
    return json;
}

} // namespace

Json htmlObjects(const SceneDescription& scene, const RayDrawing& drawing, const Extent& objects)
{
    const ImagePlane screen = imagePlane(scene.camera, objects);
    const auto all = shownPoints(scene, drawing, objects, screen, true);
    const auto close = shownPoints(scene, drawing, objects, screen, false);
    const vec3 towards = bestDirection(drawing, scene), up = unit(scene.camera.up);
    // Lights far from everything else may lie outside: the shadow rays point to them.
    const auto distance = [&](const std::vector<vec3>& points) {
        return length(fitView(points, towards, up, 1.4).position - objects.centre);
    };
    const auto& points = distance(all) > 1.2 * distance(close) ? close : all;

    Extent ground = around(all, objects);
    ground.centre = 0.5 * (ground.centre + objects.centre);
    Json lights = Json::array();
    for (const auto& light : scene.lights) lights.push_back({shortTriple(light.position), hex(lightColor(light))});
    const auto corner = [&](double x, double y) { return shortTriple(screen.at(x, y)); };
    return {{"spheres", spheresJson(scene)},
            {"planes", planesJson(scene, ground)},
            {"triangles", trianglesJson(scene)},
            {"lights", lights},
            {"camera",
             {{"eye", shortTriple(screen.eye)}, {"corners", {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}}}},
            {"towards", shortTriple(towards)},
            {"up", shortTriple(up)},
            {"fit", outermost(points)}};
}

} // namespace rt::viz
