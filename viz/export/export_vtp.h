// A ray tree as VTK PolyData (.vtp), for ParaView and other programs that compute with it.
#pragma once

#include <string>

#include "common/scene/scene_description.h"
#include "common/tree/ray_tree.h"

namespace rt::viz
{

/// The text of a .vtp file: one line cell for each ray and then one for each shadow ray, each from its start to its end, in
/// scene units and double. A ray ends at its hit point, or where it leaves the scene; a shadow ray at the light, or at what is
/// in its way. Those whose ends are not finite are left out, hence `id` and `shadow` may skip numbers.
///
/// Cell arrays (double unless stated; NaN, -1 or "" where a thing does not apply):
///   id (int)       of the ray; -1 for shadow rays
///   parent (int)   of the ray, -1 at the root; for shadow rays the ray at whose hit point they start
///   kind (int)     0 camera, 1 reflected, 2 transmitted, 3 shadow; kind_name (string) says the same
///   depth (int)    for shadow rays that of the ray at whose hit point they start
///   weight, throughput (3), radiance (3), own (3), contribution (3), t, n1, n2, fresnel   as in the tree's JSON
///   end (string)   absorbed, miss, cap, cutoff, black; "none" if the ray has children
///   tir, inside (int)        1 or 0
///   primitive, material (string)   what was hit; for shadow rays what is in the way
///   line (int)     of the lesson's source
///   shadow, light (int)      index of the shadow ray in the tree, and of its light
///   visible (int)  of shadow rays: 1 if the light is reached, else 0
///   distance       of shadow rays: to the light; tint (3)
///
/// `scene` must be the scene that the tree was recorded in. No VTK and no window are needed.
std::string vtpText(const RayTree& tree, const SceneDescription& scene);

} // namespace rt::viz
