#include "common/explain.h"

#include <fmt/format.h>

namespace rt
{

namespace
{

std::string text(double x)
{
    return fmt::format("{:.5g}", x);
}

std::string text(const Vec3<double>& v)
{
    return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x, v.y, v.z);
}

/// The normal on the side that the ray came from.
Vec3<double> facing(const RayTree::Hit& hit)
{
    return hit.inside ? -hit.normal : hit.normal;
}

Formula hitPoint(const RayTree::Node& node)
{
    if (!node.hit)
        return {"Intersection", "P(t) = O + tD",
                fmt::format("no t > 0 meets the scene; the ray returns {}", text(node.radiance))};
    return {"Intersection", "I = O + tD",
            fmt::format("{} + {} {} = {}\non {}, material {}{}", text(node.origin), text(node.hit->t),
                        text(node.direction), text(node.hit->point), node.hit->primitive, node.hit->material,
                        node.hit->inside ? ", from inside" : "")};
}

Formula directLight(const RayTree::Shadow& shadow, const Light<double>& light, const Vec3<double>& N)
{
    Formula formula{fmt::format("Direct light {}", shadow.light), "lightColor * max(0, N.L) / dist²", ""};
    formula.numbers = fmt::format("L = {}, dist = {}\n", text(shadow.direction), text(shadow.distance));
    if (!shadow.visible)
    {
        formula.numbers += shadow.blocker ? fmt::format("not visible: {} is in the way at {}",
                                                        shadow.blocker->primitive, text(shadow.blocker->point))
                                          : "not visible";
        return formula;
    }
    const double cosine = dot(N, shadow.direction), attenuation = 1 / (shadow.distance * shadow.distance);
    formula.numbers += fmt::format("{} * max(0, {}) * {} = {}", text(light.color), text(cosine), text(attenuation),
                                   text(light.color * std::max(0.0, cosine) * attenuation));
    return formula;
}

Formula reflection(const RayTree::Node& node, const RayTree::Node& child)
{
    const Vec3<double> N = facing(*node.hit), A = dot(node.direction, N) * N, B = node.direction - A;
    return {"Reflected vector", "A = (D.N)N,  B = D - A,  R = B - A = D - 2(D.N)N",
            fmt::format("D.N = {}\nA = {}\nB = {}\nR = {}", text(dot(node.direction, N)), text(A), text(B),
                        text(child.direction))};
}

/// "color * Trace(1)" for each child, and what came of it.
Formula sum(const RayTree& tree, const RayTree::Node& node)
{
    Formula formula{"Colour", "", ""};
    const auto term = [&](double weight, const std::string& symbol, const Vec3<double>& brought) {
        const std::string share = weight == 1 ? "" : text(weight) + " * ";
        formula.symbolic +=
            fmt::format("{}{}material color * {}", formula.symbolic.empty() ? "" : " + ", share, symbol);
        formula.numbers += fmt::format("{}{}{} * {}", formula.numbers.empty() ? "" : " + ", share,
                                       text(node.hit->color), text(brought));
    };
    if (node.own != Vec3<double>(0))
    {
        formula.symbolic = "own light";
        formula.numbers = text(node.own);
    }
    for (const int child : tree.childrenOf(node.id))
        term(tree.nodes[std::size_t(child)].weight, fmt::format("Trace([{}])", child),
             tree.nodes[std::size_t(child)].radiance);
    for (const auto& capped : tree.capped)
        if (capped.node == node.id) term(capped.weight, "(not followed)", capped.radiance);
    if (formula.symbolic.empty()) formula.symbolic = "material color * DirectIllumination";
    formula.numbers += fmt::format("{}= {}", formula.numbers.empty() ? "" : " ", text(node.radiance));
    return formula;
}

Formula contribution(const RayTree::Node& node)
{
    return {"Contribution to the pixel", "throughput * own light",
            fmt::format("{} * {} = {}", text(node.throughput), text(node.own), text(node.contribution))};
}

} // namespace

std::vector<Formula> explainNode(const RayTree& tree, const SceneDescription& scene, int id)
{
    const auto& node = tree.nodes.at(std::size_t(id));
    std::vector<Formula> formulas{hitPoint(node)};
    if (node.hit)
    {
        for (const int index : tree.shadowsOf(id))
            if (const auto& shadow = tree.shadows[std::size_t(index)]; std::size_t(shadow.light) < scene.lights.size())
                formulas.push_back(directLight(shadow, scene.lights[std::size_t(shadow.light)], facing(*node.hit)));
        for (const int child : tree.childrenOf(id))
            if (tree.nodes[std::size_t(child)].kind == RayKind::reflected)
                formulas.push_back(reflection(node, tree.nodes[std::size_t(child)]));
        formulas.push_back(sum(tree, node));
    }
    formulas.push_back(contribution(node));
    return formulas;
}

std::string explain(const RayTree& tree, const SceneDescription& scene)
{
    std::string out;
    for (const auto& node : tree.nodes)
    {
        out += fmt::format("[{}] {} ray, depth {}\n", node.id, name(node.kind), node.depth);
        for (const auto& formula : explainNode(tree, scene, node.id))
        {
            out += fmt::format("    {}: {}\n        ", formula.title, formula.symbolic);
            for (const char c : formula.numbers) out += c == '\n' ? "\n        " : std::string(1, c);
            out += '\n';
        }
        out += '\n';
    }
    return out;
}

} // namespace rt
