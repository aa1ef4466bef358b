// What is asked of an X display, by a process that may crash over it: see display.h. Apart, since X's macros are in the way.
#pragma once

#include "viz/base/screen.h"

namespace rt::viz
{

/// Is sent through a pipe.
struct DisplayAnswer
{
    char lacks[160] = ""; ///< the rest of a sentence that begins with the display's name; empty: VTK can draw there
    Area area;
    Frame frame;
    double scale = 1;
};

/// May hang, crash, or end the process.
void probeDisplay(DisplayAnswer& answer, bool forWindow);

/// From now on the process ends with one sentence and code 3 when its display closes the connection, instead of with Xlib's
/// words and exit handlers that draw.
void endWithDisplay();

} // namespace rt::viz
