// Draws the ray tree's graph into pixels: all of it but what follows the pointer.
#pragma once

#include "viz/drawing/tree_layout.h"
#include "viz/state/controller.h"
#include "viz/window/raster.h"
#include "viz/window/words.h"

namespace rt::viz
{

struct TreePicture
{
    const Controller& controller;
    const TreeLayout& layout;
    const TreeView& view;
    const std::vector<int>& extra; ///< of each node: rays that only the tree it is compared with sends from there
    Words& words;
    int width, height; ///< pixels
    double scale;
    double radius;     ///< of rays' circles, pixels
    double shadowHalf; ///< half the side of shadow rays' squares
    bool depthsAreLevels;
};

void paintTree(const TreePicture& picture, Raster& raster);

} // namespace rt::viz
