// Smooth lines, discs and boxes in a picture of one's own. VTK's 2D context draws edges without antialiasing and takes
// tens of microseconds for each shape; a tree of 10,000 nodes is drawn here once and then shown as one picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "viz/base/palette.h"
#include "viz/drawing/view.h"

namespace rt::viz
{

/// Draws over somebody else's pixels: row by row from the lower left, y up; pixel (0, 0) covers [0, 1] x [0, 1].
class Raster
{
public:
    Raster(Rgba* firstPixel, int pixelWidth, int pixelHeight)
        : pixels(firstPixel), width(pixelWidth), height(pixelHeight)
    {
    }

    void clear(const Rgba& color) { std::fill(pixels, pixels + std::size_t(width) * std::size_t(height), color); }

    void disc(const vec2& centre, double radius, const Rgba& color)
    {
        each(centre[0] - radius, centre[1] - radius, centre[0] + radius, centre[1] + radius, color,
             [&](double x, double y) { return radius - std::hypot(x - centre[0], y - centre[1]); });
    }

    /// A circle whose stroke has its middle at `radius`.
    void ring(const vec2& centre, double radius, double stroke, const Rgba& color)
    {
        const double outer = radius + stroke / 2;
        each(centre[0] - outer, centre[1] - outer, centre[0] + outer, centre[1] + outer, color,
             [&](double x, double y) {
                 return stroke / 2 - std::abs(std::hypot(x - centre[0], y - centre[1]) - radius);
             });
    }

    void square(const vec2& centre, double half, const Rgba& color)
    {
        each(centre[0] - half, centre[1] - half, centre[0] + half, centre[1] + half, color,
             [&](double x, double y) { return half - std::max(std::abs(x - centre[0]), std::abs(y - centre[1])); });
    }

    /// The corners of a convex shape, anticlockwise.
    void convex(const std::vector<vec2>& corners, const Rgba& color)
    {
        vec2 low = corners[0], high = corners[0];
        for (const auto& corner : corners)
            for (std::size_t axis = 0; axis < 2; ++axis)
            {
                low[axis] = std::min(low[axis], corner[axis]);
                high[axis] = std::max(high[axis], corner[axis]);
            }
        each(low[0], low[1], high[0], high[1], color, [&](double x, double y) {
            double inside = 1e9;
            for (std::size_t i = 0; i < corners.size(); ++i)
            {
                const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
                const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
                if (length > 0) inside = std::min(inside, (dx * (y - a[1]) - dy * (x - a[0])) / length);
            }
            return inside;
        });
    }

    /// Thinner lines than one pixel are drawn one pixel wide and paler.
    void line(const vec2& from, const vec2& to, double stroke, Rgba color)
    {
        const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
        if (!(length > 0) || !std::isfinite(length)) return;
        if (stroke < 1)
        {
            color = color.withAlpha(color.a / 255.0 * std::max(stroke, 0.0));
            stroke = 1;
        }
        const double half = stroke / 2;
        const auto inside = [&](double x, double y) {
            const double along = ((x - from[0]) * dx + (y - from[1]) * dy) / length;
            const double across = std::abs((x - from[0]) * dy - (y - from[1]) * dx) / length;
            return std::min({half - across, along, length - along});
        };
        // Row by row, or column by column, only what lies near the line.
        const bool flat = std::abs(dx) >= std::abs(dy);
        const std::size_t a = flat ? 0 : 1, b = 1 - a;
        const double slope = (to[b] - from[b]) / (to[a] - from[a]);
        const double reach = (half + 1) * std::sqrt(1 + slope * slope) + std::abs(slope);
        const int limit = flat ? width : height, other = flat ? height : width;
        const int first = int(std::max(0.0, std::floor(std::min(from[a], to[a]) - half - 1)));
        const int last = int(std::min(limit - 1.0, std::ceil(std::max(from[a], to[a]) + half + 1)));
        for (int i = first; i <= last; ++i)
        {
            const double middle = from[b] + slope * (i + 0.5 - from[a]);
            const int low = int(std::max(0.0, std::floor(middle - reach)));
            const int high = int(std::min(other - 1.0, std::ceil(middle + reach)));
            for (int j = low; j <= high; ++j)
            {
                const int x = flat ? i : j, y = flat ? j : i;
                blend(x, y, color, inside(x + 0.5, y + 0.5) + 0.5);
            }
        }
    }

    void dashes(const vec2& from, const vec2& to, double stroke, double dash, const Rgba& color)
    {
        const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
        if (!(length < 1e5)) return line(from, to, stroke, color); // it runs far outside
        for (double start = 0; start < length; start += 2 * dash)
        {
            const double t = start / length, u = std::min(1.0, (start + dash) / length);
            line({from[0] + t * dx, from[1] + t * dy}, {from[0] + u * dx, from[1] + u * dy}, stroke, color);
        }
    }

    /// Coverage (at most 1) of one pixel by a colour.
    void blend(int x, int y, const Rgba& color, double coverage)
    {
        if (!(coverage > 0) || x < 0 || y < 0 || x >= width || y >= height) return;
        auto& under = pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
        const double over = std::min(coverage, 1.0) * color.a / 255.0, all = over + under.a / 255.0 * (1 - over);
        if (all > 0) under = mix(under, {color.r, color.g, color.b, under.a}, over / all).withAlpha(all);
    }

private:
    Rgba* pixels;
    int width, height;

    /// `inside`: distance from the edge, positive within.
    template <class Inside>
    void each(double left, double low, double right, double high, const Rgba& color, const Inside& inside)
    {
        const int x0 = int(std::max(0.0, std::floor(left - 1))), x1 = int(std::min(width - 1.0, std::ceil(right + 1)));
        const int y0 = int(std::max(0.0, std::floor(low - 1))), y1 = int(std::min(height - 1.0, std::ceil(high + 1)));
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) blend(x, y, color, inside(x + 0.5, y + 0.5) + 0.5);
    }
};

} // namespace rt::viz
