#include "viz/export/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/base/image.h"
#include "common/files/picture_file.h"
#include "viz/drawing/picture_view.h"

namespace rt::viz
{

namespace
{

using GltfJson = GltfDocument::Json;

GltfJson factor(const vec3& color, double alpha)
{
    GltfJson four = channels(color);
    four.push_back(alpha);
    return four;
}

} // namespace

GltfJson channels(const vec3& color)
{
    const auto share = [](double x) { return x > 0 ? std::min(x, 1.0) : 0.0; };
    return {share(color.x), share(color.y), share(color.z)};
}

int GltfMaterials::unlit(const std::string& title, const Rgba& color, bool fades)
{
    const auto key = fmt::format("{}/{}/{}/{}/{}", title, color.r, color.g, color.b, fades);
    if (const auto found = known.find(key); found != known.end()) return found->second;
    gltf.uses("KHR_materials_unlit");
    const vec3 rgb(fromSrgb8(color.r), fromSrgb8(color.g), fromSrgb8(color.b));
    GltfJson material = {{"name", title},
                         {"pbrMetallicRoughness",
                          {{"baseColorFactor", factor(rgb, 1)}, {"metallicFactor", 0}, {"roughnessFactor", 0.9}}},
                         {"extensions", {{"KHR_materials_unlit", GltfJson::object()}}}};
    if (fades) material["alphaMode"] = "BLEND";
    return known[key] = gltf.add("materials", std::move(material));
}

/// Glass is blended and not refracting (KHR_materials_transmission): the rays within must be seen where they are.
GltfJson GltfMaterials::made(const Material<double>& mat, bool bothSides, bool fades)
{
    const bool glass = mat.isDielectric();
    // A metal shows what is around it, and many programs have nothing there: wholly metallic it would be black.
    const double metal = 0.75 * std::clamp(mat.mirror, 0.0, 1.0);
    // Blinn's exponent as the roughness of a microfacet distribution.
    const double roughness = glass            ? 0
                             : mat.mirror > 0 ? 0.5 * (1 - mat.mirror)
                             : mat.glossy > 0 ? std::pow(2 / (mat.exponent + 2), 0.25)
                                              : 1;
    GltfJson material = {{"name", mat.name},
                         {"pbrMetallicRoughness",
                          {{"baseColorFactor", factor(mat.color, glass ? 0.25 : 1)},
                           {"metallicFactor", glass ? 0 : metal},
                           {"roughnessFactor", std::clamp(roughness, 0.0, 1.0)}}}};
    if (glass || fades) material["alphaMode"] = "BLEND";
    if (bothSides) material["doubleSided"] = true;
    GltfJson extras = GltfJson::object();
    put(extras, "color", mat.color);
    put(extras, "mirror", mat.mirror);
    put(extras, "ior", mat.ior);
    put(extras, "ior_outside", mat.iorOutside);
    put(extras, "glossy", mat.glossy);
    put(extras, "exponent", mat.exponent);
    material["extras"] = std::move(extras);
    const double relative = mat.ior / mat.iorOutside;
    if (glass && relative >= 1 && std::isfinite(relative)) // the extension knows no bubbles
    {
        gltf.uses("KHR_materials_ior");
        material["extensions"]["KHR_materials_ior"]["ior"] = relative;
    }
    return material;
}

int GltfMaterials::surface(int index, bool bothSides, bool fades)
{
    const auto key = fmt::format("surface {} {} {}", index, bothSides, fades);
    if (const auto found = known.find(key); found != known.end()) return found->second;
    return known[key] = gltf.add("materials", made(scene.materials[std::size_t(index)], bothSides, fades));
}

int GltfMaterials::checkered(const PlaneDescription& plane, const std::string& title)
{
    const auto& mat = scene.materials[std::size_t(plane.material)];
    constexpr int cell = 32; // pixels: enough for sharp edges when they are blurred
    Image picture(2 * cell, 2 * cell);
    for (int y = 0; y < 2 * cell; ++y)
        for (int x = 0; x < 2 * cell; ++x)
            picture.at(x, y) = (x / cell + y / cell) % 2 == 0 ? mat.color : plane.checkerColor;
    const int texture = gltf.addTexture("checker of " + title, pngBytes(picture));
    GltfJson material = made(mat, mat.isDielectric(), false);
    auto& look = material["pbrMetallicRoughness"];
    look["baseColorFactor"] = factor(vec3(1), look["baseColorFactor"][3]);
    look["baseColorTexture"]["index"] = texture;
    put(material["extras"], "checker_color", plane.checkerColor);
    put(material["extras"], "checker_size", plane.checkerSize);
    return gltf.add("materials", std::move(material));
}

} // namespace rt::viz
