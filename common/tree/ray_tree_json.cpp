#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/tree/ray_tree.h"

namespace rt
{

namespace
{

using Json = nlohmann::ordered_json;

// Numbers that are not finite become null when they are written.

Json triple(const Vec3<double>& v)
{
    return Json::array({v.x, v.y, v.z});
}

Json orNull(const std::optional<double>& x)
{
    return x ? Json(*x) : Json(nullptr);
}

Json endOf(End end)
{
    return end == End::none ? Json(nullptr) : Json(name(end));
}

Json nodeJson(const RayTree::Node& node)
{
    Json hit = nullptr;
    if (node.hit)
        hit = {{"t", node.hit->t},
               {"point", triple(node.hit->point)},
               {"normal", triple(node.hit->normal)},
               {"primitive", node.hit->primitive},
               {"material", node.hit->material},
               {"inside", node.hit->inside},
               {"color", triple(node.hit->color)}};
    return {{"id", node.id},
            {"parent", node.parent},
            {"kind", name(node.kind)},
            {"depth", node.depth},
            {"origin", triple(node.origin)},
            {"direction", triple(node.direction)},
            {"hit", hit},
            {"n1", orNull(node.n1)},
            {"n2", orNull(node.n2)},
            {"fresnel", orNull(node.fresnel)},
            {"weight", node.weight},
            {"throughput", triple(node.throughput)},
            {"radiance", triple(node.radiance)},
            {"own", triple(node.own)},
            {"contribution", triple(node.contribution)},
            {"end", endOf(node.end)},
            {"tir", node.tir},
            {"orphan", node.orphan},
            {"line", node.line},
            {"return_line", node.returnLine},
            {"step", node.step},
            {"return_step", node.returnStep}};
}

Json shadowJson(const RayTree::Shadow& shadow)
{
    Json blocker = nullptr;
    if (shadow.blocker) blocker = {{"primitive", shadow.blocker->primitive}, {"point", triple(shadow.blocker->point)}};
    return {{"node", shadow.node},         {"light", shadow.light},     {"direction", triple(shadow.direction)},
            {"distance", shadow.distance}, {"visible", shadow.visible}, {"tint", triple(shadow.tint)},
            {"blocker", blocker},          {"line", shadow.line},       {"step", shadow.step}};
}

Json cappedJson(const RayTree::Capped& capped)
{
    return {{"node", capped.node},
            {"kind", name(capped.kind)},
            {"direction", triple(capped.direction)},
            {"weight", capped.weight},
            {"radiance", triple(capped.radiance)},
            {"reason", name(capped.reason)},
            {"line", capped.line},
            {"step", capped.step}};
}

/// Two levels further to the right, and each array, a triple, on one line.
std::string entryText(const Json& entry)
{
    const std::string text = entry.dump(1, ' ', false, Json::error_handler_t::replace);
    std::string out = "  ";
    bool inString = false, inArray = false;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const char c = text[i];
        if (inString && c == '\\')
        {
            out += c; // and what is escaped, which does not end the string
            out += text[++i];
            continue;
        }
        if (c == '"') inString = !inString;
        if (!inString && (c == '[' || c == ']')) inArray = c == '[';
        const bool isBlank = !inString && (c == '\n' || c == ' ');
        if (!inArray || !isBlank) out += c;
        if (inArray && c == ',') out += ' ';
        if (!inArray && c == '\n') out += "  ";
    }
    return out;
}

template <class Item, class AsJson>
void writeEntries(std::string& out, const char* key, const std::vector<Item>& items, AsJson&& asJson)
{
    out += fmt::format(",\n \"{}\": [", key);
    for (const auto& item : items) out += (&item == items.data() ? "\n" : ",\n") + entryText(asJson(item));
    out += items.empty() ? "]" : "\n ]";
}

} // namespace

std::string toJson(const RayTree& tree)
{
    Json head = {{"version", tree.version},
                 {"lesson", tree.lesson},
                 {"scene", tree.scene},
                 {"source", tree.source},
                 {"real", tree.real}};
    if (tree.pixel)
        head["pixel"] = *tree.pixel;
    else if (!tree.nodes.empty())
        head["ray"] = {{"origin", triple(tree.nodes[0].origin)}, {"direction", triple(tree.nodes[0].direction)}};
    head["max_depth"] = tree.maxDepth;
    std::string out = head.dump(1, ' ', false, Json::error_handler_t::replace);
    out.resize(out.size() - std::string("\n}").size());
    writeEntries(out, "nodes", tree.nodes, [&](const RayTree::Node& node) {
        Json json = nodeJson(node);
        if (tree.isContradicted(node.id)) json["medium"] = *tree.mediumOf(node.id); // derived: not read back
        return json;
    });
    writeEntries(out, "shadows", tree.shadows, shadowJson);
    writeEntries(out, "capped", tree.capped, cappedJson);
    return out + "\n}\n";
}

} // namespace rt
