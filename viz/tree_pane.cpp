#include "viz/tree_pane.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <vtkStdString.h>
#include <vtkTextRenderer.h>

#include "viz/node_text.h"

namespace rt::viz
{

namespace
{

RayRole roleOf(RayKind kind)
{
    return kind == RayKind::camera      ? RayRole::camera
           : kind == RayKind::reflected ? RayRole::reflected
                                        : RayRole::transmitted;
}

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

const char* endText(End end)
{
    switch (end)
    {
    case End::cap:
        return "MAXDEPTH";
    case End::none:
        return "";
    default:
        return name(end);
    }
}

std::string plural(std::size_t count, const char* what)
{
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

} // namespace

/// Draws the whole tree but for what follows the pointer.
class TreePainter
{
public:
    TreePainter(TreePane& treePane, Raster& target)
        : pane(treePane), controller(treePane.controller), tree(controller.tree()), layout(treePane.layout),
          raster(target), width(treePane.area.width), height(treePane.area.height), r(treePane.radius()),
          isTiny(r < pane.scale * 1.5), seen(std::size_t(width) * std::size_t(height), 0)
    {
    }

    void paint()
    {
        raster.clear(color::panel);
        paintGuides();
        markPath();
        for (std::size_t i = 0; i < layout.items.size(); ++i)
            if (layout.items[i].parent >= 0 && isDrawn(int(i))) paintEdge(int(i));
        std::fill(seen.begin(), seen.end(), 0);
        paintSelection();
        if (!isTiny) paintHidden();
        // Rays last: they lie over the ends of all edges, and over shadow rays where everything is crowded.
        for (const auto kind : {ItemKind::shadow, ItemKind::notFollowed, ItemKind::ray})
            for (std::size_t i = 0; i < layout.items.size(); ++i)
                if (layout.items[i].kind == kind && isDrawn(int(i))) paintItem(int(i));
        paintLevels();
        paintMarks();
    }

private:
    TreePane& pane;
    const Controller& controller;
    const RayTree& tree;
    const TreeLayout& layout;
    Raster& raster;
    int width, height;
    double r;
    bool isTiny;                     // dots and lines
    std::vector<unsigned char> seen; // of each pixel: what has been drawn there, a bit each
    std::vector<bool> onPath;

    double px(double length) const { return length * pane.scale; }
    const TreeItem& item(int i) const { return layout.items[std::size_t(i)]; }
    const RayTree::Node& nodeOf(const TreeItem& it) const { return tree.nodes[std::size_t(it.node)]; }
    vec2 at(int i) const { return pane.view.toPane(item(i).x, item(i).y); }

    bool isDrawn(int i) const
    {
        const auto& it = item(i);
        if (it.kind == ItemKind::ray) return controller.isShown(it.node);
        if (it.kind == ItemKind::shadow) return controller.isShadowShown(it.index);
        return controller.isShown(it.node);
    }

    bool isReached(int i) const
    {
        const auto& it = item(i);
        if (it.kind == ItemKind::ray) return controller.isReached(it.node);
        if (it.kind == ItemKind::shadow) return controller.isShadowReached(it.index);
        return controller.isCappedReached(it.index);
    }

    RayRole role(const TreeItem& it) const
    {
        if (it.kind == ItemKind::ray) return roleOf(nodeOf(it).kind);
        if (it.kind == ItemKind::notFollowed) return roleOf(tree.capped[std::size_t(it.index)].kind);
        return tree.shadows[std::size_t(it.index)].visible ? RayRole::reaches : RayRole::blocked;
    }

    double weight(const TreeItem& it) const
    {
        double share = largestChannel(nodeOf(it).throughput);
        if (it.kind == ItemKind::notFollowed) share *= tree.capped[std::size_t(it.index)].weight;
        return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 1;
    }

    Rgba ink(int i) const { return isReached(i) ? colorOf(role(item(i))) : faint(colorOf(role(item(i)))); }
    static Rgba faint(const Rgba& color) { return mix(color::panel, color, 0.2); }

