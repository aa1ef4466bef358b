#include "viz/export/gltf_rays.h"

#include <cmath>

#include <fmt/format.h>

#include "viz/drawing/ray_mesh.h"

namespace rt::viz
{

namespace
{

using GltfJson = GltfDocument::Json;

/// Importers nest calls as deep as nodes: Python's, for one, stop at 1000.
constexpr int mostLevels = 100;

GltfJson extrasOf(const RayTree::Node& node)
{
    GltfJson extras = {{"id", node.id}, {"parent", node.parent}, {"kind", name(node.kind)}, {"depth", node.depth}};
    put(extras, "origin", node.origin);
    put(extras, "direction", node.direction);
    if (node.hit)
    {
        GltfJson hit = GltfJson::object();
        put(hit, "t", node.hit->t);
        put(hit, "point", node.hit->point);
        put(hit, "normal", node.hit->normal);
        hit["primitive"] = node.hit->primitive;
        hit["material"] = node.hit->material;
        hit["inside"] = node.hit->inside;
        put(hit, "color", node.hit->color);
        extras["hit"] = std::move(hit);
    }
    put(extras, "n1", node.n1);
    put(extras, "n2", node.n2);
    put(extras, "fresnel", node.fresnel);
    put(extras, "weight", node.weight);
    put(extras, "throughput", node.throughput);
    put(extras, "radiance", node.radiance);
    put(extras, "own", node.own);
    put(extras, "contribution", node.contribution);
    if (node.end != End::none) extras["end"] = name(node.end);
    extras["tir"] = node.tir;
    extras["orphan"] = node.orphan;
    extras["line"] = node.line;
    return extras;
}

GltfJson extrasOf(const RayTree::Shadow& shadow)
{
    GltfJson extras = {{"node", shadow.node}, {"light", shadow.light}, {"visible", shadow.visible}};
    put(extras, "direction", shadow.direction);
    put(extras, "distance", shadow.distance);
    put(extras, "tint", shadow.tint);
    if (shadow.blocker)
    {
        extras["blocker"] = {{"primitive", shadow.blocker->primitive}};
        put(extras["blocker"], "point", shadow.blocker->point);
    }
    extras["line"] = shadow.line;
    return extras;
}

GltfJson extrasOf(const RayTree::Capped& capped)
{
    GltfJson extras = {{"node", capped.node}, {"kind", name(capped.kind)}, {"reason", name(capped.reason)}};
    put(extras, "direction", capped.direction);
    put(extras, "weight", capped.weight);
    put(extras, "radiance", capped.radiance);
    extras["line"] = capped.line;
    return extras;
}

const char* nameOf(RayRole role)
{
    constexpr const char* names[] = {"camera ray", "reflected ray", "transmitted ray", "shadow ray, visible"};
    if (role <= RayRole::reaches) return names[int(role)];
    return isShadow(role) ? "shadow ray, blocked" : "normal";
}

struct RayExporter
{
    GltfDocument& gltf;
    GltfMaterials& materials;
    const RayTree& tree;
    const RayDrawing& drawing;

    struct Arrows
    {
        std::vector<RayDrawing> rays, normals, shadows, capped;
    };

    /// The drawing, taken apart.
    Arrows arrows() const
    {
        Arrows found;
        found.rays.resize(tree.nodes.size());
        found.normals.resize(tree.nodes.size());
        found.shadows.resize(tree.shadows.size());
        found.capped.resize(tree.capped.size());
        for (auto segment : drawing.segments)
        {
            if (std::isnan(segment.weight)) segment.weight = 0; // its place is known, so it is drawn, thin
            auto& part = segment.shadow >= 0               ? found.shadows[std::size_t(segment.shadow)]
                         : segment.capped >= 0             ? found.capped[std::size_t(segment.capped)]
                         : segment.role == RayRole::normal ? found.normals[std::size_t(segment.node)]
                                                           : found.rays[std::size_t(segment.node)];
            part.segments.push_back(segment);
        }
        for (const auto& mark : drawing.blockers) found.shadows[std::size_t(mark.shadow)].blockers.push_back(mark);
        return found;
    }

    GltfJson arrow(const std::string& title, RayDrawing part)
    {
        GltfJson made = {{"name", title}};
        if (part.segments.empty()) return made;
        part.size = drawing.size;
        const RayRole role = part.segments[0].role;
        const auto mesh = buildRayMesh(part, {});
        std::vector<GltfDocument::Primitive> primitives;
        if (const auto solid = gltf.add(mesh.solid, false))
            primitives.push_back({*solid, materials.unlit(nameOf(role), colorOf(role))});
        if (const auto fading = gltf.add(mesh.fading, true))
            primitives.push_back({*fading, materials.unlit(nameOf(role), colorOf(role), true)});
        if (!primitives.empty()) made["mesh"] = gltf.addMesh(title, primitives);
        return made;
    }

    void addRays()
    {
        if (tree.nodes.empty()) return;
        const Arrows parts = arrows();
        const int group = gltf.addChild(-1, {{"name", "rays"}});
        int deeper = -1;
        std::vector<int> made(tree.nodes.size()), level(tree.nodes.size(), 0);
        for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        {
            const auto& ray = tree.nodes[i];
            const bool hasParent = ray.parent >= 0 && std::size_t(ray.parent) < i;
            if (hasParent) level[i] = level[std::size_t(ray.parent)] + 1;
            if (level[i] > mostLevels && deeper < 0) deeper = gltf.addChild(group, {{"name", "deeper rays"}});
            GltfJson entry = arrow(fmt::format("[{}] {} depth {}", ray.id, name(ray.kind), ray.depth), parts.rays[i]);
            entry["extras"] = extrasOf(ray);
            made[i] = gltf.addChild(level[i] > mostLevels ? deeper
                                    : hasParent           ? made[std::size_t(ray.parent)]
                                                          : group,
                                    std::move(entry));
            if (!parts.normals[i].segments.empty())
                gltf.addChild(made[i], arrow(fmt::format("normal at [{}]", ray.id), parts.normals[i]));
        }
        const auto addTo = [&](int ray, const std::string& title, const RayDrawing& part, GltfJson extras) {
            if (ray < 0 || std::size_t(ray) >= made.size()) return;
            GltfJson entry = arrow(title, part);
            entry["extras"] = std::move(extras);
            gltf.addChild(made[std::size_t(ray)], std::move(entry));
        };
        for (std::size_t i = 0; i < tree.shadows.size(); ++i)
        {
            const auto& shadow = tree.shadows[i];
            addTo(shadow.node, fmt::format("light {} from [{}]", shadow.light, shadow.node), parts.shadows[i],
                  extrasOf(shadow));
        }
        for (std::size_t i = 0; i < tree.capped.size(); ++i)
        {
            const auto& capped = tree.capped[i];
            addTo(capped.node, fmt::format("not followed: {} from [{}]", name(capped.kind), capped.node),
                  parts.capped[i], extrasOf(capped));
        }
    }
};

} // namespace

void addRays(GltfDocument& gltf, GltfMaterials& materials, const RayTree& tree, const RayDrawing& drawing)
{
    RayExporter{gltf, materials, tree, drawing}.addRays();
}

} // namespace rt::viz
