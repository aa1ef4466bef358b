#include "viz/drawing/tree_layout.h"

#include <algorithm>
#include <cmath>

namespace rt::viz
{

namespace
{

constexpr double familyGap = 0.3; // between leaves of different parents, beyond what they take themselves

/// What hangs from one node, before it has a place.
struct Leaf
{
    ItemKind kind;
    int node, index, step;
};

/// The children of all nodes in one array; those of node n are [start[n], start[n + 1]), in the order in which they
/// happened. A tree that does not know its steps keeps shadow rays first, then what was not followed.
struct Links
{
    std::vector<std::size_t> start;
    std::vector<Leaf> children;
    std::vector<int> roots;

    explicit Links(const RayTree& tree) : start(tree.nodes.size() + 1, 0)
    {
        const auto each = [&](const auto& visit) {
            for (std::size_t i = 0; i < tree.shadows.size(); ++i)
                visit(tree.shadows[i].node, Leaf{ItemKind::shadow, tree.shadows[i].node, int(i), tree.shadows[i].step});
            for (std::size_t i = 0; i < tree.capped.size(); ++i)
                visit(tree.capped[i].node,
                      Leaf{ItemKind::notFollowed, tree.capped[i].node, int(i), tree.capped[i].step});
            for (std::size_t i = 0; i < tree.nodes.size(); ++i)
                visit(tree.nodes[i].parent, Leaf{ItemKind::ray, int(i), -1, tree.nodes[i].step});
        };
        each([&](int parent, const Leaf& leaf) {
            if (parent < 0)
                roots.push_back(leaf.node);
            else
                ++start[std::size_t(parent) + 1];
        });
        for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
        children.resize(start.back());
        auto next = start;
        each([&](int parent, const Leaf& leaf) {
            if (parent >= 0) children[next[std::size_t(parent)]++] = leaf;
        });
        for (std::size_t n = 0; n + 1 < start.size(); ++n)
            std::stable_sort(children.begin() + std::ptrdiff_t(start[n]),
                             children.begin() + std::ptrdiff_t(start[n + 1]),
                             [](const Leaf& a, const Leaf& b) { return a.step < b.step; });
    }
};

/// All items in preorder, without places.
void addItems(TreeLayout& layout, const Links& links)
{
    struct Open
    {
        int node, item;
        std::size_t next;
    };
    std::vector<Open> open;
    const auto add = [&](const Leaf& leaf, int parent) {
        const int item = int(layout.items.size());
        const int level = parent < 0 ? 0 : layout.items[std::size_t(parent)].level + 1;
        layout.items.push_back({leaf.kind, leaf.node, leaf.index, parent, level, 0, 0});
        layout.levels = std::max(layout.levels, level + 1);
        if (leaf.kind == ItemKind::shadow) layout.ofShadow[std::size_t(leaf.index)] = item;
        if (leaf.kind == ItemKind::notFollowed) layout.ofNotFollowed[std::size_t(leaf.index)] = item;
        if (leaf.kind != ItemKind::ray) return;
        layout.ofNode[std::size_t(leaf.node)] = item;
        open.push_back({leaf.node, item, links.start[std::size_t(leaf.node)]});
    };
    for (const int root : links.roots)
    {
        add({ItemKind::ray, root, -1, 0}, -1);
        while (!open.empty())
        {
            auto& top = open.back();
            if (top.next == links.start[std::size_t(top.node) + 1])
                open.pop_back();
            else
            {
                const auto& child = links.children[top.next++];
                add(child, top.item); // may move what `top` refers to
            }
        }
    }
}

/// Leaves side by side, parents over the middle of theirs.
void placeItems(TreeLayout& layout)
{
    auto& items = layout.items;
    std::vector<double> first(items.size(), -1), last(items.size(), -1); // children
    std::vector<char> isParent(items.size(), false);
    for (const auto& item : items)
        if (item.parent >= 0) isParent[std::size_t(item.parent)] = true;

    int before = -1;
    for (std::size_t i = 0; i < items.size(); ++i)
    {
        auto& item = items[i];
        item.y = item.level;
        if (isParent[i]) continue;
        if (before >= 0)
        {
            const auto& other = items[std::size_t(before)];
            const auto half = [](const TreeItem& leaf) { return leaf.kind == ItemKind::shadow ? tightest / 2 : 0.5; };
            item.x = other.x + half(other) + half(item) + (other.parent == item.parent ? 0 : familyGap);
        }
        layout.width = item.x;
        before = int(i);
    }
    // Children come after their parents: going backwards meets each parent when all of them have their places.
    for (std::size_t i = items.size(); i-- > 0;)
    {
        auto& item = items[i];
        if (isParent[i]) item.x = (first[i] + last[i]) / 2;
        if (item.parent < 0) continue;
        const auto parent = std::size_t(item.parent);
        first[parent] = item.x;
        if (last[parent] < 0) last[parent] = item.x;
    }
    layout.height = std::max(0, layout.levels - 1);
}

void indexLevels(TreeLayout& layout)
{
    layout.levelStart.assign(std::size_t(layout.levels) + 1, 0);
    for (const auto& item : layout.items) ++layout.levelStart[std::size_t(item.level) + 1];
    for (std::size_t i = 1; i < layout.levelStart.size(); ++i) layout.levelStart[i] += layout.levelStart[i - 1];
    layout.byLevel.resize(layout.items.size());
    auto next = layout.levelStart;
    // Within a level the preorder is the order of the positions.
    for (std::size_t i = 0; i < layout.items.size(); ++i)
        layout.byLevel[next[std::size_t(layout.items[i].level)]++] = int(i);
}

void measureGaps(TreeLayout& layout)
{
    for (std::size_t i = 1; i < layout.byLevel.size(); ++i)
    {
        const auto& a = layout.items[std::size_t(layout.byLevel[i - 1])];
        const auto& b = layout.items[std::size_t(layout.byLevel[i])];
        if (a.level != b.level) continue;
        const int shadows = (a.kind == ItemKind::shadow) + (b.kind == ItemKind::shadow);
        auto& gap = shadows == 0 ? layout.rayGap : shadows == 1 ? layout.mixedGap : layout.shadowGap;
        gap = std::min(gap, b.x - a.x);
    }
}

} // namespace

TreeLayout layOutTree(const RayTree& tree, bool sideways)
{
    TreeLayout layout;
    layout.ofNode.assign(tree.nodes.size(), -1);
    layout.ofShadow.assign(tree.shadows.size(), -1);
    layout.ofNotFollowed.assign(tree.capped.size(), -1);
    layout.items.reserve(tree.nodes.size() + tree.shadows.size() + tree.capped.size());
    addItems(layout, Links(tree));
    placeItems(layout);
    indexLevels(layout);
    measureGaps(layout);
    return sideways ? turned(std::move(layout)) : layout;
}

TreeLayout turned(TreeLayout layout)
{
    for (auto& item : layout.items) std::swap(item.x, item.y);
    std::swap(layout.width, layout.height);
    layout.sideways = !layout.sideways;
    return layout;
}

bool isBetterTurned(const TreeLayout& layout, double width, double height)
{
    const double across = layout.sideways ? layout.height : layout.width;
    const double along = layout.sideways ? layout.width : layout.height;
    // Room for a node: the smaller of its distances to neighbours, of which more than a tenth of the pane is wasted.
    const auto room = [](double w, double h, double a, double b) {
        return std::min({w / (a + 1), h / (b + 1), std::min(w, h) / 8});
    };
    const double down = room(width, height, across, along), right = room(width, height, along, across);
    const bool wantsSideways = right >= 0.9 * down;
    return wantsSideways != layout.sideways;
}

std::vector<int> itemsWithin(const TreeLayout& layout, double left, double top, double right, double bottom)
{
    std::vector<int> found;
    if (layout.sideways)
    {
        std::swap(left, top);
        std::swap(right, bottom);
    }
    const auto across = [&](int item) {
        const auto& it = layout.items[std::size_t(item)];
        return layout.sideways ? it.y : it.x;
    };
    const double lowest = std::max(0.0, std::ceil(top)), highest = std::min(layout.levels - 1.0, std::floor(bottom));
    for (double level = lowest; level <= highest; ++level)
    {
        const auto begin = layout.byLevel.begin() + std::ptrdiff_t(layout.levelStart[std::size_t(level)]);
        const auto end = layout.byLevel.begin() + std::ptrdiff_t(layout.levelStart[std::size_t(level) + 1]);
        for (auto i = std::lower_bound(begin, end, left, [&](int item, double x) { return across(item) < x; });
             i != end && across(*i) <= right; ++i)
            found.push_back(*i);
    }
    return found;
}

int itemAt(const TreeLayout& layout, double x, double y, double radiusX, double radiusY)
{
    int best = -1;
    double nearest = 1;
    for (const int item : itemsWithin(layout, x - radiusX, y - radiusY, x + radiusX, y + radiusY))
    {
        const auto& it = layout.items[std::size_t(item)];
        const double distance = std::hypot((it.x - x) / radiusX, (it.y - y) / radiusY);
        if (distance > nearest || (distance == nearest && best >= 0)) continue;
        nearest = distance;
        best = item;
    }
    return best;
}

std::vector<int> ancestorsOf(const TreeLayout& layout, int item)
{
    std::vector<int> found;
    for (int i = layout.items[std::size_t(item)].parent; i >= 0; i = layout.items[std::size_t(i)].parent)
        found.push_back(i);
    return found;
}

void TreeView::fit(const TreeLayout& layout, const Frame& chosen)
{
    frame = chosen;
    treeWidth = layout.width;
    treeHeight = layout.height;
    const double width = std::max(1.0, frame.width - frame.left - frame.right);
    const double height = std::max(1.0, frame.height - frame.top - frame.bottom);
    fitX = treeWidth > 0 ? std::min(frame.fitted, width / treeWidth) : frame.fitted;
    fitY = treeHeight > 0 ? std::min(frame.fitted, height / treeHeight) : frame.fitted;
    zoom = 1;
    zoomed = false;
    left = frame.left + (width - treeWidth * fitX) / 2;
    top = frame.height - frame.top - (height - treeHeight * fitY) / 2;
}

void TreeView::adapt(const TreeLayout& layout, const Frame& chosen)
{
    if (!zoomed) return fit(layout, chosen);
    const double unit = std::min(unitX(), unitY()), oldLeft = left, oldTop = top - frame.height;
    fit(layout, chosen);
    zoomed = true;
    zoom = std::clamp(unit / std::min(fitX, fitY), 1.0, mostZoom());
    left = oldLeft;
    top = oldTop + frame.height;
    keepInside();
}

void TreeView::zoomAt(double factor, double paneX, double paneY)
{
    const auto under = toTree(paneX, paneY);
    zoom = std::clamp(zoom * factor, 1.0, mostZoom());
    zoomed = true;
    left = paneX - under[0] * unitX();
    top = paneY + under[1] * unitY();
    keepInside();
}

void TreeView::pan(double dx, double dy)
{
    left += dx;
    top += dy;
    zoomed = true;
    keepInside();
}

void TreeView::centre(double x, double y, double pixelsPerUnit)
{
    zoom = std::clamp(std::max(zoom, pixelsPerUnit / std::min(fitX, fitY)), 1.0, mostZoom());
    zoomed = true;
    left = (frame.left + frame.width - frame.right) / 2 - x * unitX();
    top = (frame.bottom + frame.height - frame.top) / 2 + y * unitY();
}

void TreeView::reveal(double x, double y)
{
    const auto at = toPane(x, y);
    const double right = frame.width - frame.right, highest = frame.height - frame.top;
    if (at[0] >= frame.left && at[0] <= right && at[1] >= frame.bottom && at[1] <= highest) return;
    left += (frame.left + right) / 2 - at[0];
    top += (frame.bottom + highest) / 2 - at[1];
}

/// A part of the drawing stays within the margins.
void TreeView::keepInside()
{
    const double middleX = (frame.left + frame.width - frame.right) / 2;
    const double middleY = (frame.bottom + frame.height - frame.top) / 2;
    left = std::clamp(left, middleX - treeWidth * unitX(), middleX);
    top = std::clamp(top, middleY, middleY + treeHeight * unitY());
}

} // namespace rt::viz
