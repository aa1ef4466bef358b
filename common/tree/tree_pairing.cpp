#include "common/tree/tree_pairing.h"

#include <algorithm>
#include <span>

namespace rt
{

namespace
{

/// One thing that leaves a node, as far as pairing needs it: `group` is the kind of a ray or the light of a shadow ray.
struct Arrow
{
    int index;
    int group;
    Vec3<double> direction;
};

using Arrows = std::vector<Arrow>;

/// Both are unit vectors unless a tracer is broken; false for NaN.
double apart(const Arrow& a, const Arrow& b)
{
    return length(a.direction - b.direction);
}

/// About a twentieth of a degree: far more than rounding, far less than what siblings are apart.
bool near(const Arrow& a, const Arrow& b)
{
    constexpr double radians = 1e-3;
    return apart(a, b) <= radians;
}

void pair(Pairing& pairing, const Arrow& e, const Arrow& g)
{
    pairing.gotOf[std::size_t(e.index)] = g.index;
    pairing.expectedOf[std::size_t(g.index)] = e.index;
}

/// Walks along both lists and pairs what has the same direction, looking a few places ahead for what one list lacks.
void pairNear(Pairing& pairing, std::span<const Arrow> expected, std::span<const Arrow> got)
{
    constexpr std::size_t lookAhead = 8;
    std::size_t e = 0, g = 0;
    const auto advance = [&] {
        for (std::size_t k = 0; k <= lookAhead; ++k)
        {
            if (e + k < expected.size() && near(expected[e + k], got[g])) return e += k, true;
            if (g + k < got.size() && near(expected[e], got[g + k])) return g += k, true;
        }
        return false;
    };
    for (; e < expected.size() && g < got.size(); ++e, ++g)
        if (advance()) pair(pairing, expected[e], got[g]);
}

Arrows unpaired(const std::vector<int>& partners, std::span<const Arrow> arrows)
{
    Arrows left;
    for (const auto& arrow : arrows)
        if (partners[std::size_t(arrow.index)] < 0) left.push_back(arrow);
    return left;
}

/// Pairs as many as there are on the shorter side: the closest ones first if they are few, else in order.
void pairRest(Pairing& pairing, const Arrows& expected, const Arrows& got)
{
    constexpr std::size_t few = 64;
    if (expected.size() == got.size() || expected.size() * got.size() > few)
    {
        for (std::size_t i = 0; i < std::min(expected.size(), got.size()); ++i) pair(pairing, expected[i], got[i]);
        return;
    }
    struct Candidate
    {
        double apart;
        const Arrow *e, *g;
    };
    std::vector<Candidate> candidates;
    for (const auto& e : expected)
        for (const auto& g : got)
        {
            const double distance = apart(e, g);
            candidates.push_back({distance >= 0 ? distance : infinity<double>, &e, &g});
        }
    std::stable_sort(candidates.begin(), candidates.end(), [](auto& a, auto& b) { return a.apart < b.apart; });
    for (const auto& [distance, e, g] : candidates)
        if (pairing.gotOf[std::size_t(e->index)] < 0 && pairing.expectedOf[std::size_t(g->index)] < 0)
            pair(pairing, *e, *g);
}

/// Those of a group are paired among themselves, also with other directions; across groups only the same direction
/// counts: a ray of the wrong kind.
void pairSiblings(Pairing& pairing, Arrows expected, Arrows got)
{
    const auto byGroup = [](const Arrow& a, const Arrow& b) { return a.group < b.group; };
    std::stable_sort(expected.begin(), expected.end(), byGroup);
    std::stable_sort(got.begin(), got.end(), byGroup);
    for (auto e = expected.begin(), g = got.begin(); e != expected.end();)
    {
        const auto endOfE = std::upper_bound(e, expected.end(), *e, byGroup);
        const auto [startOfG, endOfG] = std::equal_range(g, got.end(), *e, byGroup);
        const std::span<const Arrow> those(e, endOfE), these(startOfG, endOfG);
        pairNear(pairing, those, these);
        pairRest(pairing, unpaired(pairing.gotOf, those), unpaired(pairing.expectedOf, these));
        e = endOfE;
        g = endOfG;
    }
    pairNear(pairing, unpaired(pairing.gotOf, expected), unpaired(pairing.expectedOf, got));
}

template <class Item, class Group>
Arrows arrows(const std::vector<int>& indices, const std::vector<Item>& items, Group&& group)
{
    Arrows found;
    for (const int i : indices) found.push_back({i, group(items[std::size_t(i)]), items[std::size_t(i)].direction});
    return found;
}

Pairing noPairs(std::size_t expected, std::size_t got)
{
    return {std::vector<int>(expected, -1), std::vector<int>(got, -1)};
}

} // namespace

TreeLinks linksOf(const RayTree& tree)
{
    const std::size_t nodes = tree.nodes.size();
    TreeLinks links{{}, {}, {}, {}};
    links.children.resize(nodes + 1);
    links.shadows.resize(nodes + 1);
    links.capped.resize(nodes + 1);
    const auto place = [](int node, std::size_t least, std::size_t none) {
        return node >= 0 && std::size_t(node) < least ? std::size_t(node) : none;
    };
    for (std::size_t i = 0; i < nodes; ++i)
    {
        links.parent.push_back(int(place(tree.nodes[i].parent, i, nodes)));
        links.children[std::size_t(links.parent[i])].push_back(int(i));
    }
    for (std::size_t i = 0; i < tree.shadows.size(); ++i)
        links.shadows[place(tree.shadows[i].node, nodes, nodes)].push_back(int(i));
    for (std::size_t i = 0; i < tree.capped.size(); ++i)
        links.capped[place(tree.capped[i].node, nodes, nodes)].push_back(int(i));
    return links;
}

TreePairing pairUp(const RayTree& expected, const TreeLinks& expectedLinks, const RayTree& got,
                   const TreeLinks& gotLinks)
{
    TreePairing pairs{noPairs(expected.nodes.size(), got.nodes.size()),
                      noPairs(expected.shadows.size(), got.shadows.size()),
                      noPairs(expected.capped.size(), got.capped.size())};
    const auto kind = [](const auto& ray) { return int(ray.kind); };
    const auto light = [](const RayTree::Shadow& shadow) { return shadow.light; };

    std::vector<std::pair<std::size_t, std::size_t>> open{{expected.nodes.size(), got.nodes.size()}};
    while (!open.empty())
    {
        const auto [e, g] = open.back();
        open.pop_back();
        Arrows those = arrows(expectedLinks.children[e], expected.nodes, kind);
        Arrows these = arrows(gotLinks.children[g], got.nodes, kind);
        if (e == expected.nodes.size() && !those.empty() && !these.empty())
        {
            // The first ray of a tree is the one that was asked for, whatever it says it is.
            pair(pairs.nodes, those.front(), these.front());
            those.erase(those.begin());
            these.erase(these.begin());
        }
        pairSiblings(pairs.nodes, std::move(those), std::move(these));
        pairSiblings(pairs.shadows, arrows(expectedLinks.shadows[e], expected.shadows, light),
                     arrows(gotLinks.shadows[g], got.shadows, light));
        pairSiblings(pairs.capped, arrows(expectedLinks.capped[e], expected.capped, kind),
                     arrows(gotLinks.capped[g], got.capped, kind));
        for (const int child : expectedLinks.children[e])
            if (const int partner = pairs.nodes.gotOf[std::size_t(child)]; partner >= 0)
                open.emplace_back(std::size_t(child), std::size_t(partner));
    }
    return pairs;
}

} // namespace rt
