#include "viz/base/screen.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "viz/base/layout.h"

namespace rt::viz
{

namespace
{

/// 0 if it is none.
double positiveNumber(const char* text)
{
    if (!text) return 0;
    const std::string_view digits(text);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) return 0;
    return std::isfinite(value) && value > 0 ? value : 0;
}

} // namespace

Area common(const Area& a, const Area& b)
{
    const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    const Area both{x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
    return both.isEmpty() ? Area{} : both;
}

Area areaFor(const Area& screen, const std::vector<Area>& monitors, int pointerX, int pointerY, const Area& workArea)
{
    std::optional<Area> first, pointed;
    const auto pixels = [](const Area& area) { return double(area.width) * area.height; };
    for (const auto& monitor : monitors)
    {
        const Area part = common(screen, monitor);
        if (part.isEmpty()) continue;
        if (!first) first = part;
        if (part.contains(pointerX, pointerY) && (!pointed || pixels(part) < pixels(*pointed))) pointed = part;
    }
    const Area area = pointed ? *pointed : first ? *first : screen;
    const Area left = common(area, workArea);
    return left.isEmpty() ? area : left;
}

WindowPlace placeWindow(int width, int height, const Area& area, const Frame& frame)
{
    const int aroundX = frame.left + frame.right, aroundY = frame.top + frame.bottom;
    WindowPlace place;
    place.width = std::clamp(width, 1, std::max(1, area.width - aroundX));
    place.height = std::clamp(height, 1, std::max(1, area.height - aroundY));
    place.x = area.x + std::max(0, (area.width - place.width - aroundX) / 2);
    place.y = area.y + std::max(0, (area.height - place.height - aroundY) / 2);
    return place;
}

double wishedScale(const char* xftDpi, const char* gdkScale, const char* qtScaleFactor)
{
    const double wish =
        std::max({positiveNumber(xftDpi) / 96, positiveNumber(gdkScale), positiveNumber(qtScaleFactor)});
    return wish > 0 ? std::clamp(wish, smallestScale, largestScale) : 1;
}

double fittingScale(double wished, const Area& area, const Frame& frame)
{
    const double room = std::min(double(area.width - frame.left - frame.right) / widthForAll,
                                 double(area.height - frame.top - frame.bottom) / heightForAll);
    return std::min(wished, std::max(1.0, room));
}

} // namespace rt::viz
