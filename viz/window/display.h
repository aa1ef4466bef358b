// Is there a display that VTK can draw on? To be asked before any VTK object exists, since without one VTK crashes, and
// before this process has threads at work.
#pragma once

#include <string>

#include "viz/base/screen.h"

namespace rt::viz
{

struct DisplayFacts
{
    std::string lacks; ///< why VTK cannot draw there, to be part of a sentence; empty: it can
    // If it can:
    Area area;        ///< where a window may lie, frame included
    Frame frame;      ///< that it would get
    double scale = 1; ///< that the desktop wishes for
};

/// Asks the display that DISPLAY names. Whatever its X server or its OpenGL driver does (crash, hang, close the connection)
/// happens to a child process, and ends after a while. `forWindow`: area, frame and scale are wanted, too.
DisplayFacts askDisplay(bool forWindow);

} // namespace rt::viz
