// The selected node in words: what the numbers pane writes.
#pragma once

#include <string>
#include <vector>

#include "viz/state/controller.h"

namespace rt::viz
{

enum class TextStyle
{
    title,
    symbolic,
    numbers,
    note
};

struct TextLine
{
    TextStyle style = TextStyle::numbers;
    std::string text;
    std::string besides = {}; ///< of a title: the formula, if it fits on the same line
};

/// The node's formulas, one after the other; lines are no longer than `columns` characters.
std::vector<TextLine> nodeText(const Controller& controller, std::size_t columns);

/// "[1] reflected ray, depth 1"
std::string nodeHeading(const RayTree& tree, const RayTree::Node& node);

/// "(0.125, 0.5, 1)" with at most four significant digits.
std::string shortText(const Vec3<double>& v);

/// Breaks at spaces where it can; continued lines are indented. Counts characters, not bytes.
std::vector<std::string> wrap(const std::string& text, std::size_t columns);

/// Number of characters of a UTF-8 text.
std::size_t characters(const std::string& text);

/// The text, or its beginning and an ellipsis if it has more than `columns` characters.
std::string shorten(const std::string& text, std::size_t columns);

} // namespace rt::viz
