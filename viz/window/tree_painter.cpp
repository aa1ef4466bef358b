#include "viz/window/tree_painter.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "viz/drawing/labels.h"
#include "viz/state/node_text.h"

namespace rt::viz
{

namespace
{

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

/// Draws the whole tree but for what follows the pointer.
class TreePainter
{
public:
    TreePainter(const TreePicture& shown, Raster& target)
        : picture(shown), controller(shown.controller), tree(controller.tree()), layout(shown.layout), raster(target),
          width(shown.width), height(shown.height), r(shown.radius), isTiny(r < shown.scale * 1.5),
          seen(std::size_t(width) * std::size_t(height), 0)
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
    const TreePicture& picture;
    const Controller& controller;
    const RayTree& tree;
    const TreeLayout& layout;
    Raster& raster;
    int width, height;
    double r;
    bool isTiny;                     // dots and lines
    std::vector<unsigned char> seen; // of each pixel: what has been drawn there, a bit each
    std::vector<bool> onPath;
    std::vector<Box> written; // end reasons: they keep clear of one another

    static constexpr double endSize = 10;

    double px(double length) const { return length * picture.scale; }
    const TreeItem& item(int i) const { return layout.items[std::size_t(i)]; }
    const RayTree::Node& nodeOf(const TreeItem& it) const { return tree.nodes[std::size_t(it.node)]; }
    vec2 at(int i) const { return picture.view.toPane(item(i).x, item(i).y); }

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
        if (it.kind == ItemKind::ray) return rayRole(nodeOf(it).kind);
        if (it.kind == ItemKind::notFollowed) return rayRole(tree.capped[std::size_t(it.index)].kind);
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
        const double unit = layout.sideways ? picture.view.unitX() : picture.view.unitY();
        if (layout.levels < 2) return {};
        int every = 1;
        for (int factor = 2; every * unit < px(17); factor = factor == 2 ? 5 : 2) every *= factor;
        const double first = layout.sideways ? picture.view.toTree(0, 0)[0] : picture.view.toTree(0, height)[1];
        const double last = layout.sideways ? picture.view.toTree(width, 0)[0] : picture.view.toTree(0, 0)[1];
        return {std::max(0, int(first) / every * every), std::min(layout.levels, int(std::max(last, -1.0)) + 1), every};
    }

    void paintGuides()
    {
        const auto [begin, end, every] = levels();
        for (int level = begin; level < end; level += every)
        {
            const auto p = picture.view.toPane(level, level);
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
        if (!picture.depthsAreLevels) return;
        const auto [begin, end, every] = levels();
        for (int level = begin; level < end; level += every)
        {
            const auto p = picture.view.toPane(level, level);
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
        const double gap = it.kind == ItemKind::shadow ? picture.shadowHalf : it.kind == ItemKind::ray ? r : px(1);
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
        const double half = picture.shadowHalf;
        raster.square(p, half, color);
        const bool blocked = role(item(i)) == RayRole::blocked;
        const double rim = std::max(px(1.2), half * 0.24);
        if (blocked && half > px(2)) raster.square(p, half - rim, color::panel);
        const auto& shadow = tree.shadows[std::size_t(item(i).index)];
        write(p, 2 * half - (blocked ? 2 * rim : 0), {"L" + subscript(shadow.light), "L"},
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
        const double taken = item(*(here + step)).kind == ItemKind::shadow ? picture.shadowHalf : r;
        return std::abs(layout.sideways ? a[1] - b[1] : a[0] - b[0]) - taken;
    }

    /// Why the ray went no further, beyond a leaf or beside a node, where there is room.
    void paintEnd(int i, const vec2& p, const std::string& why, double clear)
    {
        if (r < px(4.5)) return;
        const auto& label = picture.words(why, Font::sans, int(std::lround(px(endSize))));
        const Rgba color = isReached(i) ? color::textDim : faint(color::textDim);
        const double wide = label.width, high = px(endSize + 1), gap = px(4);
        const double before = roomBeside(i, -1), after = roomBeside(i, 1);
        if (layout.sideways)
        {
            if (isLeaf(i))
            {
                if (std::min(before, after) >= high / 2) end({p[0] + clear + gap + wide / 2, p[1]}, why, wide, color);
                return;
            }
            // Away from the edge that comes in.
            const bool below = item(i).parent >= 0 && at(item(i).parent)[1] > p[1];
            if (wide > 1.7 * picture.view.unitX() || (below ? after : before) < clear + high + gap) return;
            end({p[0], p[1] + (below ? -1 : 1) * (clear + gap / 2 + high / 2)}, why, wide, color);
            return;
        }
        if (isLeaf(i))
        {
            if (std::min(before, after) >= wide / 2 + gap) end({p[0], p[1] - clear - high * 0.8}, why, wide, color);
            return;
        }
        const bool left = item(i).parent >= 0 && at(item(i).parent)[0] > p[0];
        const double reach = clear + gap + wide;
        if ((left ? before : after) < reach + gap || (left ? p[0] < reach + px(26) : p[0] + reach > width)) return;
        end({p[0] + (left ? -1 : 1) * (clear + gap + wide / 2), p[1] + px(0.5)}, why, wide, color);
    }

    void end(const vec2& middle, const std::string& why, double wide, const Rgba& color)
    {
        const Box box{middle[0] - wide / 2, middle[1] - px(5), wide, px(10)};
        if (std::any_of(written.begin(), written.end(), [&](const Box& other) { return box.overlaps(other, 1); }))
            return;
        written.push_back(box);
        text(middle, why, Font::sans, endSize, color);
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
            if (picture.extra[id] > 0 && r > px(4))
                text({p[0] + r * 0.9 + px(8), p[1] - r * 0.9}, fmt::format("+{}", picture.extra[id]), Font::bold, 10,
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
        const auto& ink = picture.words(label, Font::bold, int(std::lround(px(10.5))));
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
            const auto& label = picture.words(choice, Font::bold, size);
            if (label.width > room * 0.92) continue;
            stamp(p, label, color);
            return;
        }
    }

    void text(const vec2& middle, const std::string& text, Font font, double size, const Rgba& color)
    {
        stamp(middle, picture.words(text, font, std::max(7, int(std::lround(px(size))))), color);
    }

    void stamp(const vec2& middle, const Words::Word& label, const Rgba& color)
    {
        const int x0 = int(std::lround(middle[0] - label.width / 2.0));
        const int y0 = int(std::lround(middle[1] - label.height / 2.0));
        for (int y = 0; y < label.height; ++y)
            for (int x = 0; x < label.width; ++x)
                raster.blend(x0 + x, y0 + y, color,
                             label.coverage[std::size_t(y) * std::size_t(label.width) + std::size_t(x)] / 255.0);
    }
};

} // namespace

void paintTree(const TreePicture& picture, Raster& raster)
{
    TreePainter(picture, raster).paint();
}

} // namespace rt::viz
