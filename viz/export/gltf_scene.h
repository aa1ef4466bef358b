// The objects, the lights and the camera of a scene as nodes of a glTF document.
#pragma once

#include "viz/drawing/rays.h"
#include "viz/export/gltf_materials.h"

namespace rt::viz
{

/// `drawing`: the rays that are drawn in it. Planes reach so far that they lie below all of them.
void addScene(GltfDocument& gltf, GltfMaterials& materials, const SceneDescription& scene, const RayDrawing& drawing);

} // namespace rt::viz