    bool isOutside(const vec2& a, const vec2& b, double margin) const
    {
        return std::max(a[0], b[0]) < -margin || std::min(a[0], b[0]) > width + margin ||
               std::max(a[1], b[1]) < -margin || std::min(a[1], b[1]) > height + margin;
    }

    /// True the first time for each pixel and role.
    bool isNew(const vec2& p, RayRole what)
    {
        if (!(p[0] >= 0 && p[1] >= 0 && p[0] < width && p[1] < height)) return false;
        auto& bits = seen[std::size_t(p[1]) * std::size_t(width) + std::size_t(p[0])];
        const auto bit = static_cast<unsigned char>(1 << int(what));
        if (bits & bit) return false;
        bits = static_cast<unsigned char>(bits | bit);
        return true;
    }

    struct Levels
    {
        int begin = 0, end = 0, every = 1; ///< of which there is something to see
    };

    Levels levels() const
    {
        const double unit = layout.sideways ? pane.view.unitX() : pane.view.unitY();
        if (layout.levels < 2) return {};
        int every = 1;
        for (int factor = 2; every * unit < px(17); factor = factor == 2 ? 5 : 2) every *= factor;
        const double first = layout.sideways ? pane.view.toTree(0, 0)[0] : pane.view.toTree(0, height)[1];
        const double last = layout.sideways ? pane.view.toTree(width, 0)[0] : pane.view.toTree(0, 0)[1];
        return {std::max(0, int(first) / every * every), std::min(layout.levels, int(std::max(last, -1.0)) + 1), every};
    }

    void paintGuides()
    {
        const auto [begin, end, every] = levels();
        for (int level = begin; level < end; level += every)
        {
            const auto p = pane.view.toPane(level, level);
            const Rgba guide = mix(color::panel, color::line, 0.55);
            if (layout.sideways)
                raster.line({p[0], 0}, {p[0], double(height)}, 1, guide);
            else
                raster.line({0, p[1]}, {double(width), p[1]}, 1, guide);
        }
    }

    /// Their numbers along the edge.
    void paintLevels()
    {
        if (!pane.depthsAreLevels) return;
        const auto [begin, end, every] = levels();
        for (int level = begin; level < end; level += every)
        {
            const auto p = pane.view.toPane(level, level);
            const vec2 middle = layout.sideways ? vec2{p[0], height - px(43)} : vec2{px(14), p[1]};
            const auto digits = std::to_string(level);
            raster.square(middle, px(4 + 3.0 * double(digits.size())), color::panel.withAlpha(0.85));
            text(middle, digits, Font::sans, 10, color::textFaint);
        }
    }

    /// The way from the root to the selected ray.
    void markPath()
    {
        onPath.assign(layout.items.size(), false);
        const auto* selected = controller.node();
        if (!selected) return;
        int i = layout.ofNode[std::size_t(selected->id)];
        for (const int ancestor : ancestorsOf(layout, i))
        {
            onPath[std::size_t(i)] = true;
            raster.line(at(ancestor), at(i), edgeWidth(i) + px(4), mix(color::panel, color::text, 0.32));
            i = ancestor;
        }
    }

    double edgeWidth(int i) const
    {
        const auto& it = item(i);
        const double most = it.kind == ItemKind::shadow ? px(1.4) : px(0.8 + 3.7 * weight(it));
        return std::min(most, std::max(px(0.6), r * 0.55));
    }

    void paintEdge(int i)
    {
        const auto& it = item(i);
        const vec2 from = at(it.parent), to = at(i);
        if (isOutside(from, to, px(8))) return;
        if (isTiny && !onPath[std::size_t(i)])
        {
            // The lower ends tell one line from another.
            const vec2 clamped{std::clamp(to[0], 0.0, width - 1.0), std::clamp(to[1], 0.0, height - 1.0)};
            if (!isNew(clamped, role(it))) return;
            raster.line(from, to, std::max(px(0.7), 0.6), ink(i).withAlpha(isReached(i) ? 0.55 : 1));
            return;
        }
        const Rgba color = ink(i);
        if (it.kind == ItemKind::shadow && role(it) == RayRole::blocked)
            raster.dashes(from, to, edgeWidth(i), px(3), color);
        else
            raster.line(from, to, edgeWidth(i), color);
        paintHeads(i, from, to, color);
    }

