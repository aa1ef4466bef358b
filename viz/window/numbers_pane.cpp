#include "viz/window/numbers_pane.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/base/image.h"
#include "viz/state/node_text.h"

namespace rt::viz
{

bool NumbersPane::update(unsigned changes)
{
    if (changes & (changedTree | changedNode)) scrolled = 0;
    return changes & (changedTree | changedNode | changedStep | changedHover) || changes == changedAll;
}

bool NumbersPane::click(int x, int y)
{
    for (const auto& [box, node] : chips)
        if (x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height) controller.selectNode(node);
    return false;
}

void NumbersPane::hover(int x, int y)
{
    for (const auto& [box, node] : chips)
        if (x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height) return controller.hover(node);
    controller.hover(-1);
}

void NumbersPane::leave()
{
    controller.hover(-1);
}

bool NumbersPane::wheel(int, int, bool forward)
{
    const double before = scrolled;
    scrolled = std::clamp(scrolled + (forward ? -54 : 54) * scale, 0.0, overflow);
    return scrolled != before;
}

/// One chip a node around the selected one, so that there is something to click and to count.
double NumbersPane::paintChips(Canvas& canvas, double top)
{
    chips.clear();
    const auto& nodes = controller.tree().nodes;
    const double height = canvas.px(23), gap = canvas.px(5), pad = canvas.px(16), y = top - height / 2;
    const TextLook look{Font::bold, 12, color::text};
    const double width = std::max(canvas.px(30), canvas.textWidth(std::to_string(nodes.size()), look) + canvas.px(14));
    const int count = int(nodes.size());
    const int fit = std::max(1, int((area.width - 2 * pad - canvas.px(40)) / (width + gap)));
    const int first = std::clamp(controller.selected() - fit / 2, 0, std::max(0, count - fit));
    const int last = std::min(count, first + fit);
    double x = pad;
    if (first > 0) x += canvas.text(x, y, "…", look) + gap;
    for (int id = first; id < last; ++id)
    {
        const bool chosen = id == controller.selected();
        const Rgba kind = colorOf(rayRole(nodes[std::size_t(id)].kind));
        const Box box{x, y - height / 2, width, height};
        const bool isHovered = id == controller.hovered();
        canvas.roundedBox(box, canvas.px(5),
                          chosen      ? kind
                          : isHovered ? mix(color::panelRaised, color::text, 0.2)
                                      : color::panelRaised);
        if (!chosen) canvas.fill({x + canvas.px(5), box.y + canvas.px(2), width - canvas.px(10), canvas.px(2)}, kind);
        const auto number = std::to_string(id);
        const TextLook ink{Font::bold, 12, chosen ? color::dark : color::text};
        canvas.text(x + (width - canvas.textWidth(number, ink)) / 2, y, number, ink);
        chips.push_back({box, id});
        x += width + gap;
    }
    if (last < count) canvas.text(x, y, "…", look);
    return height;
}

void NumbersPane::paintHeading(Canvas& canvas, double top)
{
    const auto* node = controller.node();
    if (!node) return;
    const double pad = canvas.px(16), y = top - canvas.px(11);
    const TextLook look{Font::bold, 15, colorOf(rayRole(node->kind))}, value{Font::mono, 12.5, color::textDim};
    const double swatch = canvas.px(15);
    const auto brings = shortText(node->radiance);
    const double right = area.width - pad - swatch;
    const auto heading = nodeHeading(controller.tree(), *node);
    // While stepping nobody knows yet what it will bring.
    if (!controller.hasReturned(node->id))
    {
        const double end = pad + canvas.textWithin(pad, y, area.width - 2 * pad, heading, look) + canvas.px(12);
        const TextLook dim{Font::sans, 12.5, color::textDim};
        for (const char* said : {"has not returned yet", "not yet back"})
            if (end + canvas.textWidth(said, dim) < area.width - pad)
            {
                canvas.text(end, y, said, dim);
                break;
            }
        return;
    }
    canvas.roundedBox({right, y - swatch / 2, swatch, swatch}, canvas.px(3),
                      {toSrgb8(node->radiance.x), toSrgb8(node->radiance.y), toSrgb8(node->radiance.z)});
    const double start = right - canvas.px(8) - canvas.textWidth(brings, value);
    const double end = pad + canvas.textWithin(pad, y, right - pad - canvas.px(8), heading, look);
    if (end + canvas.px(12) < start) canvas.text(start, y, brings, value);
}

void NumbersPane::paint(Canvas& canvas)
{
    const double pad = canvas.px(16), size = 12.5, width = area.width, indent = canvas.px(12);
    const auto columns = std::size_t(std::max(12.0, (width - 2 * pad - indent) / canvas.monoWidth(size)));
    const auto lines = nodeText(controller, columns);
    const double head = canvas.px(14) + canvas.px(23) + canvas.px(12) + canvas.px(28);
    const double lineHeight = canvas.px(18), titleGap = canvas.px(7);

    double whole = 0;
    for (const auto& line : lines) whole += lineHeight + (line.style == TextStyle::title ? titleGap : 0);
    overflow = std::max(0.0, whole + canvas.px(10) - (area.height - head));
    scrolled = std::min(scrolled, overflow);

    double y = area.height - head - canvas.px(2) + scrolled;
    for (const auto& line : lines)
    {
        if (line.style == TextStyle::title) y -= titleGap;
        const double middle = y - lineHeight / 2;
        y -= lineHeight;
        if (middle > area.height - head + lineHeight || middle < 0.4 * lineHeight) continue;
        switch (line.style)
        {
        case TextStyle::title:
        {
            const double end = pad + canvas.text(pad, middle, line.text, {Font::bold, 12.5, color::accent});
            canvas.text(end + canvas.px(12), middle, line.besides, {Font::mono, size, color::text});
            break;
        }
        case TextStyle::symbolic:
            canvas.text(pad + indent, middle, line.text, {Font::mono, size, color::text});
            break;
        case TextStyle::numbers:
            canvas.text(pad + indent, middle, line.text, {Font::mono, size, color::textDim});
            break;
        case TextStyle::note:
            canvas.text(pad, middle, line.text, {Font::sans, 12.5, colorOf(RayRole::reflected)});
            break;
        }
    }

    // The head lies over what scrolls.
    canvas.fill({0, area.height - head, width, head}, color::panel);
    paintHeading(canvas, area.height - canvas.px(14) - paintChips(canvas, area.height - canvas.px(14)) - canvas.px(12));
    canvas.fill({pad, area.height - head, width - 2 * pad, canvas.hair()}, color::line);
    if (overflow > 0)
    {
        const double track = area.height - head - canvas.px(8),
                     bar = std::max(canvas.px(24), track * track / (track + overflow));
        const double top = area.height - head - canvas.px(4) - (track - bar) * scrolled / overflow;
        canvas.roundedBox({width - canvas.px(9), top - bar, canvas.px(4), bar}, canvas.px(2), color::textFaint);
    }
    paintEdges(canvas);
}

} // namespace rt::viz
