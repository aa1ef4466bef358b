#include "common/tree/tree_compare.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

namespace rt
{

namespace
{

/// Remembers the first difference that it is told of.
class NodeComparison
{
public:
    explicit NodeComparison(const TreeTolerance& accepted) : tolerance(accepted) {}

    std::optional<TreeDifference> first;

    void number(const char* field, double expected, double got, double scale = 0)
    {
        if (!first && !close(expected, got, scale)) numbersDiffer(field, {expected}, {got});
    }

    void number(const char* field, const std::optional<double>& expected, const std::optional<double>& got)
    {
        if (expected && got) return number(field, *expected, *got);
        const auto text = [](const std::optional<double>& x) { return x ? fmt::format("{:.5g}", *x) : "nothing"; };
        if (expected.has_value() != got.has_value()) differ(field, text(expected), text(got));
    }

    void vector(const char* field, const Vec3<double>& expected, const Vec3<double>& got, double scale = 0)
    {
        const auto agree = [&](int c) { return close(expected[c], got[c], scale); };
        if (first || (agree(0) && agree(1) && agree(2))) return;
        numbersDiffer(field, {expected.x, expected.y, expected.z}, {got.x, got.y, got.z});
    }

    void direction(const char* field, const Vec3<double>& expected, const Vec3<double>& got)
    {
        const bool before = first.has_value();
        vector(field, expected, got, 1);
        if (before || !first) return;
        const double angle = std::atan2(length(cross(expected, got)), dot(expected, got));
        constexpr double degrees = 180 / std::numbers::pi;
        if (std::isfinite(angle) && dot(expected, expected) > 0 && dot(got, got) > 0) first->angle = angle * degrees;
    }

    template <class Value>
    void same(const char* field, const Value& expected, const Value& got)
    {
        if (!first && expected != got) differ(field, text(expected), text(got));
    }

    /// True if both met something. One that met nothing, which is then called `nothing`, differs from one that did.
    template <class Met>
    bool bothMet(const char* field, const std::optional<Met>& expected, const std::optional<Met>& got,
                 const std::string& nothing)
    {
        const auto text = [&](const std::optional<Met>& met) { return met ? met->primitive : nothing; };
        if (expected.has_value() != got.has_value()) differ(field, text(expected), text(got));
        return expected && got;
    }

    void differ(const char* field, const std::string& expected, const std::string& got)
    {
        if (first) return;
        first.emplace();
        first->field = field;
        first->expected = expected;
        first->got = got;
    }

private:
    TreeTolerance tolerance;

    bool close(double a, double b, double scale) const
    {
        if (a == b || (std::isnan(a) && std::isnan(b))) return true;
        if (!std::isfinite(a) || !std::isfinite(b)) return false;
        const double size = std::isfinite(scale) ? std::max({scale, std::abs(a), std::abs(b)}) : std::abs(a);
        return std::abs(a - b) <= tolerance.absolute + tolerance.relative * size;
    }

    void numbersDiffer(const char* field, const std::vector<double>& expected, const std::vector<double>& got)
    {
        for (const int digits : {4, 6, 9, 17})
        {
            differ(field, text(expected, digits), text(got, digits));
            if (digits == 17 || first->expected != first->got) return;
            first.reset();
        }
    }

