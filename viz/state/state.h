// The viewer's state as JSON: what scripts and tests read.
#pragma once

#include <string>

#include "viz/state/controller.h"

namespace rt::viz
{

/// What is selected, shown, and said, and how far the events have gone; pretty-printed.
std::string stateJson(const Controller& controller);

} // namespace rt::viz
