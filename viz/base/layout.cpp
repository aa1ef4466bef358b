#include "viz/base/layout.h"

#include <algorithm>
#include <cmath>

namespace rt::viz
{

namespace
{

/// Cuts the upper part off.
Rect takeTop(Rect& rest, int height)
{
    height = std::clamp(height, 0, rest.height);
    rest.height -= height;
    return {rest.x, rest.y + rest.height, rest.width, height};
}

Rect takeLeft(Rect& rest, int width)
{
    width = std::clamp(width, 0, rest.width);
    const Rect left{rest.x, rest.y, width, rest.height};
    rest.x += width;
    rest.width -= width;
    return left;
}

} // namespace

Layout layoutFor(int width, int height, const LayoutWishes& wishes)
{
    width = std::max(width, 8);
    height = std::max(height, 8);
    Layout layout;
    const auto place = [&](PaneId pane) -> Rect& { return layout.panes[int(pane)]; };
    const double size = std::min(width / wishes.scale / designWidth, height / wishes.scale / designHeight);
    // Text shrinks less than the window: it must stay legible.
    layout.scale = wishes.scale * std::clamp(size < 1 ? std::pow(size, 0.7) : size, 0.8, 4.0);
    const auto px = [&](double length) { return int(std::lround(length * layout.scale)); };

    Rect rest{0, 0, width, height};
    place(PaneId::title) = takeTop(rest, std::clamp(px(wishes.titleHasTwoLines ? 74 : 46), 1, height / 4));
    const int strip = std::clamp(px(78), 1, height / 4);
    place(PaneId::strip) = {0, 0, width, strip};
    rest.y += strip;
    rest.height -= strip;

    if (wishes.whole != PaneId::none && place(wishes.whole).isEmpty())
    {
        place(wishes.whole) = rest;
        layout.whole = wishes.whole;
        // In a window that is too small for all panes there is no room for larger letters.
        const double room = std::min(width / (widthForAll * wishes.scale), height / (heightForAll * wishes.scale));
        layout.wholeScale = layout.scale * (wishes.whole == PaneId::help ? 1 : std::clamp(room, 1.0, 1.5));
        return layout;
    }
    const bool isSmall = width < widthForAll * wishes.scale || height < heightForAll * wishes.scale;
    Rect left = takeLeft(rest, std::max(1, width * (isSmall ? 40 : 27) / 100));
    place(PaneId::image) = takeTop(left, std::clamp(left.width * 3 / 4, left.height / 4, left.height * 45 / 100));
    place(PaneId::numbers) = left;
    if (isSmall)
    {
        place(PaneId::scene) = rest;
        return layout;
    }
    Rect middle = takeLeft(rest, width * 44 / 100);
    place(PaneId::scene) = takeTop(middle, middle.height * 56 / 100);
    place(PaneId::code) = middle;
    place(PaneId::tree) = takeTop(rest, rest.height * 64 / 100);
    place(PaneId::chart) = rest;
    return layout;
}

} // namespace rt::viz
