#include "viz/window/window_name.h"

#include <X11/Xlib.h>

namespace rt::viz
{

void nameWindow(void* display, void* window, const std::string& title)
{
    if (!display || !window) return;
    auto* server = static_cast<Display*>(display);
    XChangeProperty(server, reinterpret_cast<::Window>(window), XInternAtom(server, "_NET_WM_NAME", False),
                    XInternAtom(server, "UTF8_STRING", False), 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(title.data()), int(title.size()));
}

} // namespace rt::viz
