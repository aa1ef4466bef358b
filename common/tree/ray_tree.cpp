#include "common/tree/ray_tree.h"

#include <fmt/format.h>

namespace rt
{

std::vector<int> RayTree::childrenOf(int node) const
{
    std::vector<int> children;
    for (const auto& candidate : nodes)
        if (candidate.parent == node) children.push_back(candidate.id);
    return children;
}

std::vector<int> RayTree::shadowsOf(int node) const
{
    std::vector<int> found;
    for (std::size_t i = 0; i < shadows.size(); ++i)
        if (shadows[i].node == node) found.push_back(int(i));
    return found;
}

const char* name(RayKind kind)
{
    constexpr const char* names[] = {"camera", "reflected", "transmitted"};
    return names[int(kind)];
}

const char* name(End end)
{
    constexpr const char* names[] = {"none", "absorbed", "miss", "cap", "cutoff", "black"};
    return names[int(end)];
}

template <std::floating_point Real>
Vec3<Real> evaluate(const RayTree& tree)
{
    if (tree.nodes.empty()) return Vec3<Real>(0);
    const auto passedOn = [&](const RayTree::Node& node, double weight, const Vec3<Real>& brought) {
        const Vec3<Real> color = node.hit ? Vec3<Real>(node.hit->color) : Vec3<Real>(1);
        return Real(weight) * (color * brought);
    };
    std::vector<Vec3<Real>> sums;
    sums.reserve(tree.nodes.size());
    for (const auto& node : tree.nodes) sums.emplace_back(node.own);
    for (const auto& capped : tree.capped)
        sums[std::size_t(capped.node)] +=
            passedOn(tree.nodes[std::size_t(capped.node)], capped.weight, Vec3<Real>(capped.radiance));
    // Children come after their parents, so going backwards meets each node when its sum is complete. Two children are
    // the most there are and the sum of two terms does not depend on their order.
    for (std::size_t i = tree.nodes.size(); i-- > 1;)
        if (const int parent = tree.nodes[i].parent; parent >= 0)
            sums[std::size_t(parent)] += passedOn(tree.nodes[std::size_t(parent)], tree.nodes[i].weight, sums[i]);
    return sums[0];
}

template Vec3<float> evaluate<float>(const RayTree&);
template Vec3<double> evaluate<double>(const RayTree&);
template Vec3<long double> evaluate<long double>(const RayTree&);

std::string text(double x)
{
    return fmt::format("{:.5g}", x);
}

std::string text(const Vec3<double>& v)
{
    return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x, v.y, v.z);
}

namespace
{

/// Indentation; a depth that no recursion reaches, as a broken exercise may report, does not fill the memory.
std::string indent(int levels)
{
    return std::string(std::size_t(4 * std::min(levels, 200)), ' ');
}

std::string opening(const RayTree& tree)
{
    const auto lesson = tree.lesson ? fmt::format("lesson {:02}", tree.lesson) : std::string("another tracer");
    const auto where = tree.pixel ? fmt::format("pixel ({}, {})", (*tree.pixel)[0], (*tree.pixel)[1]) : "one ray";
    return fmt::format("{} of {}, {}, {}, MAXDEPTH {}\n\n", where, tree.scene.empty() ? "a scene" : tree.scene, lesson,
                       tree.real, tree.maxDepth);
}

std::string shadowLine(const RayTree::Shadow& shadow)
{
    std::string line = fmt::format("IsVisible( light {}, L = {}, dist = {:.5g} ): ", shadow.light,
                                   text(shadow.direction), shadow.distance);
    if (shadow.visible && shadow.tint != Vec3<double>(1))
        return line + "yes, through glass that lets " + text(shadow.tint) + " pass";
    if (shadow.visible) return line + "yes";
    if (!shadow.blocker) return line + "no";
    return line + fmt::format("no, {} is in the way at {}", shadow.blocker->primitive, text(shadow.blocker->point));
}

/// What stands before this node's Trace in its parent: "0.5 * color (1, 0.9, 0.8) * ".
std::string factor(const RayTree& tree, const RayTree::Node& node)
{
    if (node.parent < 0) return node.orphan ? "orphan, its parent is unknown: " : "";
    std::string before = node.weight == 1 ? "" : fmt::format("{:.5g} * ", node.weight);
    if (const auto& hit = tree.nodes[std::size_t(node.parent)].hit; hit && hit->color != Vec3<double>(1))
        before += fmt::format("{} * ", text(hit->color));
    return before;
}

std::string nodeText(const RayTree& tree, int id)
{
    const auto& node = tree.nodes[std::size_t(id)];
    const std::string outer = indent(node.depth), inner = indent(node.depth + 1);
    std::string out = fmt::format("{}[{}] {}Trace( {} ray, O = {}, D = {} )\n", outer, id, factor(tree, node),
                                  name(node.kind), text(node.origin), text(node.direction));
    if (!node.hit)
        out += inner + "IntersectScene: nothing\n";
    else
        out += fmt::format("{}IntersectScene: {}, t = {:.5g}, I = {}, N = {}{}, mat = {}, color = {}\n", inner,
                           node.hit->primitive, node.hit->t, text(node.hit->point), text(node.hit->normal),
                           node.hit->inside ? " (from inside)" : "", node.hit->material, text(node.hit->color));
    if (node.n1 && node.n2) out += fmt::format("{}n1 = {:.5g}, n2 = {:.5g}", inner, *node.n1, *node.n2);
    if (node.n1 && node.fresnel) out += fmt::format(", Fr = {:.5g}", *node.fresnel);
    if (node.n1) out += node.tir ? ", total internal reflection\n" : "\n";
    if (node.hit && tree.isContradicted(id)) out += fmt::format("{}! {}\n", inner, contradictionText(tree, id));
    return out;
}

} // namespace

