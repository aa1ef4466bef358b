// Whether the user is ahead of what is drawn.
#pragma once

namespace rt::viz
{

/// Has a key been pressed or the wheel been turned that the window has not heard of yet? Takes nothing off the queue of the
/// display, which is a Display of Xlib.
bool isInputPending(void* display);

} // namespace rt::viz
