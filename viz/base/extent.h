// How large a scene is, for everything that must be drawn at a sensible size.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/scene/scene_description.h"
#include "common/tree/ray_tree.h"

namespace rt::viz
{

using vec3 = Vec3<double>;

/// A sphere around what there is to see.
struct Extent
{
    vec3 centre{0, 0, 0};
    double radius = 1; ///< > 0
};

/// The smallest of the easily found spheres around points; the fallback if none of them is finite.
Extent around(const std::vector<vec3>& points, const Extent& fallback);

/// Around the objects that have a size a camera would look at: planes, and spheres that serve as a floor, do not count.
/// Not smaller than a part of the distance that the camera looks. Without objects: around what the camera looks at.
Extent objectExtent(const SceneDescription& scene);

/// The same; of a tree whose scene is not known, around its rays.
Extent extentOf(const SceneDescription& scene, const RayTree& tree);

/// Corners of the objects' bounding boxes, the same objects that objectExtent counts.
std::vector<vec3> objectPoints(const SceneDescription& scene);

/// The lowest and the highest corner of a mesh, of those points that count; nothing if there are none.
std::optional<std::array<vec3, 2>> boxOf(const MeshDescription& mesh,
                                         const std::function<bool(const vec3&)>& counts = {});

/// Does the sphere serve as a floor or a sky rather than as a thing to look at?
bool isBackdrop(const SphereDescription& sphere, const CameraDescription& camera);

/// The size of a primitive by its name in the tree ("sphere0"), for arrows that stand on it; empty for planes.
std::optional<double> sizeOf(const SceneDescription& scene, const std::string& primitive);

/// The picture's rectangle in space, some way in front of the eye: where the pinhole camera's image plane is drawn.
struct ImagePlane
{
    vec3 eye{0, 0, 0};
    vec3 topLeft{0, 0, 0}, right{1, 0, 0}, down{0, -1, 0}; ///< edges with their full lengths

    vec3 at(double x, double y) const { return topLeft + x * right + y * down; } ///< x, y in [0, 1]
};

ImagePlane imagePlane(const CameraDescription& camera, const Extent& extent);

} // namespace rt::viz
