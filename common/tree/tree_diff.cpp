#include "common/tree/tree_diff.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/tree/tree_compare.h"
#include "common/tree/tree_pairing.h"

namespace rt
{

namespace
{

/// Something that happened at a node after its hit: a shadow ray, a ray not followed, a child. -1: not in this tree.
struct Happening
{
    enum Kind
    {
        shadow,
        own,
        capped,
        child
    };

    Kind kind;
    int expected = -1, got = -1;
};

std::string shadowTail(const RayTree::Shadow& shadow)
{
    return fmt::format(", shadow ray to light {}", shadow.light);
}

std::string cappedTail(const RayTree::Capped& capped)
{
    return fmt::format(", {} ray not followed", name(capped.kind));
}

class TreeComparison
{
public:
    TreeComparison(const RayTree& e, const RayTree& g, const TreeTolerance& accepted)
        : expected(e), got(g), tolerance(accepted), links(linksOf(e)), gotLinks(linksOf(g)),
          pairs(pairUp(e, links, g, gotLinks))
    {
    }

    std::optional<TreeDifference> first() const;
    TreeMatch match() const;

private:
    const RayTree &expected, &got;
    TreeTolerance tolerance;
    TreeLinks links, gotLinks;
    TreePairing pairs;

    std::vector<Happening> inOrder(const RayTree& tree, const TreeLinks& of, std::size_t node, bool isExpected) const;
    std::vector<Happening> happenings(std::size_t e, std::size_t g) const;
    std::optional<TreeDifference> compare(const Happening& at, std::size_t e) const;
    std::optional<TreeDifference> differenceAt(const Happening& at, std::size_t e, std::size_t g) const;
    std::optional<TreeDifference> onlyInOne(const Happening& at, std::size_t e, std::size_t g) const;
    std::string insteadOf(const Happening& missing, std::size_t g) const;
    std::string insteadOfExtra(const Happening& extra, std::size_t e) const;
    bool differs(std::size_t e, std::size_t g) const;

    TreeDifference placed(TreeDifference difference, std::size_t e, std::size_t g, const std::string& tail = "") const
    {
        difference.expectedNode = e < expected.nodes.size() ? int(e) : -1;
        difference.gotNode = g < got.nodes.size() ? int(g) : -1;
        difference.path = (e < expected.nodes.size() ? pathOf(expected, links, e) : pathOf(got, gotLinks, g)) + tail;
        return difference;
    }

