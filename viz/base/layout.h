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
    double scale = 1; ///< of text, spacing and lines: it follows the size of the window, too
    Rect panes[panesInAll];
    PaneId whole = PaneId::none; ///< this one takes all the room
    double wholeScale = 1;       ///< and has larger letters

    double scaleOf(PaneId pane) const { return pane == whole ? wholeScale : scale; }
    const Rect& operator[](PaneId pane) const { return panes[int(pane)]; }
};

struct LayoutWishes
{
    PaneId whole = PaneId::none; ///< this one takes the place of all between title and strip
    bool titleHasTwoLines = false;
    double scale = 1; ///< pixels of the window for each pixel of the design: 2 on a screen of twice the usual density
};

/// The window that is designed: in it a length of the design is that many pixels.
inline constexpr int designWidth = 1600, designHeight = 900;
/// A window of at least this size (times the scale) shows all panes.
inline constexpr int widthForAll = 900, heightForAll = 520;

/// Panes cover a window of any size without overlapping; a small one has room for the most important panes only.
Layout layoutFor(int width, int height, const LayoutWishes& wishes = {});

} // namespace rt::viz
