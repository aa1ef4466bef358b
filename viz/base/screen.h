// Where a window lies on the screen, how large it may be, and how many pixels its letters take.
#pragma once

#include <vector>

namespace rt::viz
{

/// Pixels of the screen, y down from its upper left corner.
struct Area
{
    int x = 0, y = 0, width = 0, height = 0;

    bool isEmpty() const { return width <= 0 || height <= 0; }
    bool contains(int px, int py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

/// Empty if they have nothing in common.
Area common(const Area& a, const Area& b);

/// What a window manager puts around a window.
struct Frame
{
    int left = 0, right = 0, top = 0, bottom = 0;
};

/// Where a window may lie: the monitor that holds the pointer (the smallest one, if several show the same), else the first
/// one, else all the screen; and of that what is left beside panels, if a window manager has said it (an empty `workArea`:
/// it has not).
Area areaFor(const Area& screen, const std::vector<Area>& monitors, int pointerX, int pointerY, const Area& workArea);

/// A window, without its frame.
struct WindowPlace
{
    int x = 0, y = 0; ///< of the frame's corner on the screen
    int width = 0, height = 0;
    double scale = 1; ///< pixels for each pixel of the design, see layout.h
};

/// Pixels each way.
inline constexpr int largestWindow = 8192;

/// In the middle of the area, no larger than it with its frame.
WindowPlace placeWindow(int width, int height, const Area& area, const Frame& frame);

/// Scales that users may ask for.
inline constexpr double smallestScale = 0.5, largestScale = 4;

/// The scale that a desktop wishes for: the largest of Xft.dpi / 96 (a resource of X), GDK_SCALE and QT_SCALE_FACTOR, as far
/// as they are there and are numbers above 0; 1 if none is.
double wishedScale(const char* xftDpi, const char* gdkScale, const char* qtScaleFactor);

/// The same, but not so large that panes would be left out for want of room; never made smaller than 1 for that.
double fittingScale(double wished, const Area& area, const Frame& frame);

} // namespace rt::viz
