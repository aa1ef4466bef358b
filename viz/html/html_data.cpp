#include "viz/html/html_data.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/tree/events.h"
#include "viz/state/algorithm_line.h"
#include "viz/state/energy.h"

namespace rt::viz
{

using Json = nlohmann::json;

namespace
{

/// 0 for what is no number, so that it can be compared.
double weightOf(const RayTree::Node& node)
{
    const double weight = largestChannel(node.throughput);
    return std::isfinite(weight) ? weight : 0;
}

std::string shortText(const vec3& v)
{
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z);
}

/// The nodes that the page shows: with a node always its parent.
std::vector<bool> shownNodes(const RayTree& tree)
{
    std::vector<std::size_t> order(tree.nodes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto depth = [&](std::size_t i) { return tree.nodes[i].depth; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depth(a) < depth(b); });
    std::vector<bool> shown(tree.nodes.size(), false);
    for (std::size_t i = 0; i < std::min(order.size(), std::size_t(mostHtmlNodes)); ++i) shown[order[i]] = true;
    // Another tracer's depths need not grow from parent to child.
    for (const auto& node : tree.nodes)
        if (node.parent >= 0 && !shown[std::size_t(node.parent)]) shown[std::size_t(node.id)] = false;
    return shown;
}

/// The heaviest of the shown nodes.
std::vector<bool> explainedNodes(const RayTree& tree, const std::vector<bool>& shown)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (shown[i]) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return weightOf(tree.nodes[a]) > weightOf(tree.nodes[b]); });
    std::vector<bool> explained(tree.nodes.size(), false);
    for (std::size_t i = 0; i < std::min(order.size(), std::size_t(mostExplained)); ++i) explained[order[i]] = true;
    return explained;
}

/// How the ray ended, in a few words; empty if it has children and nothing special happened.
std::string whyItEnds(const RayTree::Node& node, int maxDepth)
{
    std::string why;
    if (node.orphan) why = "An orphan: its parent cannot be told from its depth. ";
    if (node.tir) why += "Total internal reflection: there is no transmitted ray. ";
    switch (node.end)
    {
    case End::none:
        break;
    case End::absorbed:
        why += "The surface sends the ray on nowhere: absorbed.";
        break;
    case End::miss:
        why += "The ray meets nothing.";
        break;
    case End::cap:
        why += fmt::format("The next ray would be deeper than MAXDEPTH = {}: it was not followed.", maxDepth);
        break;
    case End::cutoff:
        why += "The next ray could not have added enough: it was not followed.";
        break;
    case End::black:
        why += "The surface is black: nothing more can come from it.";
        break;
    }
    return why;
}

/// Titles and symbolic forms of formulas, each of them once.
class FormulaNames
{
public:
    Json names = Json::array();

    std::size_t placeOf(const Formula& formula)
    {
        const auto [entry, isNew] = places.try_emplace({formula.title, formula.symbolic}, names.size());
        if (isNew) names.push_back({formula.title, formula.symbolic});
        return entry->second;
    }

private:
    std::map<std::pair<std::string, std::string>, std::size_t> places;
};

Json nodeJson(const HtmlPage& page, const RayTree::Node& node, FormulaNames* names)
{
    Json json = {{"id", node.id},
                 {"parent", node.parent},
                 {"kind", name(node.kind)},
                 {"depth", node.depth},
                 {"weight", shortNumber(largestChannel(node.throughput))},
                 {"end", name(node.end)},
                 {"swatch", hexOf(node.radiance)},
                 {"returned", shortText(node.radiance)},
                 {"added", shortText(node.contribution)},
                 {"share", shortNumber(node.weight)}};
    if (node.hit) json["hit"] = node.hit->primitive;
    if (node.tir) json["tir"] = true;
    if (node.orphan) json["orphan"] = true;
    if (const auto why = whyItEnds(node, page.tree.maxDepth); !why.empty()) json["note"] = why;
    if (!names) return json;
    json["formulas"] = Json::array();
    for (const auto& formula : explainNode(page.tree, page.scene, page.formulas, node.id))
        json["formulas"].push_back({names->placeOf(formula), formula.numbers});
    return json;
}

/// For each depth: how many rays, and the brightness of what they carry and of what they add to the pixel.
Json energyJson(const RayTree& tree)
{
    constexpr std::size_t mostDepths = 64;
    const auto energy = energyPerDepth(tree);
    Json depths = Json::array();
    for (const auto& level : grouped(energy, mostDepths))
        depths.push_back({{"depth", level.depth},
                          {"rays", level.rays},
                          {"weight", shortNumber(luminance(level.weight))},
                          {"gathered", shortNumber(luminance(level.gathered))}});
    return {{"depths", depths},
            {"grouped", energy.depths.size() > mostDepths},
            {"broken", energy.broken},
            {"share", shareText(energy)}};
}

/// The lists of the tree without what hangs on nodes that are not shown; events name places in these lists.
class TreeJson
{
public:
    TreeJson(const HtmlPage& described, const Listing& listing, Json& target)
        : page(described), tree(page.tree), json(target), algorithm(listing)
    {
    }

