#include "viz/window/tree_pane.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "viz/state/node_text.h"
#include "viz/window/tree_painter.h"

namespace rt::viz
{

namespace
{

Rgba* pixelsOf(vtkImageData* image, int width, int height)
{
    int size[3];
    image->GetDimensions(size);
    if (size[0] != width || size[1] != height)
    {
        image->SetDimensions(width, height, 1);
        image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    }
    image->Modified();
    return static_cast<Rgba*>(image->GetScalarPointer());
}

std::string plural(std::size_t count, const char* what)
{
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

} // namespace

TreePane::TreePane(Controller& watched) : Pane(watched)
{
    rebuild();
}

void TreePane::dress()
{
    Pane::dress();
    stale = true;
}

void TreePane::placed()
{
    rebuild();
}

TreeView::Frame TreePane::frame() const
{
    TreeView::Frame frame;
    frame.width = area.width;
    frame.height = area.height;
    frame.top = (layout.sideways ? 72 : 60) * scale;
    frame.left = (layout.sideways ? 26 : 44) * scale;
    frame.right = (layout.sideways ? 84 : 30) * scale;
    frame.bottom = (layout.sideways ? 46 : 52) * scale;
    frame.fitted = 76 * scale;
    frame.largest = 96 * scale;
    return frame;
}

/// Of the circles, pixels.
double TreePane::radius() const
{
    const double along = layout.sideways ? view.unitX() : view.unitY();
    const double across = layout.sideways ? view.unitY() : view.unitX();
    return std::min({17 * scale, 0.4 * along, across * std::min(0.42 * layout.rayGap, 0.58 * layout.mixedGap)});
}

/// Of the squares' sides, pixels.
double TreePane::shadowHalf() const
{
    const double across = layout.sideways ? view.unitY() : view.unitX();
    return std::max(std::min(0.62 * radius(), across * std::min(0.4 * layout.shadowGap, 0.36 * layout.mixedGap)),
                    0.5 * scale);
}

void TreePane::rebuild()
{
    const auto& tree = controller.tree();
    layout = layOutTree(tree);
    if (isBetterTurned(layout, area.width - 90 * scale, area.height - 86 * scale)) layout = turned(std::move(layout));
    deepest = controller.deepest();
    depthsAreLevels = std::all_of(layout.items.begin(), layout.items.end(), [&](const TreeItem& it) {
        return it.kind != ItemKind::ray || tree.nodes[std::size_t(it.node)].depth == it.level;
    });
    view.adapt(layout, frame());
    pointed = -1;
    compare();
    stale = true;
}

void TreePane::compare()
{
    extra.assign(controller.tree().nodes.size(), 0);
    differing = 0;
    const auto* comparison = controller.comparison();
    if (!comparison) return;
    for (const auto& node : comparison->tree.nodes)
    {
        if (comparison->match.expectedOf[std::size_t(node.id)] >= 0 || node.parent < 0) continue;
        if (const int parent = comparison->match.expectedOf[std::size_t(node.parent)]; parent >= 0)
            ++extra[std::size_t(parent)];
    }
    differing = int(std::count(comparison->match.differs.begin(), comparison->match.differs.end(), true));
}

bool TreePane::update(unsigned changes)
{
    if (changes & changedTree) rebuild();
    if (changes & (changedTree | changedNode | changedStep | changedOptions))
    {
        stale = true;
        if (const auto* node = controller.node(); node && view.isZoomed())
        {
            const auto& it = layout.items[std::size_t(layout.ofNode[std::size_t(node->id)])];
            view.reveal(it.x, it.y);
        }
        return true;
    }
    return changes & changedHover;
}

void TreePane::fit()
{
    view.fit(layout, frame());
    stale = true;
}

void TreePane::search(const std::string& digits)
{
    int id = -1;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), id);
    const int count = int(controller.tree().nodes.size());
    if (error != std::errc() || end != digits.data() + digits.size() || id < 0 || id >= count)
        return controller.say(
            count == 0 ? "there is no ray to search for"
                       : fmt::format("there is no ray {}: they have the numbers 0 to {}", digits, count - 1));
    const auto& it = layout.items[std::size_t(layout.ofNode[std::size_t(id)])];
    if (radius() < 12 * scale) view.centre(it.x, it.y, 44 * scale);
    stale = true;
    controller.selectNode(id);
}