    /// Heads as in the 3D view: two for reflected rays, one and a bar for transmitted ones.
    void paintHeads(int i, const vec2& from, const vec2& to, const Rgba& color)
    {
        const auto& it = item(i);
        const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
        const double head = std::min(px(7), r * 0.8), half = head * 0.52 + edgeWidth(i) * 0.4;
        const double gap = it.kind == ItemKind::shadow ? pane.shadowHalf() : it.kind == ItemKind::ray ? r : px(1);
        if (head < px(3.2) || length < r + gap + 2.6 * head) return;
        const double ux = (to[0] - from[0]) / length, uy = (to[1] - from[1]) / length;
        const auto point = [&](double back, double aside) {
            return vec2{to[0] - back * ux - aside * uy, to[1] - back * uy + aside * ux};
        };
        double tip = gap + px(1.5);
        const auto cone = [&](double size, double wide) {
            raster.convex({point(tip, 0), point(tip + size, wide), point(tip + size, -wide)}, color);
            tip += size;
        };
        if (it.kind == ItemKind::shadow)
        {
            if (role(it) == RayRole::reaches) cone(head * 0.85, half * 0.6);
            return;
        }
        if (it.kind == ItemKind::notFollowed) tip += px(7);
        cone(head, half);
        if (role(it) == RayRole::reflected) cone(head, half);
        if (role(it) == RayRole::transmitted)
            raster.line(point(tip + px(2.4), half), point(tip + px(2.4), -half), px(1.6), color);
    }

    /// Rays that are not shown keep their places.
    void paintHidden()
    {
        for (std::size_t i = 0; i < layout.items.size(); ++i)
            if (layout.items[i].kind == ItemKind::ray && !isDrawn(int(i)))
                raster.disc(at(int(i)), px(1.7), mix(color::panel, color::textFaint, 0.5));
    }

    void paintItem(int i)
    {
        const auto& it = item(i);
        const vec2 p = at(i);
        if (isOutside(p, p, px(90))) return;
        if (isTiny && !isNew(p, role(it))) return;
        const Rgba color = ink(i);
        if (it.kind == ItemKind::shadow)
            paintShadow(i, p, color);
        else if (it.kind == ItemKind::notFollowed)
            paintStub(i, p, color);
        else
            paintRay(i, p, color);
    }

    void paintShadow(int i, const vec2& p, const Rgba& color)
    {
        const double half = pane.shadowHalf();
        raster.square(p, half, color);
        const bool blocked = role(item(i)) == RayRole::blocked;
        const double rim = std::max(px(1.2), half * 0.24);
        if (blocked && half > px(2)) raster.square(p, half - rim, color::panel);
        const auto& shadow = tree.shadows[std::size_t(item(i).index)];
        write(p, 2 * half - (blocked ? 2 * rim : 0), {"L" + subscript(shadow.node), "L"},
              blocked ? color : color::dark);
    }

    /// Two bars across MAXDEPTH, one across a cutoff.
    void paintStub(int i, const vec2& p, const Rgba& color)
    {
        const auto& it = item(i);
        const vec2 from = at(it.parent);
        const double length = std::hypot(p[0] - from[0], p[1] - from[1]), half = std::max(r * 0.6, px(0.8));
        if (!(length > 0)) return;
        const double ux = (p[0] - from[0]) / length, uy = (p[1] - from[1]) / length;
        const auto reason = tree.capped[std::size_t(it.index)].reason;
        for (int bar = 0; bar < (reason == End::cutoff || r < px(3) ? 1 : 2); ++bar)
        {
            const double back = bar * px(4.4);
            const vec2 middle{p[0] - back * ux, p[1] - back * uy};
            raster.line({middle[0] - half * uy, middle[1] + half * ux}, {middle[0] + half * uy, middle[1] - half * ux},
                        px(2), color);
        }
        paintEnd(i, p, endText(reason), px(3));
    }

