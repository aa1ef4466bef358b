// A scene as its file states it: plain data in double, nothing derived. `Scene<Real>` is what rays meet.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "common/base/image.h"
#include "common/base/light.h"
#include "common/base/material.h"

namespace rt
{

struct CameraDescription
{
    Vec3<double> eye{0, 0, 0};
    Vec3<double> target{0, 0, -1};
    Vec3<double> up{0, 1, 0};
    double verticalFov = 40;       ///< degrees, in (0, 180)
    int width = 640, height = 480; ///< pixels
    int pixelX = -1, pixelY = -1;  ///< the pixel worth clicking; -1: the middle of the picture
};

/// What a ray that may not be traced returns.
enum class AtCap
{
    black,
    sky,
    direct
};

enum class FresnelModel
{
    exact,
    schlick,
    none ///< everything is transmitted: the idealised glass of lesson 05
};

enum class ShadowThroughGlass
{
    block,
    tint
};

/// The policies of tracing.
struct TraceSettings
{
    int maxDepth = 8;  ///< rays of this depth are traced, deeper ones are not; the camera ray has depth 0
    double cutoff = 0; ///< rays that could add less than this to a pixel are not traced
    AtCap atCap = AtCap::black;
    FresnelModel fresnel = FresnelModel::exact;
    ShadowThroughGlass shadowThroughGlass = ShadowThroughGlass::block;
};

/// How an image covers the sphere of directions; the middle of the image is the direction -z, its right half is +x.
enum class SkyMapping
{
    latlong, ///< longitude from left to right, the angle to the zenith from top to bottom
    angular  ///< Debevec's light probe: a disc, the distance from the middle is the angle to -z, its rim is +z
};

struct Sun
{
    Vec3<double> direction{0, 1, 0}; ///< from the scene to the sun; any length but 0
    Vec3<double> color{0, 0, 0};     ///< radiance inside its disc
    double size = 5;                 ///< diameter in degrees, in (0, 180]
};

/// A colour, or a gradient, or an image; the first two may have a sun.
struct SkyDescription
{
    bool present = false;
    Vec3<double> color{0, 0, 0};        ///< everywhere, or at the horizon and below if there is a zenith
    std::optional<Vec3<double>> zenith; ///< straight up; in between linear in the direction's y
    std::optional<Sun> sun;
    std::string imageFile; ///< as in the scene file; empty: no image
    SkyMapping mapping = SkyMapping::latlong;
    std::shared_ptr<const Image> image; ///< linear RGB; shared, since scenes are copied
};

struct SphereDescription
{
    Vec3<double> center{0, 0, 0};
    double radius = 1;
    int material = 0;
};

struct PlaneDescription
{
    Vec3<double> point{0, 0, 0};
    Vec3<double> normal{0, 1, 0};
    int material = 0;
    bool hasChecker = false;
    Vec3<double> checkerColor{0, 0, 0};
    double checkerSize = 1;
};

struct TriangleDescription
{
    std::array<Vec3<double>, 3> vertices{};
    int material = 0;
};

/// An OBJ file's triangles, in the order of its faces.
struct MeshDescription
{
    std::string file; ///< as in the scene file
    std::shared_ptr<const std::vector<std::array<Vec3<double>, 3>>> triangles;
    int material = 0;
};

/// Where a value stands in a text; both count from 1, columns in code points.
struct TextPlace
{
    int line = 0, column = 0;
};

/// Where each field of a scene file stands, by its name: `camera.eye`, `materials.glass.ior`, `sphere0.radius`.
using FieldPlaces = std::unordered_map<std::string, TextPlace>;

struct SceneDescription
{
    std::string file; ///< where it came from, for messages and trees
    std::string title;
    CameraDescription camera;
    TraceSettings trace;
    SkyDescription sky;
    std::vector<Material<double>> materials;
    std::vector<SphereDescription> spheres;
    std::vector<PlaneDescription> planes;
    std::vector<TriangleDescription> triangles;
    std::vector<MeshDescription> meshes;
    std::vector<Light<double>> lights;
    std::vector<std::string> warnings;         ///< what was left out on reading, each as `file:line:column: why`
    std::shared_ptr<const FieldPlaces> places; ///< in the file; shared, since scenes are copied; none if made by hand

    /// "file:line:column: " of a field, as messages begin; "" if it is not from a file.
    std::string placeOf(const std::string& field) const
    {
        if (!places) return "";
        const auto found = places->find(field);
        if (found == places->end()) return file + ": ";
        return file + ":" + std::to_string(found->second.line) + ":" + std::to_string(found->second.column) + ": ";
    }

    /// The pixel worth clicking, kept inside the picture.
    std::array<int, 2> pixel() const
    {
        return {camera.pixelX < 0 ? camera.width / 2 : std::min(camera.pixelX, camera.width - 1),
                camera.pixelY < 0 ? camera.height / 2 : std::min(camera.pixelY, camera.height - 1)};
    }
};

/// Calls visit(corners, material) with each triangle of the scene, those of meshes too, in the order of their ids. What looks
/// at all that a scene holds uses this: loops over `triangles` alone forget the meshes.
template <class Visit>
void forEachTriangle(const SceneDescription& scene, Visit&& visit)
{
    for (const auto& triangle : scene.triangles) visit(triangle.vertices, triangle.material);
    for (const auto& mesh : scene.meshes)
        if (mesh.triangles)
            for (const auto& corners : *mesh.triangles) visit(corners, mesh.material);
}

} // namespace rt
