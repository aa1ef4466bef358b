#include "tests/grade/questions/question.h"

#include "lessons/programs/registry.h"

namespace rt::grade
{

namespace
{

/// "first, second": a node's children reflected first; equal kinds in the order in which they were followed.
std::vector<int> sortedChildren(const RayTree& tree, int node)
{
    auto children = tree.childrenOf(node);
    std::stable_sort(children.begin(), children.end(),
                     [&](int a, int b) { return tree.nodes[std::size_t(a)].kind < tree.nodes[std::size_t(b)].kind; });
    return children;
}

constexpr std::size_t mostNodes = 200; // of a tree that is compared: a wrong one may have thousands

struct TreeReader
{
    const RayTree& tree;
    Answer& answer;
    std::size_t seen = 0;

    void add(const std::string& name, double value)
    {
        answer.names.push_back(name);
        answer.values.push_back(value);
    }
    void add(const std::string& name, const V& value)
    {
        for (const int axis : {0, 1, 2}) add(name + (axis == 0 ? ".x" : axis == 1 ? ".y" : ".z"), value[axis]);
    }

    void read(int id, const std::string& path)
    {
        if (++seen > mostNodes) return;
        const auto& node = tree.nodes[std::size_t(id)];
        const auto name = [&](const char* field) { return path + ": " + field; };
        add(name("depth"), node.depth);
        add(name("direction"), node.direction);
        add(name("share"), node.weight);
        add(name("meets something"), node.hit.has_value());
        add(name("n1"), node.n1.value_or(0));
        add(name("n2"), node.n2.value_or(0));
        add(name("total internal reflection"), node.tir);
        add(name("end"), int(node.end));
        const auto shadows = tree.shadowsOf(id);
        add(name("shadow rays"), double(shadows.size()));
        for (const int index : shadows)
        {
            const auto& shadow = tree.shadows[std::size_t(index)];
            const auto lamp = fmt::format("{}: lamp {}", path, shadow.light);
            add(lamp + " visible", shadow.visible);
            add(lamp + ", distance", shadow.distance);
        }
        for (const auto kind : {RayKind::reflected, RayKind::transmitted})
            for (const auto& capped : tree.capped)
                if (capped.node == id && capped.kind == kind)
                {
                    add(name("not followed, why"), int(capped.reason));
                    add(name("not followed, its stand-in"), capped.radiance);
                }
        add(name("colour"), node.radiance);
        add(name("adds"), node.contribution);
        for (const int child : sortedChildren(tree, id))
            read(child, path + " > " + rt::name(tree.nodes[std::size_t(child)].kind));
    }
};

/// What must not hang on rounding: how the tree branches and why it ends.
std::string shapeOf(const RayTree& tree)
{
    std::string shape;
    for (const auto& node : tree.nodes)
        shape += fmt::format("{}{}{}{}{};", node.parent, int(node.kind), int(node.end), node.tir,
                             node.hit ? node.hit->primitive : "-");
    for (const auto& shadow : tree.shadows) shape += fmt::format("{}{};", shadow.node, shadow.visible);
    for (const auto& capped : tree.capped) shape += fmt::format("{}{};", capped.node, int(capped.reason));
    return shape;
}

bool close(const Question& question, double expected, double got)
{
    return std::isfinite(expected) && std::isfinite(got) &&
           std::abs(got - expected) <= question.tolerance.absolute + question.tolerance.relative * std::abs(expected);
}

/// Rays beside this one branch alike, and float gives the same numbers.
std::function<bool(int)> safety(const SceneDescription& scene, const V& origin, const V& direction)
{
    return [scene, origin, direction](int lesson) {
        const auto* entry = findLesson(lesson);
        const auto tree = entry->inspect(scene, Precision::doubled, GivenRay{origin, direction});
        const V aside(3e-5, -2e-5, 2.5e-5);
        for (const V& shift : {aside, -aside, V(aside.y, aside.z, -aside.x)})
            if (shapeOf(entry->inspect(scene, Precision::doubled,
                                       GivenRay{origin, glm::normalize(direction) + shift})) != shapeOf(tree))
                return false;
        const auto single = entry->inspect(scene, Precision::floating, GivenRay{origin, direction});
        Question half;
        half.tolerance = {forTraces.absolute / 4, forTraces.relative / 4};
        return !firstWrong(half, numbers(tree), numbers(single));
    };
}

} // namespace

Answer numbers(const RayTree& tree)
{
    Answer answer;
    TreeReader reader{tree, answer};
    reader.add("rays", double(tree.nodes.size()));
    for (const auto& node : tree.nodes) // more than one root: rays that the student made by hand
        if (node.parent < 0) reader.read(node.id, node.id == 0 ? name(node.kind) : "a ray that begins anew");
    return answer;
}

std::optional<std::size_t> firstWrong(const Question& question, const Answer& expected, const Answer& got)
{
    for (std::size_t i = 0; i < std::max(expected.values.size(), got.values.size()); ++i)
        if (i >= expected.values.size() || i >= got.values.size() ||
            !close(question, expected.values[i], got.values[i]))
            return i;
    return std::nullopt;
}

std::string text(const Question& question, const Answer& answer, std::size_t at)
{
    const auto& x = answer.values;
    const auto vector = [&](std::size_t from) { return cases::text(V(x[from], x[from + 1], x[from + 2])); };
    if (question.shape == Shape::number && x.size() == 1) return cases::text(x[0]);
    if (question.shape == Shape::distance && x.size() == 1) return x[0] == -1 ? "a miss" : cases::text(x[0]);
    if (question.shape == Shape::vector && x.size() == 3) return vector(0);
    if (question.shape == Shape::transmits && x.size() == 1) return "nothing";
    if (question.shape == Shape::transmits && x.size() == 4) return vector(1);
    if (at >= x.size()) return "no more";
    return (at < answer.names.size() ? answer.names[at] + " = " : "") + cases::text(x[at]);
}

std::optional<double> degreesBetween(const Question& question, const Answer& expected, const Answer& got)
{
    const std::size_t from = question.shape == Shape::transmits ? 1 : 0, size = from + 3;
    if (question.shape != Shape::vector && question.shape != Shape::transmits) return std::nullopt;
    if (expected.values.size() != size || got.values.size() != size) return std::nullopt;
    const auto direction = [&](const Answer& a) {
        return unit(V(a.values[from], a.values[from + 1], a.values[from + 2]));
    };
    const V a = direction(expected), b = direction(got);
    if (!isFinite(b) || a == V(0) || b == V(0)) return std::nullopt;
    return std::atan2(glm::length(cross(a, b)), dot(a, b)) * 180 / std::acos(-1.0);
}

Question askColor(const std::string& what, const SceneDescription& scene, const V& origin, const V& direction)
{
    const auto ask = [scene, origin, direction](const Candidate& candidate) {
        const V color = candidate.tracer.color(scene, origin, direction);
        return Answer{{color.x, color.y, color.z}, {"red", "green", "blue"}};
    };
    return {fmt::format("{}: colour that the ray from {} along {} sees", what, text(origin), text(direction)),
            Shape::numbers, forTraces, ask, safety(scene, origin, direction)};
}

Question askTree(const std::string& what, const SceneDescription& scene, const V& origin, const V& direction)
{
    const auto ask = [scene, origin, direction](const Candidate& candidate) {
        return numbers(candidate.tracer.tree(scene, origin, direction));
    };
    return {fmt::format("{}: ray tree of the ray from {} along {}", what, text(origin), text(direction)),
            Shape::numbers, forTraces, ask, safety(scene, origin, direction)};
}

std::vector<Criterion> questionCriteria(int lesson)
{
    switch (lesson)
    {
    case 0:
        return geometryCriteria();
    case 1:
        return directCriteria();
    case 2:
        return mirrorCriteria();
    case 3:
        return partialCriteria();
    case 4:
        return skyCriteria();
    case 5:
        return refractionCriteria();
    case 6:
        return fresnelCriteria();
    case 7:
        return capCriteria();
    case 8:
        return phongCriteria();
    default:
        return {};
    }
}

} // namespace rt::grade
