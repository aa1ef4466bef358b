#include "viz/export/gltf_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "common/scene/scene.h"
#include "viz/drawing/object_meshes.h"
#include "viz/drawing/planes.h"

namespace rt::viz
{

namespace
{

using GltfJson = GltfDocument::Json;

/// More single triangles than these become one node for each material.
constexpr std::size_t mostSingleTriangles = 500;
using std::numbers::pi;

struct SceneExporter
{
    GltfDocument& gltf;
    GltfMaterials& materials;
    const SceneDescription& scene;
    const RayDrawing& drawing;
    Extent objects = objectExtent(scene);
    int objectGroup = -1;
    std::map<std::string, int> balls{};
    std::map<int, std::optional<GltfDocument::Geometry>> ballGeometry{};

    const Material<double>& materialAt(int index) const { return scene.materials[std::size_t(index)]; }

    /// A node with a mesh of its own, made of material(); without one if nothing of it can be drawn.
    template <class Material>
    GltfJson node(const std::string& title, const Mesh& mesh, Material&& material, bool fades = false)
    {
        GltfJson made = {{"name", title}};
        if (const auto geometry = gltf.add(mesh, fades)) made["mesh"] = gltf.addMesh(title, {{*geometry, material()}});
        return made;
    }

    /// Around all that is drawn, but for what is so far away that the rest would be tiny.
    Extent shown() const
    {
        auto points = objectPoints(scene);
        for (const auto& point : rayPoints(drawing, true)) points.push_back(point);
        for (const auto& light : scene.lights) points.push_back(light.position);
        std::erase_if(points, [&](const vec3& p) { return !(length(p - objects.centre) < 12 * objects.radius); });
        points.push_back(scene.camera.eye);
        return around(points, objects);
    }

    /// One ball, which all spheres share: a mesh for each material.
    int ball(int materialIndex, int sides)
    {
        const auto key = fmt::format("ball {} {}", materialIndex, sides);
        if (const auto known = balls.find(key); known != balls.end()) return known->second;
        auto& geometry = ballGeometry[sides];
        if (!geometry)
        {
            Mesh mesh;
            addSphere(mesh, vec3(0), 1, sides, {});
            geometry = gltf.add(mesh, false);
        }
        return balls[key] = gltf.addMesh("ball", {{*geometry, materialIndex}});
    }

    static GltfJson placed(const std::string& title, const vec3& centre, double radius)
    {
        return {{"name", title}, {"translation", {centre.x, centre.y, centre.z}}, {"scale", {radius, radius, radius}}};
    }

    void addObject(GltfJson object, const std::string& primitive, int materialIndex,
                   GltfJson extras = GltfJson::object())
    {
        if (!object.contains("mesh")) return;
        extras["primitive"] = primitive;
        extras["material"] = materialAt(materialIndex).name;
        object["extras"] = std::move(extras);
        if (objectGroup < 0) objectGroup = gltf.addChild(-1, {{"name", "objects"}});
        gltf.addChild(objectGroup, std::move(object));
    }

    void addSpheres(const Extent& visible)
    {
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        {
            const auto& sphere = scene.spheres[i];
            const auto title = fmt::format("sphere{}", i);
            GltfJson extras = GltfJson::object();
            put(extras, "center", sphere.center);
            put(extras, "radius", sphere.radius);
            GltfJson object;
            if (isBackdrop(sphere, scene.camera))
            {
                SceneDescription alone;
                alone.camera = scene.camera;
                alone.materials = scene.materials;
                alone.spheres = {sphere};
                object = node(
                    title, objectMeshes(alone, visible).backdrop,
                    [&] { return materials.surface(sphere.material, true, true); }, true);
            }
            else if (fitsFloat(sphere.center) && fitsFloat(vec3(sphere.radius)))
            {
                object = placed(title, sphere.center, sphere.radius);
                object["mesh"] = ball(materials.surface(sphere.material), scene.spheres.size() > 40 ? 36 : 64);
            }
            addObject(object, title, sphere.material, extras);
        }
    }

    void addPlanes(const Extent& visible)
    {
        const auto patches = planePatches(scene, visible);
        if (patches.empty()) return;
        const Scene<double> derived(scene); // for the checkers' axes
        for (const auto& patch : patches)
        {
            const auto& plane = scene.planes[std::size_t(patch.plane)];
            const auto& axes = derived.planes[std::size_t(patch.plane)];
            const auto title = fmt::format("plane{}", patch.plane);
            Mesh mesh;
            std::vector<std::array<double, 2>> cells;
            const vec3 N = unit(cross(patch.right, patch.forward));
            // Whole pairs of cells before the patch are left out, so that floats are exact enough.
            const auto before = [&](const vec3& axis) {
                return std::floor(dot(patch.corner, axis) / (2 * plane.checkerSize));
            };
            for (const auto& [u, v] : patch.outline)
            {
                const vec3 point = patch.at(u, v);
                mesh.points.push_back(point);
                mesh.normals.push_back(N);
                cells.push_back({dot(point, axes.U) / (2 * plane.checkerSize) - before(axes.U),
                                 dot(point, axes.V) / (2 * plane.checkerSize) - before(axes.V)});
            }
            for (int i = 2; i < int(mesh.points.size()); ++i) mesh.triangles.push_back({0, i - 1, i});
            const bool seeThrough = materialAt(plane.material).isDielectric();
            const auto geometry = gltf.add(mesh, false, plane.hasChecker ? cells : decltype(cells){});
            if (!geometry) continue;
            const int finish =
                plane.hasChecker ? materials.checkered(plane, title) : materials.surface(plane.material, seeThrough);
            GltfJson extras = GltfJson::object();
            put(extras, "point", plane.point);
            put(extras, "normal", plane.normal);
            addObject({{"name", title}, {"mesh", gltf.addMesh(title, {{*geometry, finish}})}}, title, plane.material,
                      extras);
        }
    }

