// The lines of a ray tree in space, as plain data: what is drawn, before anything is drawn.
#pragma once

#include "viz/base/extent.h"
#include "viz/base/palette.h"

namespace rt::viz
{

/// One straight piece.
struct Segment
{
    RayRole role = RayRole::camera;
    int node = 0;    ///< the ray itself, or the node at whose hit point a shadow ray or a normal starts
    int light = -1;  ///< of shadow rays
    int shadow = -1; ///< index of the shadow ray in its tree
    int capped = -1; ///< index of the ray that was not followed
    vec3 from{0, 0, 0}, to{0, 0, 0};
    double weight = 1;       ///< largest channel of the throughput, in [0, 1]
    bool hasHead = true;     ///< an arrow head at `to`
    bool fades = false;      ///< it goes on beyond `to`, further than is drawn
    End stopped = End::none; ///< why it was not traced: only its beginning is drawn
    std::string name{};      ///< of a ray of another tree; all else is named by its role and node

    bool notTraced() const { return stopped != End::none; }
    double length() const { return glm::length(to - from); }
};

/// The point where something stands in the way of a shadow ray.
struct BlockerMark
{
    int node = 0;
    int light = -1;
    int shadow = -1;
    vec3 point{0, 0, 0};
};

struct RayDrawing
{
    std::vector<Segment> segments;
    std::vector<BlockerMark> blockers;
    int nodes = 0;   ///< rays of the tree that are drawn: all of them, or the least deep ones
    double size = 1; ///< radius of the objects: what all widths are relative to
};

/// Trees of more nodes are drawn with less around the node that is selected.
inline constexpr int crowded = 6;

/// At most this many nodes are drawn, of the lowest depths.
inline constexpr int mostDrawnNodes = 1500;

/// What the tree looks like in space. Rays that meet nothing, or nothing near, end at a finite length and fade. Rays of
/// no weight are left out.
RayDrawing drawRays(const RayTree& tree, const SceneDescription& scene, const Extent& objects);

/// The radius of the ball that stands for a point light.
double lightRadius(const RayDrawing& drawing);

/// The ends of all segments. Without lights: only the first part of the way to them.
std::vector<vec3> rayPoints(const RayDrawing& drawing, bool withLights);

/// "D₀", "R₁", "T₂", "N₁": the lecture's letter and the node's number; "L₁": the shadow ray to light 1.
std::string labelOf(const Segment& segment);
std::string subscript(int number);

} // namespace rt::viz