    void write()
    {
        shown = shownNodes(tree);
        const auto explained = explainedNodes(tree, shown);
        FormulaNames names;
        json["nodes"] = Json::array();
        for (const auto& node : tree.nodes)
            if (isShown(node.id))
            {
                json["nodes"].push_back(nodeJson(page, node, explained[std::size_t(node.id)] ? &names : nullptr));
                json["nodes"].back()["line"] = algorithm.of(node.line, Told::value);
            }
        json["formulas"] = names.names;
        json["hidden"] = tree.nodes.size() - json["nodes"].size();
        json["unexplained"] =
            std::count(shown.begin(), shown.end(), true) - std::count(explained.begin(), explained.end(), true);
        writeShadows();
        writeCapped();
        writeEvents();
    }

private:
    const HtmlPage& page;
    const RayTree& tree;
    Json& json;
    AlgorithmLines algorithm;
    std::vector<bool> shown;
    std::vector<std::size_t> shadowPlace, cappedPlace;

    bool isShown(int node) const { return shown[std::size_t(node)]; }

    void writeShadows()
    {
        json["shadows"] = Json::array();
        for (const auto& shadow : tree.shadows)
        {
            shadowPlace.push_back(json["shadows"].size());
            if (!isShown(shadow.node)) continue;
            json["shadows"].push_back({{"node", shadow.node},
                                       {"light", shadow.light},
                                       {"visible", shadow.visible},
                                       {"blocker", shadow.blocker ? Json(shadow.blocker->primitive) : Json(nullptr)}});
        }
    }

    void writeCapped()
    {
        json["capped"] = Json::array();
        for (const auto& capped : tree.capped)
        {
            cappedPlace.push_back(json["capped"].size());
            if (!isShown(capped.node)) continue;
            json["capped"].push_back(
                {{"node", capped.node}, {"kind", name(capped.kind)}, {"reason", name(capped.reason)}});
        }
    }

    void writeEvents()
    {
        json["events"] = Json::array();
        for (const auto& event : eventsOf(tree))
        {
            if (!isShown(event.node)) continue;
            const auto& places = event.kind == Event::Kind::shadow ? shadowPlace : cappedPlace;
            const Json place = event.index < 0 ? Json(-1) : Json(places[std::size_t(event.index)]);
            json["events"].push_back({int(event.kind), event.node, place, algorithm.of(event), describe(tree, event)});
        }
    }
};

Json drawingJson(const RayDrawing& drawing)
{
    Json segments = Json::array(), blockers = Json::array();
    for (const auto& s : drawing.segments)
    {
        const int flags = int(s.hasHead) + 2 * int(s.fades) + 4 * int(s.notTraced());
        segments.push_back({int(s.role), s.node, s.light, shortTriple(s.from), shortTriple(s.to), shortNumber(s.weight),
                            flags, s.notTraced() ? (s.stopped == End::cutoff ? "cutoff" : "MAXDEPTH") : ""});
    }
    for (const auto& blocker : drawing.blockers)
        blockers.push_back({blocker.node, blocker.light, shortTriple(blocker.point)});
    return {{"segments", segments},
            {"blockers", blockers},
            {"nodes", drawing.nodes},
            {"size", shortNumber(drawing.size)},
            {"lightRadius", shortNumber(lightRadius(drawing))}};
}

} // namespace

Json shortNumber(double x)
{
    if (!std::isfinite(x)) return nullptr;
    if (x == std::floor(x) && std::abs(x) < 1e6) return Json(int(x));
    return Json(std::stod(fmt::format("{:.6g}", x)));
}

Json shortTriple(const vec3& v)
{
    return {shortNumber(v.x), shortNumber(v.y), shortNumber(v.z)};
}

std::string hex(const Rgba& color)
{
    return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

std::string hexOf(const vec3& linear)
{
    if (!isFinite(linear)) return "";
    return hex({toSrgb8(linear.x), toSrgb8(linear.y), toSrgb8(linear.z)});
}

Json htmlData(const HtmlPage& page)
{
    const auto& tree = page.tree;
    const Extent objects = extentOf(page.scene, page.tree);
    const auto drawing = drawRays(tree, page.scene, objects);
    Json json = {{"title", page.title},
                 {"scene", page.scene.title},
                 {"sceneFile", std::filesystem::path(tree.scene).filename().string()},
                 {"real", tree.real},
                 {"maxDepth", tree.maxDepth},
                 {"size", {page.scene.camera.width, page.scene.camera.height}},
                 {"pixel", tree.pixel ? Json(*tree.pixel) : Json(nullptr)},
                 {"source", {{"file", tree.source}, {"text", page.sourceText}, {"hidden", Json::array()}}},
                 {"energy", energyJson(tree)},
                 {"drawing", drawingJson(drawing)},
                 {"objects", htmlObjects(page.scene, drawing, objects)}};
    const auto listing = listingOf(page.sourceText);
    for (std::size_t i = 0; i < listing.lines.size(); ++i)
        if (isExerciseMark(listing.lines[i])) json["source"]["hidden"].push_back(i + 1);
    TreeJson(page, listing, json).write();
    return json;
}

} // namespace rt::viz
