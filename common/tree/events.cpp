#include "common/tree/events.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/tree/tree_pairing.h"

namespace rt
{

namespace
{

/// Without recursion: a tree from a file may be as deep as it likes.
std::vector<Event> presumedEvents(const RayTree& tree)
{
    const TreeLinks links = linksOf(tree);
    std::vector<Event> events;
    struct Open
    {
        int node;
        std::size_t next = 0;
    };
    std::vector<Open> open;
    const auto enter = [&](int id) {
        events.push_back({Event::Kind::follow, id, -1, tree.nodes[std::size_t(id)].line});
        for (const int i : links.shadows[std::size_t(id)])
            events.push_back({Event::Kind::shadow, id, i, tree.shadows[std::size_t(i)].line});
        for (const int i : links.capped[std::size_t(id)])
            events.push_back({Event::Kind::notFollowed, id, i, tree.capped[std::size_t(i)].line});
        open.push_back({id});
    };
    for (const int root : links.children.back()) // of no node: the camera ray and orphans
    {
        enter(root);
        while (!open.empty())
        {
            auto& [id, next] = open.back();
            const auto& below = links.children[std::size_t(id)];
            if (next < below.size())
                enter(below[next++]);
            else
            {
                events.push_back({Event::Kind::returns, id, -1, tree.nodes[std::size_t(id)].returnLine});
                open.pop_back();
            }
        }
    }
    return events;
}

} // namespace

std::vector<Event> eventsOf(const RayTree& tree)
{
    const bool known =
        std::all_of(tree.nodes.begin(), tree.nodes.end(), [](const auto& node) { return node.step > 0; });
    if (!known) return presumedEvents(tree);

    std::vector<std::pair<int, Event>> ordered;
    for (const auto& node : tree.nodes)
    {
        ordered.push_back({node.step, {Event::Kind::follow, node.id, -1, node.line}});
        // An exercise that is not finished has not returned.
        if (node.returnStep > 0)
            ordered.push_back({node.returnStep, {Event::Kind::returns, node.id, -1, node.returnLine}});
    }
    for (std::size_t i = 0; i < tree.shadows.size(); ++i)
    {
        const auto& shadow = tree.shadows[i];
        ordered.push_back({shadow.step, {Event::Kind::shadow, shadow.node, int(i), shadow.line}});
    }
    for (std::size_t i = 0; i < tree.capped.size(); ++i)
    {
        const auto& capped = tree.capped[i];
        ordered.push_back({capped.step, {Event::Kind::notFollowed, capped.node, int(i), capped.line}});
    }
    std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Event> events;
    for (const auto& [step, event] : ordered) events.push_back(event);
    return events;
}

std::string describe(const RayTree& tree, const Event& event)
{
    const auto& node = tree.nodes[std::size_t(event.node)];
    const auto ray = fmt::format("{} ray [{}]", name(node.kind), node.id);
    const auto color = [](const Vec3<double>& c) { return fmt::format("({:.3g}, {:.3g}, {:.3g})", c.x, c.y, c.z); };
    switch (event.kind)
    {
    case Event::Kind::follow:
        if (!node.hit) return ray + " meets nothing";
        return fmt::format("{} hits {} at t = {:.4g}{}", ray, node.hit->primitive, node.hit->t,
                           node.hit->inside ? ", from inside" : "");
    case Event::Kind::shadow:
    {
        const auto& shadow = tree.shadows[std::size_t(event.index)];
        const auto asked = fmt::format("[{}] asks light {}", node.id, shadow.light);
        if (shadow.visible) return asked + ": visible";
        return asked + (shadow.blocker ? ": behind " + shadow.blocker->primitive : ": not visible");
    }
    case Event::Kind::notFollowed:
    {
        const auto& capped = tree.capped[std::size_t(event.index)];
        return fmt::format("{} ray of [{}] is not followed: {}", name(capped.kind), node.id,
                           capped.reason == End::cutoff ? "it could add too little" : "deeper than MAXDEPTH");
    }
    case Event::Kind::returns:
        break;
    }
    return fmt::format("{} returns {}", ray, color(node.radiance));
}

} // namespace rt