    void paintRay(int i, const vec2& p, const Rgba& color)
    {
        const auto& node = nodeOf(item(i));
        raster.disc(p, std::max(r, px(0.8)), color);
        const bool isHollow = node.end == End::miss && !node.hit && r > px(3);
        if (isHollow) raster.disc(p, r - std::max(px(1.6), 0.13 * r), color::panel);
        static constexpr const char* letters[] = {"D", "R", "T"};
        const std::string letter = letters[int(node.kind)];
        write(p, 1.86 * r, {letter + subscript(node.id), std::to_string(node.id), letter},
              isHollow       ? color
              : isReached(i) ? color::dark
                             : mix(color::panel, color::text, 0.45));
        if (!controller.hasReturned(node.id)) return; // why it ended is not known before
        std::string why = endText(node.end);
        if (node.end == End::cap || node.end == End::cutoff)
            if (hasStub(i)) why.clear(); // written there
        if (node.tir) why = why.empty() ? "TIR" : "TIR, " + why;
        if (why.empty()) return;
        // Beyond the rings around it.
        const auto* event = controller.current();
        const bool isCurrent = event && itemOf(*event) == i;
        paintEnd(i, p, why, r + (isCurrent ? px(8) : node.id == controller.selected() ? px(3) : 0));
    }

    bool hasStub(int i) const
    {
        for (std::size_t next = std::size_t(i) + 1; next < layout.items.size(); ++next)
        {
            const auto& it = layout.items[next];
            if (it.level <= item(i).level) return false;
            if (it.parent == i && it.kind == ItemKind::notFollowed) return true;
        }
        return false;
    }

    bool isLeaf(int i) const
    {
        return std::size_t(i) + 1 == layout.items.size() || layout.items[std::size_t(i) + 1].parent != i;
    }

    /// Free pixels up to the next item of the same level; a lot if there is none.
    double roomBeside(int i, int step) const
    {
        const auto begin = layout.byLevel.begin() + std::ptrdiff_t(layout.levelStart[std::size_t(item(i).level)]);
        const auto end = layout.byLevel.begin() + std::ptrdiff_t(layout.levelStart[std::size_t(item(i).level) + 1]);
        const auto here = std::lower_bound(begin, end, i);
        if (step < 0 ? here == begin : here + 1 == end) return 1e9;
        const auto a = at(i), b = at(*(here + step));
        const double taken = item(*(here + step)).kind == ItemKind::shadow ? pane.shadowHalf() : r;
        return std::abs(layout.sideways ? a[1] - b[1] : a[0] - b[0]) - taken;
    }

    /// Why the ray went no further, beyond a leaf or beside a node, where there is room.
    void paintEnd(int i, const vec2& p, const std::string& why, double clear)
    {
        if (r < px(4.5)) return;
        constexpr double size = 10;
        const auto& label = pane.word(why, Font::sans, int(std::lround(px(size))));
        const Rgba color = isReached(i) ? color::textDim : faint(color::textDim);
        const double wide = label.width, high = px(size + 1), gap = px(4);
        const double before = roomBeside(i, -1), after = roomBeside(i, 1);
        if (layout.sideways)
        {
            if (isLeaf(i))
            {
                if (std::min(before, after) >= high / 2)
                    text({p[0] + clear + gap + wide / 2, p[1]}, why, Font::sans, size, color);
                return;
            }
            // Away from the edge that comes in.
            const bool below = item(i).parent >= 0 && at(item(i).parent)[1] > p[1];
            if (wide > 1.7 * pane.view.unitX() || (below ? after : before) < clear + high + gap) return;
            text({p[0], p[1] + (below ? -1 : 1) * (clear + gap / 2 + high / 2)}, why, Font::sans, size, color);
            return;
        }
        if (isLeaf(i))
        {
            if (std::min(before, after) >= wide / 2 + gap)
                text({p[0], p[1] - clear - high * 0.8}, why, Font::sans, size, color);
            return;
        }
        const bool left = item(i).parent >= 0 && at(item(i).parent)[0] > p[0];
        const double reach = clear + gap + wide;
        if ((left ? before : after) < reach + gap || (left ? p[0] < reach + px(26) : p[0] + reach > width)) return;
        text({p[0] + (left ? -1 : 1) * (clear + gap + wide / 2), p[1] + px(0.5)}, why, Font::sans, size, color);
    }

