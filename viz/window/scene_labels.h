// The names of rays, lights and objects in the 3D view.
#pragma once

#include "viz/window/scene_overlay.h"

namespace rt::viz
{

/// Writes all labels that find room beside the `taken` boxes.
void paintLabels(Canvas& canvas, const OverlayInput& input, const std::vector<Box>& taken);

} // namespace rt::viz
