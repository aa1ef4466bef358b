#include "viz/state/node_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/tree/explain.h"
#include "lessons/programs/formulas.h"

namespace rt::viz
{

namespace
{

bool isContinuation(char c)
{
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// The byte after the first `count` characters.
std::size_t byteAfter(const std::string& text, std::size_t count)
{
    std::size_t i = 0;
    while (i < text.size() && (count > 0 || isContinuation(text[i])))
    {
        if (!isContinuation(text[i])) --count;
        ++i;
    }
    return i;
}

/// The last space at or before `limit`, on request only outside of parentheses; 0 if there is none.
std::size_t lastSpace(const std::string& text, std::size_t limit, bool outside)
{
    std::size_t found = 0;
    int depth = 0;
    for (std::size_t i = 0; i <= limit && i < text.size(); ++i)
    {
        if (text[i] == '(') ++depth;
        if (text[i] == ')') --depth;
        if (text[i] == ' ' && (!outside || depth <= 0)) found = i;
    }
    return found;
}

void add(std::vector<TextLine>& lines, TextStyle style, const std::string& text, std::size_t columns)
{
    std::size_t start = 0;
    while (start <= text.size())
    {
        const auto end = std::min(text.find('\n', start), text.size());
        for (auto& line : wrap(text.substr(start, end - start), columns)) lines.push_back({style, std::move(line)});
        start = end + 1;
    }
}

std::string whyItEnds(const RayTree::Node& node, int maxDepth)
{
    switch (node.end)
    {
    case End::cap:
        return fmt::format("The next ray would be deeper than MAXDEPTH = {}: it was not followed.", maxDepth);
    case End::cutoff:
        return "The next ray could not have added enough: it was not followed.";
    case End::black:
        return "The surface is black: nothing more can come from it.";
    default:
        return "";
    }
}

} // namespace

std::size_t characters(const std::string& text)
{
    return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return !isContinuation(c); }));
}

std::string shorten(const std::string& text, std::size_t columns)
{
    if (characters(text) <= columns) return text;
    return text.substr(0, byteAfter(text, std::max<std::size_t>(columns, 1) - 1)) + "…";
}

std::vector<std::string> wrap(const std::string& text, std::size_t columns)
{
    columns = std::max<std::size_t>(columns, 8);
    std::vector<std::string> lines;
    std::string rest = text;
    while (characters(rest) > columns)
    {
        const auto limit = byteAfter(rest, columns);
        auto space = lastSpace(rest, limit, true);
        // Never break within the indent, nor so early that the line is nearly empty.
        if (space < limit / 3) space = lastSpace(rest, limit, false);
        if (space < limit / 3) space = limit;
        lines.push_back(rest.substr(0, space));
        const auto next = rest.find_first_not_of(' ', space);
        if (next == std::string::npos) return lines;
        rest = "   " + rest.substr(next);
    }
    lines.push_back(rest);
    return lines;
}

std::string shortText(const Vec3<double>& v)
{
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z);
}

std::string nodeHeading(const RayTree& tree, const RayTree::Node& node)
{
    std::string heading = fmt::format("[{}] {} ray, depth {}", node.id, name(node.kind), node.depth);
    if (node.parent >= 0)
        heading += fmt::format(", from [{}]", node.parent);
    else if (node.orphan)
        heading += ", orphan";
    else if (!tree.pixel)
        heading += ", as given";
    return heading;
}

std::vector<TextLine> nodeText(const Controller& controller, std::size_t columns)
{
    std::vector<TextLine> lines;
    const auto* node = controller.node();
    if (!node)
    {
        const auto& message = controller.message();
        add(lines, TextStyle::note,
            message.empty() ? "Nothing was traced. An exercise that has not been attempted looks like this." : message,
            columns);
        return lines;
    }
    if (node->orphan)
        add(lines, TextStyle::note, "An orphan: its parent cannot be told from its depth. Was its depth set by hand?",
            columns);
    for (const auto& formula : explainNode(controller.tree(), controller.scene(), lectureFormulas(), node->id))
    {
        const auto used = characters(formula.title) + characters(formula.symbolic);
        if (formula.symbolic.find('\n') == std::string::npos && used + 2 <= columns)
            lines.push_back({TextStyle::title, formula.title, formula.symbolic});
        else
        {
            add(lines, TextStyle::title, formula.title, columns);
            add(lines, TextStyle::symbolic, formula.symbolic, columns);
        }
        add(lines, TextStyle::numbers, formula.numbers, columns);
    }
    if (const auto why = whyItEnds(*node, controller.maxDepth()); !why.empty())
        add(lines, TextStyle::note, why, columns);
    return lines;
}

} // namespace rt::viz