int TreePane::itemUnder(int x, int y) const
{
    if (y > area.height - 34 * scale || y < 24 * scale) return -1; // title and legend
    const double reach = std::max(radius() + 3 * scale, 7 * scale);
    const auto p = view.toTree(x + 0.5, y + 0.5);
    const int item = itemAt(layout, p[0], p[1], reach / view.unitX(), reach / view.unitY());
    if (item < 0) return -1;
    const auto& it = layout.items[std::size_t(item)];
    const bool isShown = it.kind == ItemKind::shadow ? controller.isShadowShown(it.index) : controller.isShown(it.node);
    return isShown ? item : -1;
}

bool TreePane::click(int x, int y)
{
    if (const int item = itemUnder(x, y); item >= 0) controller.selectNode(layout.items[std::size_t(item)].node);
    return false; // the controller says what has changed
}

bool TreePane::drag(int dx, int dy)
{
    view.pan(dx, dy);
    pointed = -1;
    stale = true;
    return true;
}

bool TreePane::wheel(int x, int y, bool forward)
{
    view.zoomAt(forward ? 1.25 : 0.8, x, y);
    pointed = itemUnder(x, y);
    stale = true;
    return true;
}

void TreePane::hover(int x, int y)
{
    point(itemUnder(x, y));
}

void TreePane::leave()
{
    point(-1);
}

/// Either the controller says that another node is hovered, or the pane must ask to be drawn itself.
void TreePane::point(int item)
{
    const int node = item < 0 ? -1 : layout.items[std::size_t(item)].node;
    if (item != pointed && node == controller.hovered()) askForDrawing();
    pointed = item;
    controller.hover(node);
}

void TreePane::redraw()
{
    Raster raster(pixelsOf(drawn, area.width, area.height), area.width, area.height);
    paintTree({controller, layout, view, extra, words, area.width, area.height, scale, radius(), shadowHalf(),
               depthsAreLevels},
              raster);
    stale = false;
}

void TreePane::paint(Canvas& canvas)
{
    if (!isPlaced()) return;
    if (stale) redraw();
    canvas.image(0, 0, drawn);
    paintTitle(canvas);
    paintLegend(canvas);
    paintHover(canvas);
}

void TreePane::paintTitle(Canvas& canvas)
{
    const double high = canvas.px(34), y = area.height - high / 2;
    canvas.fill({0, area.height - high, double(area.width), high}, color::panel);
    paintEdges(canvas);
    double x = canvas.px(16);
    x += canvas.text(x, y, "Ray tree", {Font::bold, 13, color::text}) + canvas.px(12);
    const auto& tree = controller.tree();
    std::string counts = tree.nodes.empty()
                             ? "nothing was traced"
                             : plural(tree.nodes.size(), "ray") + ", " + plural(tree.shadows.size(), "shadow ray") +
                                   fmt::format(", depth {}", deepest);
    const TextLook look{Font::sans, 12, color::textDim};
    if (x + canvas.textWidth(counts, look) > area.width - canvas.px(8)) counts = plural(tree.nodes.size(), "ray");
    x += canvas.text(x, y, counts, look) + canvas.px(14);
    if (!controller.comparison()) return;
    const TextLook marked{Font::bold, 12, differing > 0 ? color::warning : color::textDim};
    const auto said = differing > 0 ? fmt::format("{} differ", differing) : std::string("none differs");
    if (x + canvas.textWidth(said, marked) < area.width - canvas.px(8)) canvas.text(x, y, said, marked);
}

/// Names the shapes; as many as there is room for.
void TreePane::paintLegend(Canvas& canvas)
{
    const double high = canvas.px(24), y = high / 2;
    const TextLook look{Font::sans, 10.5, color::textFaint};
    canvas.fill({0, 0, area.width - canvas.hair(), high}, color::panel);
    double x = canvas.px(16);
    for (const char* entry : {"● ray", "○ hits nothing", "■ shadow ray", "□ blocked", "‖ not followed"})
    {
        if (x + canvas.textWidth(entry, look) > area.width - canvas.px(8)) return;
        x += canvas.text(x, y, entry, look) + canvas.px(14);
    }
}

void TreePane::paintHover(Canvas& canvas)
{
    const int node = controller.hovered();
    if (node < 0) return;
    const bool isPointed = pointed >= 0 && layout.items[std::size_t(pointed)].node == node;
    const auto& it = layout.items[std::size_t(isPointed ? pointed : layout.ofNode[std::size_t(node)])];
    const vec2 p = view.toPane(it.x, it.y);
    const double ring = std::max(radius(), 3 * scale) + 3 * scale, half = std::ceil(ring + 3 * scale);
    if (p[0] < 0 || p[1] < 0 || p[0] >= area.width || p[1] > area.height - canvas.px(30)) return;
    const int size = int(2 * half);
    const double x = std::floor(p[0] - half), y = std::floor(p[1] - half);
    Raster raster(pixelsOf(patch, size, size), size, size);
    raster.clear(color::accent.withAlpha(0));
    raster.ring({p[0] - x, p[1] - y}, ring, 2.2 * scale, color::accent);
    canvas.image(x, y, patch);
    if (isPointed) paintTip(canvas, p);
}

