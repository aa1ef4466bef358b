// What somebody did in the window, as VTK's vtkInteractorEventRecorder writes it.
#pragma once

#include <string>

namespace rt::viz
{

/// A recording must not depend on how fast somebody is, nor end the program that plays it: without timers and key q.
std::string tidyRecording(const std::string& recording);

/// Throws std::runtime_error with one sentence if a file cannot be read or is no recording. VTK skips what it does not
/// understand: a file of anything else would seem to have been played.
void checkRecording(const std::string& file);

} // namespace rt::viz
