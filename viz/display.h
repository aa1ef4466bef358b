// Is there a display? To be asked before any VTK object exists: without one VTK crashes.
#pragma once

namespace rt::viz
{

/// An X display with OpenGL can be opened.
bool hasDisplay();

/// Starts this program again, with the same arguments, on a display of its own (xvfb-run -a). Returns only if that is not
/// possible: xvfb-run is not installed, or this already is the second start.
void restartWithDisplay(char** argv, int width, int height);

} // namespace rt::viz
