// The rays of a tree as nodes of a glTF document.
#pragma once

#include "viz/drawing/rays.h"
#include "viz/export/gltf_materials.h"

namespace rt::viz
{

/// A node for each ray, shadow ray and ray that was not followed; `drawing` is how the tree is drawn.
void addRays(GltfDocument& gltf, GltfMaterials& materials, const RayTree& tree, const RayDrawing& drawing);

} // namespace rt::viz