std::vector<std::string> TreePane::tip() const
{
    const auto& it = layout.items[std::size_t(pointed)];
    const auto& tree = controller.tree();
    const auto& node = tree.nodes[std::size_t(it.node)];
    if (it.kind == ItemKind::shadow)
    {
        const auto& shadow = tree.shadows[std::size_t(it.index)];
        const auto heading = fmt::format("shadow ray of [{}] to light {}", it.node, shadow.light);
        if (!controller.isShadowReached(it.index)) return {heading, "not yet sent"};
        if (shadow.visible) return {heading, fmt::format("reaches it after {:.4g}", shadow.distance)};
        return {heading, shadow.blocker ? "blocked by " + shorten(shadow.blocker->primitive, 30) : "blocked"};
    }
    if (it.kind == ItemKind::notFollowed)
    {
        const auto& capped = tree.capped[std::size_t(it.index)];
        return {fmt::format("{} ray of [{}], not followed", name(capped.kind), it.node),
                capped.reason == End::cutoff ? "cutoff: it could not have added enough"
                                             : fmt::format("it would be deeper than MAXDEPTH = {}", tree.maxDepth),
                "in its place " + shortText(capped.radiance)};
    }
    std::vector<std::string> lines{nodeHeading(tree, node)};
    if (!controller.isReached(it.node))
    {
        lines.push_back("not yet followed");
        return lines;
    }
    std::string hits = "hits nothing";
    if (node.hit) hits = fmt::format("hits {} at t = {:.4g}", shorten(node.hit->primitive, 24), node.hit->t);
    if (node.tir) hits += ", total internal reflection";
    lines.push_back(hits);
    if (controller.hasReturned(it.node))
    {
        lines.push_back("returns " + shortText(node.radiance));
        lines.push_back("adds " + shortText(node.contribution));
    }
    if (const auto* comparison = controller.comparison())
    {
        if (comparison->match.gotOf[std::size_t(it.node)] < 0)
            lines.push_back("missing in " + shorten(controller.other().title, 30));
        else if (comparison->match.differs[std::size_t(it.node)])
            lines.push_back("differs from " + shorten(controller.other().title, 30));
        if (const int more = extra[std::size_t(it.node)]; more > 0)
            lines.push_back(
                fmt::format("{} more in {}", plural(std::size_t(more), "ray"), shorten(controller.other().title, 30)));
    }
    return lines;
}

void TreePane::paintTip(Canvas& canvas, const vec2& at)
{
    const auto lines = tip();
    const double row = canvas.px(17), pad = canvas.px(9);
    const auto lookOf = [](std::size_t i) {
        return i == 0 ? TextLook{Font::bold, 12, color::text} : TextLook{Font::sans, 12, color::textDim};
    };
    double wide = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) wide = std::max(wide, canvas.textWidth(lines[i], lookOf(i)));
    const double gap = std::max(radius(), 3 * scale) + canvas.px(10);
    Box box{at[0] + gap, at[1] - gap, wide + 2 * pad, row * double(lines.size()) + canvas.px(10)};
    if (box.x + box.width > area.width - canvas.px(4)) box.x = at[0] - gap - box.width;
    box.x = std::clamp(box.x, canvas.px(4), std::max(canvas.px(4), area.width - canvas.px(4) - box.width));
    box.y -= box.height;
    // Never over what it explains.
    if (box.y < canvas.px(4)) box.y = at[1] + gap;
    if (box.y + box.height > area.height - canvas.px(4))
        box.y = std::max(canvas.px(4), area.height - canvas.px(4) - box.height);
    const double rim = canvas.hair();
    canvas.roundedBox({box.x - rim, box.y - rim, box.width + 2 * rim, box.height + 2 * rim}, canvas.px(6),
                      color::textFaint);
    canvas.roundedBox(box, canvas.px(6), color::panelRaised);
    for (std::size_t i = 0; i < lines.size(); ++i)
        canvas.text(box.x + pad, box.y + box.height - canvas.px(5) - row * (double(i) + 0.5), lines[i], lookOf(i));
}

} // namespace rt::viz
