// Where the panes lie in the window.
#pragma once

namespace rt::viz
{

/// Pixels of the window, y up from the lower edge. Without width or height: not shown.
struct Rect
{
    int x = 0, y = 0, width = 0, height = 0;

    bool isEmpty() const { return width <= 0 || height <= 0; }
    bool contains(int px, int py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

enum class PaneId
{
    title,
    image,
    numbers,
    scene,
    code,
    tree,
    chart,
    strip,
    help, ///< shown only as the whole
    none
};
inline constexpr int panesInAll = 9;

struct Layout
{
    double scale = 1; ///< of text and spacing
    Rect panes[panesInAll];

    const Rect& operator[](PaneId pane) const { return panes[int(pane)]; }
};

struct LayoutWishes
{
    PaneId whole = PaneId::none; ///< this one takes the place of all between title and strip
    bool titleHasTwoLines = false;
};

/// Panes cover a window of any size without overlapping. From 900x520 on all are shown; a smaller window has room for the
/// most important ones only.
Layout layoutFor(int width, int height, const LayoutWishes& wishes = {});

} // namespace rt::viz
