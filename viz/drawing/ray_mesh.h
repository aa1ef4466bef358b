// Rays as arrows of triangles: kinds differ by colour, by head and by width.
#pragma once

#include "viz/drawing/mesh.h"
#include "viz/drawing/rays.h"

namespace rt::viz
{

struct RayMesh
{
    Mesh solid;  ///< opaque
    Mesh fading; ///< with transparency
    Mesh glow;   ///< around the selected ray, with transparency and without shading
};

struct RayMeshStyle
{
    int selected = -1; ///< this node is drawn wider, within a glow, and the others a little paler
    bool withNormals = true;
    double width = 1; ///< factor
};

/// Heads: one cone for the camera ray, two for reflected rays, a cone and a disc for transmitted ones, a slim one for
/// shadow rays. A cross marks a blocker, dashes what lies beyond it.
RayMesh buildRayMesh(const RayDrawing& drawing, const RayMeshStyle& style);

/// Radius of the widest tubes.
double tubeRadius(const RayDrawing& drawing);

} // namespace rt::viz
