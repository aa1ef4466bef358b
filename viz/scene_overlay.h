// What lies over the 3D view: labels, the legend of the rays, the axes, and the cheat sheet.
#pragma once

#include "viz/canvas.h"
#include "viz/controller.h"
#include "viz/view.h"

namespace rt::viz
{

struct OverlayInput
{
    const Controller& controller;
    const RayDrawing& drawing;
    const Extent& objects;
    View view;
    int width, height;
};

void paintSceneOverlay(Canvas& canvas, const OverlayInput& input);

} // namespace rt::viz