std::optional<double> RayTree::mediumOf(int id) const
{
    // What a surface that is no glass reflects stays in the medium in which it came.
    for (const Node* node = &nodes.at(std::size_t(id)); node->parent >= 0;)
    {
        const Node& parent = nodes[std::size_t(node->parent)];
        if (parent.n1 && parent.n2) return node->kind == RayKind::transmitted ? parent.n2 : parent.n1;
        if (node->kind == RayKind::transmitted) break;
        node = &parent;
    }
    return std::nullopt;
}

bool RayTree::isContradicted(int id) const
{
    const auto& node = nodes.at(std::size_t(id));
    if (!node.n1) return false;
    const auto medium = mediumOf(id);
    return medium && *medium != *node.n1;
}

std::string contradictionText(const RayTree& tree, int id)
{
    const auto& node = tree.nodes.at(std::size_t(id));
    return fmt::format(
        "{} says n1 = {:.5g}, but the ray comes through {:.5g}: is its ior_outside right, or that of the "
        "surface before?",
        node.hit->primitive, *node.n1, *tree.mediumOf(id));
}

std::string firstContradiction(const RayTree& tree)
{
    for (const auto& node : tree.nodes)
        if (node.hit && tree.isContradicted(node.id))
            return fmt::format("{}: ray {} of the tree: {}", tree.scene, node.id, contradictionText(tree, node.id));
    return "";
}

std::string toText(const RayTree& tree)
{
    std::string out = opening(tree);
    std::vector<int> open; // nodes whose "return" is still to be written
    const auto close = [&](int depth) {
        while (!open.empty() && tree.nodes[std::size_t(open.back())].depth >= depth)
        {
            const auto& node = tree.nodes[std::size_t(open.back())];
            open.pop_back();
            const char* why = node.end == End::none || node.end == End::absorbed ? "" : name(node.end);
            out += fmt::format("{}return {}{}{}\n", indent(node.depth + 1), text(node.radiance), *why ? "   // " : "",
                               why);
        }
    };
    std::size_t shadow = 0;
    for (const auto& node : tree.nodes)
    {
        close(node.depth);
        out += nodeText(tree, node.id);
        const std::string inner = indent(node.depth + 1);
        for (; shadow < tree.shadows.size() && tree.shadows[shadow].node == node.id; ++shadow)
            out += inner + shadowLine(tree.shadows[shadow]) + "\n";
        if (node.hit && !tree.shadowsOf(node.id).empty())
            out += fmt::format("{}own light, {}color * DirectIllumination( I, N ) = {}\n", inner,
                               tree.childrenOf(node.id).empty() ? "" : "(1 - s) * ", text(node.own));
        for (const auto& stop : tree.capped)
            if (stop.node == node.id)
                out += fmt::format("{}{} ray, D = {}: not followed ({}), {} stands in\n", inner, name(stop.kind),
                                   text(stop.direction), name(stop.reason), text(stop.radiance));
        open.push_back(node.id);
    }
    close(0);
    return out;
}

} // namespace rt
