// What lies over the 3D view: labels, the legend of the rays, the axes, and the cheat sheet.
#pragma once

#include <map>
#include <string>

#include "viz/drawing/view.h"
#include "viz/state/controller.h"
#include "viz/window/canvas.h"

namespace rt::viz
{

/// Where the labels are, so that they stay there while the view does, and can be clicked.
struct LabelPlaces
{
    struct Place
    {
        Box box;
        int node = -1; ///< the ray that it names, or whose shadow ray or normal; -1: no ray
        bool isShown = false;
    };
    std::map<std::string, Place> places;
    Box legend; ///< what it covers

    /// The ray whose label is there; -1: none.
    int nodeAt(const vec2& point) const;
};

struct OverlayInput
{
    const Controller& controller;
    const RayDrawing& drawing;
    const Extent& objects;
    View view;
    int width, height;
    LabelPlaces& labels;
};

void paintSceneOverlay(Canvas& canvas, const OverlayInput& input);

} // namespace rt::viz
