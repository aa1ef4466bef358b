// A ray tree and its scene as glTF 2.0, for Blender, three.js and model viewers. No window is needed.
#pragma once

#include <string>

#include "common/scene/scene_description.h"
#include "common/tree/ray_tree.h"

namespace rt::viz
{

/// The bytes of a .glb file. `scene` must be the scene that the tree was recorded in.
///
/// Nodes, all in world coordinates (their transforms are identities, but for spheres, lamps and the camera):
///   rays           "[3] transmitted depth 2": an arrow, nested as in the tree down to 100 levels, the rest side by side
///                  below "deeper rays". Below a ray stand "normal at [3]", "light 0 from [3]" (shadow rays) and
///                  "not followed: reflected from [3]".
///   objects        "sphere0", "plane1", "triangle2", the names that hits and blockers have in `extras`; "mesh0" holds all of
///                  "mesh0.triangle12". More than 500 single triangles are one node for each material.
///   lights         "light 0", a ball in the light's colour, and "lamp 0" in its middle, a point light. Programs that
///                  trace shadows must hide the ball, which lets no light out.
///   camera, camera frustum
/// `extras` hold the numbers of the tree: id, parent, kind, depth, origin, direction, hit, n1, n2, fresnel, weight,
/// throughput, radiance, own, contribution, end, tir, orphan, line; of shadow rays node, light, direction, distance, visible,
/// tint, blocker. A number that is not finite is left out, and so is a vector that has one.
///
/// Lengths are scene units. Rays that meet nothing end where they leave the scene and fade. Rays of no weight, rays without a
/// finite place, and those of large trees that the viewer does not draw either (mostDrawnNodes) have numbers but no arrow.
/// Planes end some way around the scene and are seen from the eye's side. Colours are those of palette.h.
/// Throws std::runtime_error if the file would exceed 4 GiB.
std::string gltfBinary(const RayTree& tree, const SceneDescription& scene);

/// The same as text: a .gltf file that needs no other file.
std::string gltfText(const RayTree& tree, const SceneDescription& scene);

} // namespace rt::viz
