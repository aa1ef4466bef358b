// Where the panes lie in the window.
#pragma once

namespace rt::viz
{

/// Pixels of the window, y up from the lower edge.
struct Rect
{
    int x = 0, y = 0, width = 1, height = 1;

    bool contains(int px, int py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

struct Layout
{
    double scale = 1; ///< of text and spacing
    Rect title, image, numbers, scene, strip;
};

/// Panes cover a window of any size without overlapping; none is ever empty.
Layout layoutFor(int width, int height);

} // namespace rt::viz
