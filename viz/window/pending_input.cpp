#include "viz/window/pending_input.h"

#include <X11/Xlib.h>

namespace rt::viz
{

bool isInputPending(void* display)
{
    if (!display) return false;
    bool isFound = false;
    const auto look = [](Display*, XEvent* event, XPointer found) -> Bool {
        const bool isWheel = event->type == ButtonPress && (event->xbutton.button == 4 || event->xbutton.button == 5);
        if (event->type == KeyPress || isWheel) *reinterpret_cast<bool*>(found) = true;
        return False; // so that the event stays in the queue
    };
    XEvent ignored;
    XCheckIfEvent(static_cast<Display*>(display), &ignored, look, reinterpret_cast<XPointer>(&isFound));
    return isFound;
}

} // namespace rt::viz
