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

TextLook noteLook()
{
    return {Font::bold, 11, color::dark}; // of the look that is worn now
}

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
    {
        listing = readListing(source, projectFile(""));
        algorithm = AlgorithmLines(listing);
    }
    if (!(changes & (changedTree | changedNode | changedStep))) return changes == changedAll;
    scrolledTo.reset();
    return true;
}

bool CodePane::wheel(int, int, bool forward)
{
    scrolledTo = std::clamp(shownFirst + (forward ? -3 : 3), 0, std::max(0, rowCount - shownCount));
    return *scrolledTo != shownFirst;
}

int CodePane::followLine() const
{
    return controller.node() ? algorithm.of(controller.node()->line, Told::value) : 0;
}

int CodePane::returnLine() const
{
    const auto* node = controller.node();
    return node && controller.hasReturned(node->id) ? algorithm.of(node->returnLine, Told::end) : 0;
}

int CodePane::litLine() const
{
    const auto* event = controller.current();
    return event ? algorithm.of(*event) : followLine();
}

std::pair<int, const char*> CodePane::otherLine() const
{
    if (const auto* event = controller.current()) return {algorithm.callOf(controller.tree(), *event), "called here"};
    return {returnLine(), "returned here"};
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
        said = fmt::format("ray [{}] was followed in line {} and returned in line {}", node->id, followLine(),
                           returnLine());
    else if (node->line > 0)
        said = fmt::format("ray [{}] was followed in line {}", node->id, followLine());
    canvas.textWithin(pad, second, width - 2 * pad, said, dim);
}

Event CodePane::notedEvent() const
{
    if (const auto* now = controller.current()) return *now;
    Event event;
    event.node = controller.node() ? controller.node()->id : -1;
    return event;
}

double CodePane::noteWidth(Canvas& canvas) const
{
    const auto event = notedEvent();
    if (event.node < 0) return 0;
    const double swatch = event.kind == Event::Kind::returns ? canvas.px(17) : 0;
    return canvas.textWidth(noteOf(controller.tree(), event), noteLook()) + canvas.px(14) + swatch;
}

/// At the right end of the lit line: what happened there.
void CodePane::paintNote(Canvas& canvas, double y)
{
    const auto& tree = controller.tree();
    const auto event = notedEvent();
    if (event.node < 0) return;
    const double swatch = canvas.px(12), height = canvas.px(15.5), width = noteWidth(canvas);
    const double x = area.width - canvas.px(16) - width;
    if (x < canvas.px(60)) return;
    canvas.roundedBox({x, y - height / 2, width, height}, canvas.px(5), colorOf(roleOf(tree, event)));
    double at = x + canvas.px(7);
    if (event.kind == Event::Kind::returns)
    {
        const auto& c = tree.nodes[std::size_t(event.node)].radiance;
        canvas.fill({at, y - swatch / 2, swatch, swatch}, {toSrgb8(c.x), toSrgb8(c.y), toSrgb8(c.z)});
        at += canvas.px(17);
    }
    canvas.text(at, y, noteOf(tree, event), noteLook());
}

void CodePane::paintRow(Canvas& canvas, const CodeRow& row, double left, double y, bool isLit)
{
    const double character = canvas.monoWidth(size);
    std::size_t column = row.column;
    for (const auto& [ink, text] : row.pieces)
    {
        // What begins with blanks is moved instead: less to draw.
        const auto blank = std::min(text.find_first_not_of(' '), text.size());
        if (blank < text.size())
            canvas.text(left + character * double(column + blank), y, text.substr(blank),
                        {Font::mono, size, isLit ? color::text : inkColor(ink)});
        column += characters(text);
    }
}

void CodePane::paintLines(Canvas& canvas, double height)
{
    const double lineHeight = std::round(canvas.px(16.5)), pad = canvas.px(14);
    const double character = canvas.monoWidth(size);
    shownCount = std::max(1, int((height - canvas.px(6)) / lineHeight));
    const int lit = litLine(), lines = int(listing.lines.size());
    const auto [other, otherSays] = otherLine();
    const double gutter = canvas.px(10) + character * std::max(3.0, std::floor(std::log10(lines) + 1));
    const double left = gutter + pad;
    const auto columns = std::size_t(std::max(1.0, (area.width - left - canvas.px(12)) / character));
    // The function stands at the left edge, whatever it is a member of.
    const auto function = functionAround(listing, lit);
    std::size_t indent = 0;
    if (function.contains(lit)) indent = listing.lines[std::size_t(function.first) - 1].find_first_not_of(' ');
    auto rows = codeRows(listing, columns, indent);
    const auto endOf = [&](const CodeRow& row) {
        std::size_t end = row.column;
        for (const auto& piece : row.pieces) end += characters(piece.text);
        return left + character * double(end);
    };
    // What is said of a line never hides it: where it does not fit behind, it gets a row below.
    const TextLook small{Font::sans, 11, color::textDim};
    const auto makeRoom = [&](int line, double width) {
        const auto after = std::find_if(rows.rbegin(), rows.rend(), [&](const auto& row) { return row.line == line; });
        if (after != rows.rend() && endOf(*after) + canvas.px(10) > area.width - canvas.px(16) - width)
            rows.insert(after.base(), {.line = line, .isContinued = true});
    };
    makeRoom(lit, noteWidth(canvas));
    if (other != lit) makeRoom(other, canvas.textWidth(otherSays, small));

    const int all = rowCount = int(rows.size());
    shownFirst = scrolledTo ? std::clamp(*scrolledTo, 0, std::max(0, all - shownCount))
                            : firstShown(rows, function, lit, shownCount, other);
    const Rgba kind = controller.current() ? colorOf(roleOf(controller.tree(), *controller.current()))
                      : controller.node()  ? colorOf(rayRole(controller.node()->kind))
                                           : color::accent;
    for (int i = 0; i < shownCount && shownFirst + i < all; ++i)
    {
        const auto at = std::size_t(shownFirst + i);
        const auto& row = rows[at];
        const double y = height - canvas.px(4) - (i + 0.5) * lineHeight;
        const bool isLit = row.line == lit, isLast = at + 1 == rows.size() || rows[at + 1].line != row.line;
        if (isLit || row.line == other)
        {
            canvas.fill({0, y - lineHeight / 2, double(area.width), lineHeight},
                        isLit ? color::lit : mix(color::panel, color::lit, 0.45));
            canvas.fill({0, y - lineHeight / 2, canvas.px(isLit ? 4 : 2), lineHeight}, kind);
        }
        if (!row.isContinued)
        {
            const auto label = std::to_string(row.line);
            canvas.text(gutter - character * double(label.size()), y, label,
                        {Font::mono, size, isLit ? color::text : color::textFaint});
        }
        paintRow(canvas, row, left, y, isLit);
        if (!isLast) continue;
        if (isLit)
            paintNote(canvas, y);
        else if (row.line == other)
            canvas.text(area.width - canvas.px(16) - canvas.textWidth(otherSays, small), y, otherSays, small);
    }
    if (all > shownCount)
    {
        const double track = height - canvas.px(8), thumb = std::max(canvas.px(20), track * shownCount / all);
        const double top = height - canvas.px(4) - (track - thumb) * shownFirst / std::max(1, all - shownCount);
        canvas.roundedBox({area.width - canvas.px(8), top - thumb, canvas.px(4), thumb}, canvas.px(2),
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
