#include "viz/export/export_gltf.h"

#include "viz/export/gltf_rays.h"
#include "viz/export/gltf_scene.h"

namespace rt::viz
{

namespace
{

GltfDocument document(const RayTree& tree, const SceneDescription& scene)
{
    const RayDrawing drawing = drawRays(tree, scene, objectExtent(scene));
    GltfDocument gltf;
    auto& extras = gltf.asset()["extras"];
    extras = {{"scene", tree.scene},        {"title", scene.title},       {"lesson", tree.lesson},
              {"real", tree.real},          {"max_depth", tree.maxDepth}, {"rays", tree.nodes.size()},
              {"drawn_rays", drawing.nodes}};
    if (tree.pixel) extras["pixel"] = *tree.pixel;
    GltfMaterials materials(gltf, scene);
    addRays(gltf, materials, tree, drawing);
    addScene(gltf, materials, scene, drawing);
    return gltf;
}

} // namespace

std::string gltfBinary(const RayTree& tree, const SceneDescription& scene)
{
    return document(tree, scene).binary();
}

std::string gltfText(const RayTree& tree, const SceneDescription& scene)
{
    return document(tree, scene).text();
}

} // namespace rt::viz
