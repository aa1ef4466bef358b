#include "viz/drawing/labels.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace rt::viz
{

namespace
{

/// Does the line cross the box? (Liang and Barsky)
bool crosses(const std::array<vec2, 2>& line, const Box& box, double gap)
{
    double t0 = 0, t1 = 1;
    for (int axis = 0; axis < 2; ++axis)
    {
        const double from = line[0][std::size_t(axis)], step = line[1][std::size_t(axis)] - from;
        const double low = (axis == 0 ? box.x : box.y) - gap;
        const double high = (axis == 0 ? box.x + box.width : box.y + box.height) + gap;
        if (step == 0)
        {
            if (from < low || from > high) return false;
            continue;
        }
        double a = (low - from) / step, b = (high - from) / step;
        if (a > b) std::swap(a, b);
        t0 = std::max(t0, a);
        t1 = std::min(t1, b);
    }
    return t0 <= t1;
}

std::vector<Box> candidates(const LabelRequest& request)
{
    using std::numbers::pi;
    std::vector<Box> boxes;
    if (request.line >= 0)
        for (const auto& anchor : request.anchors)
            boxes.push_back(
                {anchor[0] - request.width / 2, anchor[1] - request.height / 2, request.width, request.height});
    for (const double distance : {1.0, 2.2})
        for (const auto& anchor : request.anchors)
            for (const int eighth : {2, 0, 1, 7, 3, 6, 4, 5})
            {
                const double angle = eighth * pi / 4, dx = std::cos(angle), dy = std::sin(angle);
                const double gap = distance * request.gap;
                boxes.push_back({anchor[0] + dx * (gap + request.width / 2) - request.width / 2,
                                 anchor[1] + dy * (gap + request.height / 2) - request.height / 2, request.width,
                                 request.height});
            }
    return boxes;
}

} // namespace

std::vector<std::optional<Box>> placeLabels(const std::vector<LabelRequest>& requests, double width, double height,
                                            const std::vector<std::array<vec2, 2>>& lines,
                                            const std::vector<Box>& taken, double scale)
{
    std::vector<std::size_t> order(requests.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return requests[a].priority > requests[b].priority; });

    const double edge = 2 * scale;
    std::vector<std::optional<Box>> places(requests.size());
    std::vector<Box> used = taken;
    const auto isFree = [&](const Box& box) {
        return std::none_of(used.begin(), used.end(), [&](const Box& other) { return box.overlaps(other, 3 * scale); });
    };
    for (const auto index : order)
        if (const auto& kept = requests[index].kept; kept && isFree(*kept))
        {
            places[index] = kept;
            used.push_back(*kept);
        }
    for (const auto index : order)
    {
        if (places[index]) continue;
        const auto& request = requests[index];
        std::optional<Box> best;
        int fewest = 1 << 20;
        for (const auto& box : candidates(request))
        {
            if (box.x < edge || box.y < edge || box.x + box.width > width - edge || box.y + box.height > height - edge)
                continue;
            if (!isFree(box)) continue;
            int crossed = 0;
            for (std::size_t i = 0; i < lines.size(); ++i)
                if (int(i) != request.line) crossed += crosses(lines[i], box, scale);
            if (crossed < fewest)
            {
                fewest = crossed;
                best = box;
            }
            if (crossed == 0) break;
        }
        // Where everything is full of lines a label would only be one thing more.
        if (!best || (fewest > 2 && request.priority < 100)) continue;
        places[index] = best;
        used.push_back(*best);
    }
    return places;
}

std::vector<vec2> alongSegment(const std::array<vec2, 2>& line, double width, double height)
{
    std::vector<vec2> anchors;
    for (const double t : {0.5, 0.38, 0.62, 0.27, 0.73, 0.16, 0.84})
    {
        const vec2 p{line[0][0] + t * (line[1][0] - line[0][0]), line[0][1] + t * (line[1][1] - line[0][1])};
        if (p[0] > 0 && p[1] > 0 && p[0] < width && p[1] < height) anchors.push_back(p);
    }
    return anchors;
}

} // namespace rt::viz
