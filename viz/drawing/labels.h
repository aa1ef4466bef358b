// Labels that do not cover one another.
#pragma once

#include "viz/drawing/view.h"

namespace rt::viz
{

/// A box on the screen; y up.
struct Box
{
    double x = 0, y = 0, width = 0, height = 0;

    bool overlaps(const Box& other, double gap) const
    {
        return x < other.x + other.width + gap && other.x < x + width + gap && y < other.y + other.height + gap &&
               other.y < y + height + gap;
    }
};

struct LabelRequest
{
    std::vector<vec2> anchors; ///< what it names, best first: it is put beside one of them
    double width = 0, height = 0;
    double gap = 6;            ///< distance from the anchor
    int priority = 0;          ///< higher ones choose first
    int line = -1;             ///< of this one of the lines: it may lie on it, and does so best
    std::optional<Box> kept{}; ///< where it was: there it stays if that is free, and comes before all that is new
};

/// A box for each label, or none where everything near its anchors is taken. Labels stay within width x height and keep
/// clear of the lines if they can, and of the `taken` boxes always; `scale` is that of the distances between them.
std::vector<std::optional<Box>> placeLabels(const std::vector<LabelRequest>& requests, double width, double height,
                                            const std::vector<std::array<vec2, 2>>& lines,
                                            const std::vector<Box>& taken, double scale = 1);

/// Points along a segment at which a label may stand.
std::vector<vec2> alongSegment(const std::array<vec2, 2>& line, double width, double height);

} // namespace rt::viz