    void paintSelection()
    {
        if (const auto* event = controller.current())
        {
            const int i = itemOf(*event);
            raster.disc(at(i), std::max(r, px(3)) + px(9), color::accent.withAlpha(0.38));
        }
        if (const auto* node = controller.node())
        {
            const vec2 p = at(layout.ofNode[std::size_t(node->id)]);
            raster.disc(p, std::max(r, px(2)) + px(3.6), color::text);
            raster.disc(p, std::max(r, px(2)) + px(1.4), color::panel);
            if (isTiny) raster.ring(p, px(9), px(1.6), color::text);
        }
    }

    int itemOf(const Event& event) const
    {
        if (event.kind == Event::Kind::shadow) return layout.ofShadow[std::size_t(event.index)];
        if (event.kind == Event::Kind::notFollowed) return layout.ofNotFollowed[std::size_t(event.index)];
        return layout.ofNode[std::size_t(event.node)];
    }

    /// What lies over everything: the current event, and what differs from the other tree.
    void paintMarks()
    {
        if (const auto* event = controller.current())
        {
            const vec2 p = at(itemOf(*event));
            raster.ring(p, std::max(r, px(3)) + px(6.5), px(2), color::accent);
            if (event->kind == Event::Kind::returns) paintReturn(p);
        }
        const auto* comparison = controller.comparison();
        if (!comparison) return;
        for (std::size_t id = 0; id < tree.nodes.size(); ++id)
        {
            const int i = layout.ofNode[id];
            const vec2 p = at(i);
            if (isOutside(p, p, px(40)) || !controller.isShown(int(id))) continue;
            const bool isMissing = comparison->match.gotOf[id] < 0;
            if (comparison->match.differs[id]) paintDifference(p, isMissing);
            if (pane.extra[id] > 0 && r > px(4))
                text({p[0] + r * 0.9 + px(8), p[1] - r * 0.9}, fmt::format("+{}", pane.extra[id]), Font::bold, 10,
                     color::warning);
        }
        if (comparison->first && comparison->first->expectedNode >= 0)
            flag(at(layout.ofNode[std::size_t(comparison->first->expectedNode)]), comparison->first->field);
    }

    /// A ring with four ticks, or with a cross where the other tree lacks the ray.
    void paintDifference(const vec2& p, bool isMissing)
    {
        const double radius = std::max(r, px(1.5)) + px(isTiny ? 1.5 : 3);
        raster.ring(p, radius, px(2), color::warning);
        if (isTiny) return;
        if (isMissing)
            return text({p[0] + r * 0.8 + px(6), p[1] - r * 0.8 - px(2)}, "×", Font::bold, 13, color::warning);
        for (const double dx : {-0.7, 0.7})
            for (const double dy : {-0.7, 0.7})
                raster.line({p[0] + dx * radius, p[1] + dy * radius},
                            {p[0] + dx * (radius + px(5)), p[1] + dy * (radius + px(5))}, px(2), color::warning);
    }

    /// An arrow back to where the ray came from.
    void paintReturn(const vec2& p)
    {
        const double far = std::max(r, px(3)) + px(9), size = px(7);
        if (layout.sideways)
            raster.convex({{p[0] - far - size, p[1]}, {p[0] - far, p[1] - size * 0.7}, {p[0] - far, p[1] + size * 0.7}},
                          color::accent);
        else
            raster.convex({{p[0], p[1] + far + size}, {p[0] - size * 0.7, p[1] + far}, {p[0] + size * 0.7, p[1] + far}},
                          color::accent);
    }

