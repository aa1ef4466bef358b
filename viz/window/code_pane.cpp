#include "viz/window/code_pane.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "common/base/image.h"
#include "common/program/program.h"
#include "viz/state/node_text.h"

namespace rt::viz
{

namespace
{

constexpr double size = 12.5;

Rgba inkColor(Ink ink)
{
    switch (ink)
    {
    case Ink::keyword:
        return color::keyword;
    case Ink::type:
        return color::type;
    case Ink::literal:
        return color::literal;
    case Ink::comment:
        return color::comment;
    case Ink::instrument:
        return color::textFaint;
    case Ink::plain:
        break;
    }
    return color::text;
}

RayRole roleOf(const RayTree& tree, const Event& event)
{
    if (event.kind == Event::Kind::shadow)
        return tree.shadows[std::size_t(event.index)].visible ? RayRole::reaches : RayRole::blocked;
    const auto kind = event.kind == Event::Kind::notFollowed ? tree.capped[std::size_t(event.index)].kind
                                                             : tree.nodes[std::size_t(event.node)].kind;
    return rayRole(kind);
}

/// What happened in the lit line, short enough to stand at its end.
std::string noteOf(const RayTree& tree, const Event& event)
{
    const auto& node = tree.nodes[std::size_t(event.node)];
    switch (event.kind)
    {
    case Event::Kind::follow:
        return node.hit ? fmt::format("{}  t = {:.4g}", node.hit->primitive, node.hit->t) : "nothing is hit";
    case Event::Kind::shadow:
    {
        const auto& shadow = tree.shadows[std::size_t(event.index)];
        return shadow.visible   ? fmt::format("light {}: visible", shadow.light)
               : shadow.blocker ? fmt::format("light {}: behind {}", shadow.light, shadow.blocker->primitive)
                                : fmt::format("light {}: not visible", shadow.light);
    }
    case Event::Kind::notFollowed:
        return tree.capped[std::size_t(event.index)].reason == End::cutoff
                   ? "too weak"
                   : fmt::format("depth {} > {}", node.depth + 1, tree.maxDepth);
    case Event::Kind::returns:
        break;
    }
    const auto& c = node.radiance;
    return fmt::format("({:.3g}, {:.3g}, {:.3g})", c.x, c.y, c.z);
}

/// "[0] › [2] › [5]": the calls that are open.
std::string stackOf(const RayTree& tree, int node)
{
    std::vector<int> ids;
    while (node >= 0 && ids.size() < 64)
    {
        ids.push_back(node);
        node = tree.nodes[std::size_t(node)].parent;
    }
    std::string text;
    for (std::size_t i = ids.size(); i-- > 0;)
        if (i + 1 == ids.size() || i < 4)
            text += fmt::format("{}[{}]", text.empty() ? "" : " › ", ids[i]);
        else if (i == 4)
            text += " › …";
    return text;
}

} // namespace

CodePane::CodePane(Controller& watched) : Pane(watched)
{
    update(changedAll);
}

bool CodePane::update(unsigned changes)
{
    const auto& source = controller.tree().source;
    if ((changes & changedTree) && (source != listing.source || listing.lines.empty()))
        listing = readListing(source, projectFile(""));
    if (!(changes & (changedTree | changedNode | changedStep))) return changes == changedAll;
    scrolledTo.reset();
    return true;
}

bool CodePane::wheel(int, int, bool forward)
{
    const int last = std::max(1, int(listing.lines.size()) - shownCount + 1);
    scrolledTo = std::clamp(shownFirst + (forward ? -3 : 3), 1, last);
    return *scrolledTo != shownFirst;
}

int CodePane::litLine() const
{
    if (const auto* event = controller.current()) return event->line;
    return controller.node() ? controller.node()->line : 0;
}

int CodePane::returnLine() const
{
    const auto* node = controller.node();
    return node && controller.hasReturned(node->id) ? node->returnLine : 0;
}

void CodePane::paintHeading(Canvas& canvas, double height)
{
    const double pad = canvas.px(14), top = area.height, width = area.width;
    const double first = top - canvas.px(16), second = top - canvas.px(35);
    const auto& tree = controller.tree();
    const TextLook bold{Font::bold, 13, color::text}, dim{Font::sans, 12, color::textDim};
    canvas.fill({0, top - height, width, height}, color::panel);

    const auto* event = controller.current();
    std::string step = event                    ? fmt::format("step {} of {}", controller.step(), controller.lastStep())
                       : controller.step() == 0 ? fmt::format("step 0 of {}", controller.lastStep())
                       : controller.lastStep() == 0 ? ""
                                                    : fmt::format("{} steps", controller.lastStep());
    const double stepWidth = canvas.textWidth(step, bold);
    canvas.text(width - pad - stepWidth, first, step, {Font::bold, 13, event ? color::accent : color::textDim});
    const auto file = listing.missing.empty() ? listing.source : std::string("source");
    const double room = width - 2 * pad - stepWidth - canvas.px(14);
    double end = canvas.textWithin(pad, first, room, file, bold);

    const auto* node = controller.node();
    if (!node) return;
    // The calls that are open, if there is room behind the file's name.
    const auto stack = stackOf(tree, node->id);
    if (node->parent >= 0 && end + canvas.px(16) + canvas.textWidth(stack, dim) < room)
        canvas.text(pad + end + canvas.px(16), first, stack, dim);

    if (event)
    {
        const Rgba kind = colorOf(roleOf(tree, *event));
        canvas.textWithin(pad, second, width - 2 * pad, describe(tree, *event), {Font::sans, 12.5, kind});
        return;
    }
    std::string said;
    if (controller.step() == 0 && controller.lastStep() > 0)
        said = "before the first step: nothing has been traced";
    else if (node->line > 0 && returnLine() > 0)
        said =
            fmt::format("ray [{}] was followed in line {} and returned in line {}", node->id, node->line, returnLine());
    else if (node->line > 0)
        said = fmt::format("ray [{}] was followed in line {}", node->id, node->line);
    canvas.textWithin(pad, second, width - 2 * pad, said, dim);
}

/// At the right end of the lit line: what happened there.
void CodePane::paintNote(Canvas& canvas, double y, double textEnd, double lineHeight)
{
    const auto& tree = controller.tree();
    Event event;
    if (const auto* now = controller.current())
        event = *now;
    else if (const auto* node = controller.node())
        event.node = node->id;
    else
        return;
    const auto role = roleOf(tree, event);
    const TextLook look{Font::bold, 11, color::dark};
    const auto note = noteOf(tree, event);
    const bool withSwatch = event.kind == Event::Kind::returns;
    const double swatch = withSwatch ? canvas.px(12) : 0, height = std::min(lineHeight - 1, canvas.px(16));
    const double width = canvas.textWidth(note, look) + canvas.px(14) + (withSwatch ? swatch + canvas.px(5) : 0);
    const double x = area.width - canvas.px(16) - width;
    if (x < canvas.px(60)) return;
    if (textEnd > x - canvas.px(10))
        canvas.fill({x - canvas.px(10), y - lineHeight / 2, area.width - x + canvas.px(10), lineHeight}, color::lit);
    canvas.roundedBox({x, y - height / 2, width, height}, canvas.px(5), colorOf(role));
    double at = x + canvas.px(7);
    if (withSwatch)
    {
        const auto& c = tree.nodes[std::size_t(event.node)].radiance;
        canvas.fill({at, y - swatch / 2, swatch, swatch}, {toSrgb8(c.x), toSrgb8(c.y), toSrgb8(c.z)});
        at += swatch + canvas.px(5);
    }
    canvas.text(at, y, note, look);
}

void CodePane::paintLines(Canvas& canvas, double height)
{
    const double lineHeight = std::round(canvas.px(16.5)), pad = canvas.px(14);
    const double character = canvas.monoWidth(size);
    shownCount = std::max(1, int((height - canvas.px(6)) / lineHeight));
    const int lit = litLine(), returned = controller.current() ? 0 : returnLine();
    const int all = int(listing.lines.size());
    shownFirst = scrolledTo ? std::min(*scrolledTo, std::max(1, all - shownCount + 1))
                            : firstShown(listing, lit, shownCount, returned);

    const double gutter = canvas.px(10) + character * std::max(3.0, std::floor(std::log10(all) + 1));
    const double left = gutter + pad;
    // The function stands at the left edge, whatever it is a member of.
    const auto function = functionAround(listing, lit);
    std::size_t indent = 0;
    if (function.contains(lit)) indent = listing.lines[std::size_t(function.first) - 1].find_first_not_of(' ');
    const auto columns = std::size_t(std::max(1.0, (area.width - left - canvas.px(12)) / character));
    const Rgba kind = controller.current() ? colorOf(roleOf(controller.tree(), *controller.current()))
                      : controller.node()  ? colorOf(rayRole(controller.node()->kind))
                                           : color::accent;
    for (int row = 0; row < shownCount && shownFirst + row <= all; ++row)
    {
        const int number = shownFirst + row;
        const double y = height - canvas.px(4) - (row + 0.5) * lineHeight;
        const bool isLit = number == lit;
        if (isLit || number == returned)
        {
            canvas.fill({0, y - lineHeight / 2, double(area.width), lineHeight},
                        isLit ? color::lit : mix(color::panel, color::lit, 0.45));
            canvas.fill({0, y - lineHeight / 2, canvas.px(isLit ? 4 : 2), lineHeight}, kind);
        }
        const auto label = std::to_string(number);
        canvas.text(gutter - character * double(label.size()), y, label,
                    {Font::mono, size, isLit ? color::text : color::textFaint});

        std::size_t column = 0, hidden = indent;
        for (const auto& [ink, text] : listing.inked[std::size_t(number) - 1])
        {
            // What begins with blanks is moved instead: less to draw.
            const auto blank = std::min(text.find_first_not_of(' '), text.size());
            auto piece = text.substr(blank);
            const auto start = column + blank - std::min(hidden, blank), length = characters(piece);
            hidden -= std::min(hidden, blank);
            if (length > 0) hidden = 0;
            column = start + length;
            if (start >= columns || piece.empty()) continue;
            piece = shorten(piece, columns - start);
            canvas.text(left + character * double(start), y, piece,
                        {Font::mono, size, isLit ? color::text : inkColor(ink)});
        }
        const double textEnd = left + character * double(std::min(column, columns));
        if (isLit)
            paintNote(canvas, y, textEnd, lineHeight);
        else if (number == returned && textEnd + canvas.px(90) < area.width)
        {
            const TextLook look{Font::sans, 11, color::textDim};
            const char* said = "returned here";
            canvas.text(area.width - canvas.px(16) - canvas.textWidth(said, look), y, said, look);
        }
    }
    if (all > shownCount)
    {
        const double track = height - canvas.px(8), bar = std::max(canvas.px(20), track * shownCount / all);
        const double top = height - canvas.px(4) - (track - bar) * (shownFirst - 1) / std::max(1, all - shownCount);
        canvas.roundedBox({area.width - canvas.px(8), top - bar, canvas.px(4), bar}, canvas.px(2),
                          color::textFaint.withAlpha(0.6));
    }
}

void CodePane::paint(Canvas& canvas)
{
    const double heading = canvas.px(48), width = area.width;
    if (listing.missing.empty())
        paintLines(canvas, area.height - heading);
    else
    {
        double y = area.height - heading - canvas.px(22);
        const auto columns = std::size_t(std::max(10.0, (width - canvas.px(28)) / canvas.monoWidth(12.5)));
        for (const auto& line : wrap(listing.missing, columns))
        {
            canvas.text(canvas.px(14), y, line, {Font::sans, 12.5, color::textDim});
            y -= canvas.px(18);
        }
    }
    paintHeading(canvas, heading);
    canvas.fill({0, area.height - heading, width, canvas.hair()}, color::line);
    paintEdges(canvas);
}

} // namespace rt::viz
