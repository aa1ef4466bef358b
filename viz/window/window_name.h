// The window's name for desktops, in any script.
#pragma once

#include <string>

namespace rt::viz
{

/// VTK tells the name in the old way, which knows Latin letters only. `display` and `window` are those of Xlib.
void nameWindow(void* display, void* window, const std::string& title);

} // namespace rt::viz