    /// The name of the first difference, on a pole beside the ray.
    void flag(const vec2& p, const std::string& field)
    {
        const std::string label = "first difference: " + field;
        const auto& ink = pane.word(label, Font::bold, int(std::lround(px(10.5))));
        const double wide = ink.width + px(12), high = px(18), rise = std::max(r, px(2)) + px(9);
        const bool left = p[0] + px(6) + wide > width;
        const bool low = p[1] + rise + high > height - px(36);
        const double x = left ? std::max(px(2), p[0] - px(4) - wide) : p[0] + px(4);
        const double y = low ? p[1] - rise - high : p[1] + rise;
        raster.line({p[0], p[1] + (low ? -1 : 1) * (std::max(r, px(2)) + px(3))}, {p[0], low ? y : y + high}, px(1.6),
                    color::warning);
        raster.convex({{x, y}, {x + wide, y}, {x + wide, y + high}, {x, y + high}}, color::warning);
        text({x + wide / 2, y + high / 2}, label, Font::bold, 10.5, color::dark);
    }

    /// The first of the texts that fits into the width.
    void write(const vec2& p, double room, const std::vector<std::string>& texts, const Rgba& color)
    {
        const int size = int(std::min(px(12.5), room * 0.52));
        if (size < std::max(7.0, px(6.5))) return;
        for (const auto& choice : texts)
        {
            const auto& label = pane.word(choice, Font::bold, size);
            if (label.width > room * 0.92) continue;
            stamp(p, label, color);
            return;
        }
    }

    void text(const vec2& middle, const std::string& text, Font font, double size, const Rgba& color)
    {
        stamp(middle, pane.word(text, font, std::max(7, int(std::lround(px(size))))), color);
    }

    void stamp(const vec2& middle, const TreePane::Word& label, const Rgba& color)
    {
        const int x0 = int(std::lround(middle[0] - label.width / 2.0));
        const int y0 = int(std::lround(middle[1] - label.height / 2.0));
        for (int y = 0; y < label.height; ++y)
            for (int x = 0; x < label.width; ++x)
                raster.blend(x0 + x, y0 + y, color,
                             label.coverage[std::size_t(y) * std::size_t(label.width) + std::size_t(x)] / 255.0);
    }
};

TreePane::TreePane(Controller& watched) : Pane(watched)
{
    rebuild();
}

const TreePane::Word& TreePane::word(const std::string& text, Font font, int size)
{
    if (words.size() > 20'000) words.clear(); // a user who looks at everything in a large tree
    const auto [entry, isNew] = words.try_emplace(fmt::format("{}/{}/{}", int(font), size, text));
    auto& word = entry->second;
    if (!isNew) return word;
    vtkNew<vtkTextProperty> property;
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(fontFile(font).c_str());
    property->SetFontSize(size);
    property->SetColor(1, 1, 1);
    vtkNew<vtkImageData> image;
    int used[2] = {0, 0};
    if (!vtkTextRenderer::GetInstance()->RenderString(property, vtkStdString(text), image, used, 72)) return word;
    int whole[3];
    image->GetDimensions(whole);
    const auto* pixels = static_cast<const Rgba*>(image->GetScalarPointer());
    int left = whole[0], right = -1, low = whole[1], high = -1;
    for (int y = 0; y < whole[1]; ++y)
        for (int x = 0; x < whole[0]; ++x)
            if (pixels[y * whole[0] + x].a > 0)
            {
                left = std::min(left, x);
                right = std::max(right, x);
                low = std::min(low, y);
                high = std::max(high, y);
            }
    if (right < left) return word;
    word.width = right - left + 1;
    word.height = high - low + 1;
    for (int y = low; y <= high; ++y)
        for (int x = left; x <= right; ++x) word.coverage.push_back(pixels[y * whole[0] + x].a);
    return word;
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
    TreePainter(*this, raster).paint();
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
    canvas.fill({0, area.height - 1.0, double(area.width), 1}, color::line);
    canvas.fill({area.width - 1.0, 0, 1, double(area.height)}, color::line);
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
    canvas.fill({0, 0, area.width - 1.0, high}, color::panel);
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
    canvas.roundedBox({box.x - 1, box.y - 1, box.width + 2, box.height + 2}, canvas.px(6), color::textFaint);
    canvas.roundedBox(box, canvas.px(6), color::panelRaised);
    for (std::size_t i = 0; i < lines.size(); ++i)
        canvas.text(box.x + pad, box.y + box.height - canvas.px(5) - row * (double(i) + 0.5), lines[i], lookOf(i));
}

} // namespace rt::viz