    void addTriangles()
    {
        const bool single = scene.triangles.size() <= mostSingleTriangles;
        std::map<int, Mesh> together;
        for (std::size_t i = 0; i < scene.triangles.size(); ++i)
        {
            const auto& vertices = scene.triangles[i].vertices;
            const int mat = scene.triangles[i].material;
            Mesh alone, &mesh = single ? alone : together[mat];
            addTriangle(mesh, vertices[0], vertices[1], vertices[2], {});
            const auto title = fmt::format("triangle{}", i);
            if (single) addObject(node(title, mesh, [&] { return materials.surface(mat, true); }), title, mat);
        }
        for (const auto& [index, mesh] : together)
        {
            const int mat = index; // a structured binding cannot be captured
            addObject(node("triangles of " + materialAt(mat).name, mesh, [&] { return materials.surface(mat, true); }),
                      "triangles", mat);
        }
        for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        {
            const int mat = scene.meshes[i].material;
            Mesh mesh;
            for (const auto& [a, b, c] : *scene.meshes[i].triangles) addTriangle(mesh, a, b, c, {});
            const auto title = fmt::format("mesh{}", i);
            addObject(node(title, mesh, [&] { return materials.surface(mat, true); }), title, mat,
                      {{"file", scene.meshes[i].file}});
        }
    }

    void addLights()
    {
        int group = -1;
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
        {
            const auto& light = scene.lights[i];
            if (!fitsFloat(light.position)) continue;
            if (group < 0) group = gltf.addChild(-1, {{"name", "lights"}});
            const auto title = fmt::format("light {}", i);
            GltfJson object = placed(title, light.position, lightRadius(drawing));
            object["mesh"] = ball(materials.unlit(title, lightColor(light)), 16);
            put(object["extras"], "color", light.color);
            const int entry = gltf.addChild(group, std::move(object));

            // A matte surface of glTF sends on color / pi of the light, the lecture's all of it.
            const double brightest = largestChannel(light.color), intensity = pi * brightest;
            if (!(intensity > 0) || !fitsFloat(vec3(intensity))) continue;
            const int lamp = gltf.addLight({{"type", "point"},
                                            {"name", title},
                                            {"color", channels(light.color / brightest)},
                                            {"intensity", intensity}});
            gltf.addChild(entry, {{"name", fmt::format("lamp {}", i)},
                                  {"extensions", {{"KHR_lights_punctual", {{"light", lamp}}}}}});
        }
    }

    void addCamera()
    {
        const auto& camera = scene.camera;
        const ImagePlane plane = imagePlane(camera, objects);
        const vec3 r = unit(plane.right), u = -unit(plane.down);
        // glTF's camera looks along its own -z.
        const glm::dquat turn = glm::normalize(glm::quat_cast(glm::dmat3(r, u, cross(r, u))));
        const vec3 turned(turn.x, turn.y, turn.z);
        if (!fitsFloat(camera.eye) || !isFinite(turned) || !std::isfinite(turn.w)) return;
        const int index = gltf.add("cameras", {{"name", "camera"},
                                               {"type", "perspective"},
                                               {"perspective",
                                                {{"aspectRatio", double(camera.width) / camera.height},
                                                 {"yfov", camera.verticalFov * pi / 180},
                                                 {"znear", std::clamp(0.001 * objects.radius, 1e-30, 1e30)}}}});
        GltfJson entry = {{"name", "camera"},
                          {"camera", index},
                          {"translation", {camera.eye.x, camera.eye.y, camera.eye.z}},
                          {"rotation", {turned.x, turned.y, turned.z, turn.w}},
                          {"extras", {{"width", camera.width}, {"height", camera.height}}}};
        gltf.addChild(-1, std::move(entry));

        constexpr double thickness = 0.006; // of the objects' extent, as in the viewer
        GltfJson frustum = node("camera frustum", cameraMesh(plane, thickness * objects.radius), [&] {
            return materials.unlit("camera frustum", {190, 205, 222});
        });
        if (frustum.contains("mesh")) gltf.addChild(-1, std::move(frustum));
    }

    void addAll()
    {
        // As in the viewer: without what is high above the floor, so that the floor lies under the objects.
        Extent visible = shown();
        visible.centre = 0.5 * (visible.centre + objects.centre);
        addSpheres(visible);
        addPlanes(visible);
        addTriangles();
        addLights();
        addCamera();
    }
};

} // namespace

void addScene(GltfDocument& gltf, GltfMaterials& materials, const SceneDescription& scene, const RayDrawing& drawing)
{
    SceneExporter exporter{gltf, materials, scene, drawing};
    exporter.addAll();
}

} // namespace rt::viz