    static std::string pathOf(const RayTree& tree, const TreeLinks& of, std::size_t node);
};

std::string TreeComparison::pathOf(const RayTree& tree, const TreeLinks& of, std::size_t node)
{
    std::vector<std::string> names;
    for (auto at = node; at < tree.nodes.size(); at = std::size_t(of.parent[at]))
    {
        const auto kind = tree.nodes[at].kind;
        const auto parent = std::size_t(of.parent[at]);
        int before = 0, all = 0;
        for (const int sibling : of.children[parent])
            if (tree.nodes[std::size_t(sibling)].kind == kind)
            {
                ++all;
                before += std::size_t(sibling) < at;
            }
        names.push_back(parent == tree.nodes.size() && at > 0 ? fmt::format("orphan {}", name(kind)) : name(kind));
        if (all > 1) names.back() += fmt::format(" #{}", before + 1);
    }
    std::reverse(names.begin(), names.end());
    constexpr std::size_t shown = 4; // at either end
    std::string path;
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        if (names.size() > 2 * shown + 1 && i == shown)
        {
            path += fmt::format(" > ({} more)", names.size() - 2 * shown);
            i = names.size() - shown;
        }
        path += (path.empty() ? "" : " > ") + names[i];
    }
    return path.empty() ? "nowhere" : path;
}

/// What happened at one node of one tree: by its steps if it knows them.
std::vector<Happening> TreeComparison::inOrder(const RayTree& tree, const TreeLinks& of, std::size_t node,
                                               bool isExpected) const
{
    std::vector<std::pair<int, Happening>> items;
    bool known = true;
    const auto add = [&](Happening::Kind kind, int index, const Pairing& pairing, int step) {
        const auto partner = (isExpected ? pairing.gotOf : pairing.expectedOf)[std::size_t(index)];
        items.push_back({step, isExpected ? Happening{kind, index, partner} : Happening{kind, partner, index}});
        known = known && step > 0;
    };
    for (const int i : of.shadows[node]) add(Happening::shadow, i, pairs.shadows, tree.shadows[std::size_t(i)].step);
    for (const int i : of.capped[node]) add(Happening::capped, i, pairs.capped, tree.capped[std::size_t(i)].step);
    for (const int i : of.children[node]) add(Happening::child, i, pairs.nodes, tree.nodes[std::size_t(i)].step);
    if (known)
        std::stable_sort(items.begin(), items.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Happening> ordered;
    for (const auto& [step, item] : items) ordered.push_back(item);
    return ordered;
}

/// What happened at a pair of nodes: in the order of the expected tree, with what only the other one has in between.
std::vector<Happening> TreeComparison::happenings(std::size_t e, std::size_t g) const
{
    const auto expectedOnes = inOrder(expected, links, e, true);
    std::vector<std::pair<std::pair<int, int>, std::size_t>> places;
    for (std::size_t i = 0; i < expectedOnes.size(); ++i)
        places.push_back({{expectedOnes[i].kind, expectedOnes[i].expected}, i});
    std::sort(places.begin(), places.end());

    // What only `got` has comes before the partner of what follows it there, and after what is missing there.
    std::vector<std::vector<Happening>> extraBefore(expectedOnes.size() + 1);
    std::vector<Happening> extra;
    const auto place = [&](std::size_t i) {
        extraBefore[i].insert(extraBefore[i].end(), extra.begin(), extra.end());
        extra.clear();
    };
    for (const auto& item : inOrder(got, gotLinks, g, false))
    {
        if (item.expected < 0)
            extra.push_back(item);
        else if (!extra.empty())
            place(std::lower_bound(places.begin(), places.end(),
                                   std::pair{std::pair{int(item.kind), item.expected}, std::size_t(0)})
                      ->second);
    }
    place(expectedOnes.size());

    std::vector<Happening> merged;
    for (std::size_t i = 0; i <= expectedOnes.size(); ++i)
    {
        merged.insert(merged.end(), extraBefore[i].begin(), extraBefore[i].end());
        if (i < expectedOnes.size()) merged.push_back(expectedOnes[i]);
    }
    // The light of the lamps is gathered before the rays that leave are followed.
    if (!links.shadows[e].empty() && e < expected.nodes.size())
        merged.insert(std::find_if(merged.begin(), merged.end(), [](auto& at) { return at.kind != Happening::shadow; }),
                      Happening{Happening::own, int(e), int(g)});
    return merged;
}

std::string notFollowed(const RayTree::Capped& capped)
{
    return capped.reason == End::cutoff ? "not followed: it could add too little"
                                        : "not followed: deeper than MAXDEPTH";
}

std::string rayText(RayKind kind, const Vec3<double>& direction)
{
    return fmt::format("a {} ray in direction {}", name(kind), shortText(direction));
}

/// What `got` has in the place of a ray that is missing.
std::string TreeComparison::insteadOf(const Happening& missing, std::size_t g) const
{
    if (g == got.nodes.size()) return got.nodes.empty() ? "a tree without rays" : "nothing";
    for (const int child : gotLinks.children[g])
        if (missing.kind != Happening::shadow && pairs.nodes.expectedOf[std::size_t(child)] < 0)
        {
            const auto& node = got.nodes[std::size_t(child)];
            return rayText(node.kind, node.direction) + " instead";
        }
    for (const int i : gotLinks.capped[g])
        if (missing.kind == Happening::child && pairs.capped.expectedOf[std::size_t(i)] < 0)
            return notFollowed(got.capped[std::size_t(i)]);
    for (const int root : gotLinks.children[got.nodes.size()])
        if (missing.kind == Happening::child && root > int(g) && pairs.nodes.expectedOf[std::size_t(root)] < 0)
            return fmt::format(
                "nothing, but ray [{}] of depth {} has no parent: a ray that leaves a point is one deeper "
                "than the ray that came",
                root, got.nodes[std::size_t(root)].depth);
    return neverReturned(got.nodes[g]) ? "nothing: the trace stopped here and did not return" : "nothing";
}

/// What `expected` has in the place of a ray that is too many.
std::string TreeComparison::insteadOfExtra(const Happening& extra, std::size_t e) const
{
    if (e == expected.nodes.size() || extra.kind != Happening::child) return "nothing";
    for (const int i : links.capped[e])
        if (pairs.capped.gotOf[std::size_t(i)] < 0) return notFollowed(expected.capped[std::size_t(i)]);
    const auto& node = expected.nodes[e];
    return node.end == End::none ? "nothing" : fmt::format("nothing ({})", name(node.end));
}

std::optional<TreeDifference> TreeComparison::onlyInOne(const Happening& at, std::size_t e, std::size_t g) const
{
    const bool missing = at.got < 0;
    const auto& tree = missing ? expected : got;
    const auto index = std::size_t(missing ? at.expected : at.got);
    TreeDifference difference;
    std::string what;
    if (at.kind == Happening::child)
    {
        const auto& node = tree.nodes[index];
        what = rayText(node.kind, node.direction);
        difference = missing ? placed({}, index, got.nodes.size()) : placed({}, expected.nodes.size(), index);
        difference.field = "ray";
    }
    else if (at.kind == Happening::capped)
    {
        const auto& capped = tree.capped[index];
        what = fmt::format("a {} ray {}", name(capped.kind), notFollowed(capped));
        difference = placed({}, e, g, cappedTail(capped));
        difference.field = "capped ray";
    }
    else
    {
        const auto& shadow = tree.shadows[index];
        what = fmt::format("a shadow ray to light {}", shadow.light);
        difference = placed({}, e, g, shadowTail(shadow));
        difference.field = "shadow ray";
        difference.shadowLight = shadow.light;
    }
    difference.field = (missing ? "missing " : "extra ") + difference.field;
    difference.expected = missing ? what : insteadOfExtra(at, e);
    difference.got = missing ? insteadOf(at, g) : what;
    return difference;
}

/// Without its place: finding the path takes time.
std::optional<TreeDifference> TreeComparison::compare(const Happening& at, std::size_t e) const
{
    const auto i = std::size_t(at.expected), j = std::size_t(at.got);
    switch (at.kind)
    {
    case Happening::shadow:
        return compareShadows(expected.shadows[i], got.shadows[j],
                              e < expected.nodes.size() ? expected.nodes[e] : RayTree::Node{}, tolerance);
    case Happening::own:
        return compareOwn(expected.nodes[i], got.nodes[j], tolerance);
    case Happening::capped:
        return compareCapped(expected.capped[i], got.capped[j], tolerance);
    case Happening::child:
        break;
    }
    return compareFollowed(expected.nodes[i], got.nodes[j], tolerance);
}

std::optional<TreeDifference> TreeComparison::differenceAt(const Happening& at, std::size_t e, std::size_t g) const
{
    if (at.expected < 0 || at.got < 0) return onlyInOne(at, e, g);
    const auto difference = compare(at, e);
    if (!difference) return std::nullopt;
    if (at.kind == Happening::child) return placed(*difference, std::size_t(at.expected), std::size_t(at.got));
    if (at.kind == Happening::own) return placed(*difference, e, g);
    if (at.kind == Happening::capped)
        return placed(*difference, e, g, cappedTail(expected.capped[std::size_t(at.expected)]));
    auto found = placed(*difference, e, g, shadowTail(expected.shadows[std::size_t(at.expected)]));
    found.shadowLight = expected.shadows[std::size_t(at.expected)].light;
    return found;
}

/// Without recursion: a tree from a file may be as deep as it likes.
std::optional<TreeDifference> TreeComparison::first() const
{
    struct Open
    {
        std::size_t e, g;
        std::vector<Happening> todo;
        std::size_t next = 0;
    };
    std::vector<Open> open;
    const auto enter = [&](std::size_t e, std::size_t g) { open.push_back({e, g, happenings(e, g)}); };
    enter(expected.nodes.size(), got.nodes.size());
    while (!open.empty())
    {
        auto& top = open.back();
        if (top.next < top.todo.size())
        {
            const Happening at = top.todo[top.next++];
            if (auto difference = differenceAt(at, top.e, top.g)) return difference;
            if (at.kind == Happening::child) enter(std::size_t(at.expected), std::size_t(at.got));
            continue;
        }
        if (top.e < expected.nodes.size())
        {
            const auto difference = compareReturned(expected.nodes[top.e], got.nodes[top.g], tolerance);
            if (difference) return placed(*difference, top.e, top.g);
        }
        open.pop_back();
    }
    return std::nullopt;
}

/// Does this pair of nodes differ by itself?
bool TreeComparison::differs(std::size_t e, std::size_t g) const
{
    const auto &node = expected.nodes[e], &other = got.nodes[g];
    if (compareFollowed(node, other, tolerance) || compareOwn(node, other, tolerance)) return true;
    bool sameBrought = true;
    for (const auto& at : happenings(e, g))
    {
        const bool inBoth = at.expected >= 0 && at.got >= 0;
        if (at.kind != Happening::child)
        {
            if (!inBoth || compare(at, e)) return true;
        }
        else if (!inBoth ||
                 compareBrought(expected.nodes[std::size_t(at.expected)], got.nodes[std::size_t(at.got)], tolerance))
            sameBrought = false;
    }
    return sameBrought && compareReturned(node, other, tolerance);
}

TreeMatch TreeComparison::match() const
{
    TreeMatch found{pairs.nodes.gotOf, pairs.nodes.expectedOf, {}};
    for (std::size_t e = 0; e < expected.nodes.size(); ++e)
        found.differs.push_back(found.gotOf[e] < 0 || differs(e, std::size_t(found.gotOf[e])));
    return found;
}

} // namespace

TreeTolerance floatAgainstDouble()
{
    return {.relative = 1e-3, .absolute = 1e-5};
}

std::optional<TreeDifference> firstDifference(const RayTree& expected, const RayTree& got,
                                              const TreeTolerance& tolerance)
{
    return TreeComparison(expected, got, tolerance).first();
}

TreeMatch matchTrees(const RayTree& expected, const RayTree& got, const TreeTolerance& tolerance)
{
    return TreeComparison(expected, got, tolerance).match();
}

} // namespace rt
