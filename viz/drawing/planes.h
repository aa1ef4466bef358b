// Infinite planes are shown as finite patches that fade out, painted with the light that falls on them.
#pragma once

#include "viz/base/extent.h"
#include "viz/base/palette.h"

namespace rt::viz
{

struct PlanePatch
{
    int plane = 0;
    vec3 corner{0, 0, 0};
    vec3 right{1, 0, 0}, forward{0, 0, 1}; ///< edges with their full lengths; their cross product faces the eye
    std::vector<std::array<double, 2>> outline{
        {0, 0}, {1, 0}, {1, 1}, {0, 1}}; ///< (u, v) of its corners, counterclockwise
    bool seeThrough = false;             ///< mirrors and glass
    bool isFloor = false;

    vec3 at(double u, double v) const { return corner + u * right + v * forward; }
};

/// The part of each plane that lies around `shown`. Where planes meet, as the walls of a room do, each ends at the other:
/// what lies behind it is never seen from the eye.
std::vector<PlanePatch> planePatches(const SceneDescription& scene, const Extent& shown);

struct PatchPicture
{
    int side = 1;
    std::vector<Rgba> pixels; ///< row by row; pixel (i, j) is the patch at ((i + 0.5) / side, (j + 0.5) / side)
};

/// The checker, lit by the scene's lights with their shadows, fading out towards the edge.
PatchPicture paintPatch(const PlanePatch& patch, const SceneDescription& scene, int side);

} // namespace rt::viz
