#include "common/tree/explain.h"

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "common/base/todo.h"

namespace rt
{

namespace
{

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

/// An exercise may not have written the function that a formula needs: then its id stands in for the numbers.
template <class Make>
void add(std::vector<Formula>& formulas, const char* title, Make&& make)
{
    try
    {
        formulas.push_back(make());
    }
    catch (const NotAttempted& missing)
    {
        formulas.push_back({title, "", "not attempted: " + missing.id});
    }
}

/// What the material of the node's surface is, or null if the scene has none of that name.
const Material<double>* materialOf(const RayTree::Node& node, const SceneDescription& scene)
{
    for (const auto& material : scene.materials)
        if (node.hit && material.name == node.hit->material) return &material;
    return nullptr;
}

/// (1 - f)(N.L) + f (V.R)^alpha with its numbers, for a glossy material.
std::string phongText(const Vec3<double>& L, const Vec3<double>& N, const Vec3<double>& V, const Material<double>& mat,
                      double value)
{
    const double NL = dot(N, L), f = mat.glossy;
    const Vec3<double> R = 2 * NL * N - L;
    return fmt::format("R = 2(N.L)N - L = {}, V = -D = {}, V.R = {}\n(1 - {}) * {} + {} * {}^{} = {}\n", text(R),
                       text(V), text(dot(V, R)), text(f), text(NL), text(f), text(std::clamp(dot(V, R), 0.0, 1.0)),
                       text(mat.exponent), text(value));
}

double shadingOf(const RayTree::Shadow& shadow, const RayTree::Node& node, const SceneDescription& scene,
                 const LectureFormulas& lecture)
{
    const auto* mat = materialOf(node, scene);
    return lecture.phong(shadow.direction, facing(*node.hit), -node.direction, mat ? *mat : Material<double>());
}

/// What a lamp sends to the point.
Vec3<double> arriving(const RayTree::Shadow& shadow, const Light<double>& light, double shading)
{
    return shadow.tint * light.color * shading / (shadow.distance * shadow.distance);
}

Formula directLight(const RayTree::Shadow& shadow, const Light<double>& light, const RayTree::Node& node,
                    const SceneDescription& scene, const LectureFormulas& lecture)
{
    const Vec3<double> N = facing(*node.hit);
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
    const auto* mat = materialOf(node, scene);
    const double shading = shadingOf(shadow, node, scene, lecture);
    std::string factor = fmt::format("max(0, {})", text(cosine));
    if (mat && mat->glossy > 0)
    {
        formula.symbolic = "lightColor * ((1 - f)(N.L) + f (V.R)^alpha) / dist²";
        formula.numbers += phongText(shadow.direction, N, -node.direction, *mat, shading);
        factor = text(shading);
    }
    std::string tint;
    if (shadow.tint != Vec3<double>(1))
    {
        formula.symbolic = "tint * " + formula.symbolic;
        tint = text(shadow.tint) + " * ";
    }
    formula.numbers += fmt::format("{}{} * {} * {} = {}", tint, text(light.color), factor, text(attenuation),
                                   text(arriving(shadow, light, shading)));
    return formula;
}

Formula reflection(const RayTree::Node& node, const RayTree::Node& child)
{
    const Vec3<double> N = facing(*node.hit), A = dot(node.direction, N) * N, B = node.direction - A;
    return {"Reflected vector", "A = (D.N)N,  B = D - A,  R = B - A = D - 2(D.N)N",
            fmt::format("D.N = {}\nA = {}\nB = {}\nR = {}", text(dot(node.direction, N)), text(A), text(B),
                        text(child.direction))};
}

Formula snell(double n1, double n2, double cos1, double k)
{
    const double sin1 = std::sqrt(std::max(0.0, 1 - cos1 * cos1)), sin2 = n1 / n2 * sin1;
    const auto angle = [](double sine) { return glm::degrees(std::asin(std::min(1.0, sine))); };
    Formula formula{"Snell's law", "n1 sin1 = n2 sin2,  k = 1 - (n1/n2)² (1 - cos²1)", ""};
    formula.numbers = fmt::format("n1 = {}, n2 = {}, cos1 = -N.D = {}, angle 1 = {} degrees\nsin2 = {}, k = {}",
                                  text(n1), text(n2), text(cos1), text(angle(sin1)), text(sin2), text(k));
    formula.numbers +=
        k < 0 ? fmt::format("\nk < 0: total internal reflection (critical angle {} degrees)", text(angle(n2 / n1)))
              : fmt::format("\nangle 2 = {} degrees", text(angle(sin2)));
    return formula;
}

/// How much is reflected, exactly and after Schlick; `used` is what the lesson took.
Formula shares(double n1, double n2, double cos1, double k, double used, const LectureFormulas& lecture)
{
    Formula formula{"Fresnel", "Fr = (rs² + rp²)/2,  Ft = 1 - Fr", ""};
    const double exact = lecture.fresnel(cos1, n1, n2), approximate = lecture.schlick(cos1, n1, n2);
    if (k >= 0 && n1 != n2)
    {
        const double cos2 = std::sqrt(k);
        formula.numbers = fmt::format("rs = (n1 cos1 - n2 cos2)/(n1 cos1 + n2 cos2) = {}\nrp = (n1 cos2 - n2 cos1)/(n1 "
                                      "cos2 + n2 cos1) = {}\n",
                                      text((n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2)),
                                      text((n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1)));
    }
    formula.numbers += fmt::format("Fr = {}, Schlick {}, difference {}; used {}, Ft = {}", text(exact),
                                   text(approximate), text(approximate - exact), text(used), text(1 - used));
    return formula;
}

/// At the boundary of two media; what the lecture's functions do not have yet is left out.
void addBoundary(std::vector<Formula>& formulas, const RayTree& tree, const RayTree::Node& node,
                 const LectureFormulas& lecture)
{
    if (!lecture.cosSquared2) return;
    const double n1 = *node.n1, n2 = *node.n2, cos1 = -dot(node.direction, facing(*node.hit));
    double k = -1;
    add(formulas, "Snell's law", [&] { return snell(n1, n2, cos1, k = lecture.cosSquared2(cos1, n1, n2)); });
    if (node.fresnel && lecture.fresnel && lecture.schlick)
        add(formulas, "Fresnel", [&] { return shares(n1, n2, cos1, k, *node.fresnel, lecture); });
    for (const int child : tree.childrenOf(node.id))
        if (const auto& next = tree.nodes[std::size_t(child)]; next.kind == RayKind::transmitted && k >= 0)
            formulas.push_back(
                {"Transmitted vector", "T = n1/n2 D + (n1/n2 cos1 - sqrt(k)) N",
                 fmt::format("{} * {} + ({}) * {} = {}", text(n1 / n2), text(node.direction),
                             text(n1 / n2 * cos1 - std::sqrt(k)), text(facing(*node.hit)), text(next.direction))});
}

/// What the point itself sends: the share that is not mirrored, times its colour, times the light that arrives.
void addOwnLight(Formula& formula, const RayTree& tree, const RayTree::Node& node, const SceneDescription& scene,
                 const LectureFormulas& lecture)
{
    const auto shadows = tree.shadowsOf(node.id);
    const auto* mat = materialOf(node, scene);
    if (shadows.empty() || !mat)
    {
        formula.symbolic = "own light";
        formula.numbers = text(node.own);
        return;
    }
    Vec3<double> direct(0);
    for (const int index : shadows)
        if (const auto& shadow = tree.shadows[std::size_t(index)];
            shadow.visible && std::size_t(shadow.light) < scene.lights.size())
            direct +=
                arriving(shadow, scene.lights[std::size_t(shadow.light)], shadingOf(shadow, node, scene, lecture));
    const bool isPart = mat->mirror > 0;
    formula.symbolic = fmt::format("{}material color * DirectIllumination", isPart ? "(1 - s) * " : "");
    formula.numbers = fmt::format("{}{} * {}", isPart ? fmt::format("(1 - {}) * ", text(mat->mirror)) : "",
                                  text(node.hit->color), text(direct));
}

/// "color * Trace(1)" for each child, and what came of it.
Formula sum(const RayTree& tree, const RayTree::Node& node, const SceneDescription& scene,
            const LectureFormulas& lecture)
{
    Formula formula{"Colour", "", ""};
    const auto term = [&](double weight, const std::string& symbol, const Vec3<double>& brought) {
        const std::string share = weight == 1 ? "" : text(weight) + " * ";
        formula.symbolic +=
            fmt::format("{}{}material color * {}", formula.symbolic.empty() ? "" : " + ", share, symbol);
        formula.numbers += fmt::format("{}{}{} * {}", formula.numbers.empty() ? "" : " + ", share,
                                       text(node.hit->color), text(brought));
    };
    if (node.own != Vec3<double>(0) || (node.end != End::none && !tree.shadowsOf(node.id).empty()))
        addOwnLight(formula, tree, node, scene, lecture);
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

std::vector<Formula> explainNode(const RayTree& tree, const SceneDescription& scene, const LectureFormulas& lecture,
                                 int id)
{
    const auto& node = tree.nodes.at(std::size_t(id));
    std::vector<Formula> formulas{hitPoint(node)};
    if (node.hit)
    {
        for (const int index : tree.shadowsOf(id))
            if (const auto& shadow = tree.shadows[std::size_t(index)]; std::size_t(shadow.light) < scene.lights.size())
                add(formulas, "Direct light",
                    [&] { return directLight(shadow, scene.lights[std::size_t(shadow.light)], node, scene, lecture); });
        if (tree.isContradicted(id))
            formulas.push_back({"Media that contradict", "n1 = n2 of the surface before", contradictionText(tree, id)});
        if (node.n1 && node.n2) addBoundary(formulas, tree, node, lecture);
        for (const int child : tree.childrenOf(id))
            if (tree.nodes[std::size_t(child)].kind == RayKind::reflected)
                formulas.push_back(reflection(node, tree.nodes[std::size_t(child)]));
        add(formulas, "Colour", [&] { return sum(tree, node, scene, lecture); });
    }
    formulas.push_back(contribution(node));
    return formulas;
}

std::string explain(const RayTree& tree, const SceneDescription& scene, const LectureFormulas& lecture)
{
    std::string out;
    for (const auto& node : tree.nodes)
    {
        out += fmt::format("[{}] {} ray, depth {}\n", node.id, name(node.kind), node.depth);
        for (const auto& formula : explainNode(tree, scene, lecture, node.id))
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
