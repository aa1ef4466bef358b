// What somebody did in the window, as VTK's vtkInteractorEventRecorder writes it.
#pragma once

#include <optional>
#include <string>

#include "viz/base/screen.h"

namespace rt::viz
{

/// A recording must not depend on how fast somebody is, nor end the program that plays it: without timers and key q. It
/// says how large the window was, since that follows from the screen, and places in it are pixels.
std::string tidyRecording(const std::string& recording, const WindowPlace& window);

/// Throws std::runtime_error with one sentence if a file cannot be read or is no recording. VTK skips what it does not
/// understand: a file of anything else would seem to have been played. Returns size and scale of the window, if they are
/// said.
std::optional<WindowPlace> checkRecording(const std::string& file);

} // namespace rt::viz