    static std::string text(const std::vector<double>& numbers, int digits)
    {
        std::string out;
        for (const double x : numbers) out += fmt::format("{}{:.{}g}", out.empty() ? "" : ", ", x, digits);
        return numbers.size() == 1 ? out : "(" + out + ")";
    }
    static std::string text(bool value) { return value ? "yes" : "no"; }
    static std::string text(int value) { return std::to_string(value); }
    static std::string text(RayKind kind) { return name(kind); }
    static std::string text(End end) { return end == End::none ? "rays that go on" : name(end); }
    static std::string text(const std::string& value) { return value.empty() ? "no name" : value; }
};

/// How large the numbers are that positions on this ray are computed from.
double reach(const RayTree::Node& node)
{
    const auto largest = [](const Vec3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
    const double origin = largest(node.origin);
    return node.hit ? std::max({origin, largest(node.hit->point), std::abs(node.hit->t)}) : origin;
}

} // namespace

std::optional<TreeDifference> compareFollowed(const RayTree::Node& expected, const RayTree::Node& got,
                                              const TreeTolerance& tolerance)
{
    NodeComparison is(tolerance);
    const double size = reach(expected);
    is.same("kind", expected.kind, got.kind);
    is.same("depth", expected.depth, got.depth);
    is.same("orphan", expected.orphan, got.orphan);
    is.vector("origin", expected.origin, got.origin, size);
    is.direction("direction", expected.direction, got.direction);
    is.number("weight", expected.weight, got.weight);
    is.vector("throughput", expected.throughput, got.throughput);
    if (is.bothMet("hit", expected.hit, got.hit, "nothing"))
    {
        const auto &e = *expected.hit, &g = *got.hit;
        is.same("hit.primitive", e.primitive, g.primitive);
        is.number("hit.t", e.t, g.t, size);
        is.vector("hit.point", e.point, g.point, size);
        is.direction("hit.normal", e.normal, g.normal);
        is.same("hit.inside", e.inside, g.inside);
        is.same("hit.material", e.material, g.material);
        is.vector("hit.color", e.color, g.color);
    }
    is.number("n1", expected.n1, got.n1);
    is.number("n2", expected.n2, got.n2);
    is.number("fresnel", expected.fresnel, got.fresnel);
    return is.first;
}

std::optional<TreeDifference> compareOwn(const RayTree::Node& expected, const RayTree::Node& got,
                                         const TreeTolerance& tolerance)
{
    NodeComparison is(tolerance);
    is.vector("own", expected.own, got.own);
    return is.first;
}

std::optional<TreeDifference> compareReturned(const RayTree::Node& expected, const RayTree::Node& got,
                                              const TreeTolerance& tolerance)
{
    NodeComparison is(tolerance);
    const auto returned = [](const RayTree::Node& node) {
        return neverReturned(node) ? std::string("nothing: it did not return") : shortText(node.radiance);
    };
    if (expected.step > 0 && got.step > 0 && neverReturned(expected) != neverReturned(got))
        is.differ("return", returned(expected), returned(got));
    is.same("tir", expected.tir, got.tir);
    is.same("end", expected.end, got.end);
    is.vector("radiance", expected.radiance, got.radiance);
    is.vector("own", expected.own, got.own); // of a recorder that infers it from the radiance
    is.vector("contribution", expected.contribution, got.contribution);
    return is.first;
}

std::optional<TreeDifference> compareBrought(const RayTree::Node& expected, const RayTree::Node& got,
                                             const TreeTolerance& tolerance)
{
    NodeComparison is(tolerance);
    is.number("weight", expected.weight, got.weight);
    is.vector("radiance", expected.radiance, got.radiance);
    return is.first;
}

std::optional<TreeDifference> compareShadows(const RayTree::Shadow& expected, const RayTree::Shadow& got,
                                             const RayTree::Node& from, const TreeTolerance& tolerance)
{
    NodeComparison is(tolerance);
    const double size = std::max(reach(from), std::abs(expected.distance));
    is.direction("direction", expected.direction, got.direction);
    is.number("distance", expected.distance, got.distance, size);
    is.same("visible", expected.visible, got.visible);
    if (is.bothMet("blocker", expected.blocker, got.blocker, "nothing in the way"))
    {
        is.same("blocker.primitive", expected.blocker->primitive, got.blocker->primitive);
        is.vector("blocker.point", expected.blocker->point, got.blocker->point, size);
    }
    is.vector("tint", expected.tint, got.tint);
    is.same("light", expected.light, got.light);
    return is.first;
}

std::optional<TreeDifference> compareCapped(const RayTree::Capped& expected, const RayTree::Capped& got,
                                            const TreeTolerance& tolerance)
{
    NodeComparison is(tolerance);
    is.same("kind", expected.kind, got.kind);
    is.direction("direction", expected.direction, got.direction);
    is.number("weight", expected.weight, got.weight);
    is.same("reason", expected.reason, got.reason);
    is.vector("radiance", expected.radiance, got.radiance);
    return is.first;
}

bool neverReturned(const RayTree::Node& node)
{
    return node.step > 0 && node.returnStep <= 0;
}

std::string shortText(const Vec3<double>& v)
{
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z);
}

} // namespace rt
