// Colours and surfaces of a glTF document.
#pragma once

#include "common/scene/scene_description.h"
#include "viz/export/gltf_document.h"

namespace rt::viz
{

/// Each is made when it is first used. Returns indices of materials.
class GltfMaterials
{
public:
    GltfMaterials(GltfDocument& document, const SceneDescription& described) : gltf(document), scene(described) {}

    /// A colour that is the same in any light.
    int unlit(const std::string& title, const Rgba& color, bool fades = false);
    /// A material of the scene; its numbers stand in `extras`.
    int surface(int index, bool bothSides = false, bool fades = false);
    /// The plane's checker as a repeated picture of two by two cells.
    int checkered(const PlaneDescription& plane, const std::string& title);

private:
    GltfDocument::Json made(const Material<double>& mat, bool bothSides, bool fades);

    GltfDocument& gltf;
    const SceneDescription& scene;
    std::map<std::string, int> known;
};

/// Linear, each in [0, 1].
GltfDocument::Json channels(const vec3& color);

} // namespace rt::viz
