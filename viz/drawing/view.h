// From where the 3D pane looks, and where points of space then lie on the screen.
#pragma once

#include <array>
#include <optional>

#include "viz/base/layout.h"
#include "viz/drawing/rays.h"

namespace rt::viz
{

struct View
{
    vec3 position{0, 0, 1}, focal{0, 0, 0}, up{0, 1, 0};
    double angle = 30; ///< vertical, degrees
};

/// Parts of the pane's width and height that stay free around what is fitted.
struct Margins
{
    double side = 0.07, top = 0.07, bottom = 0.1;
};

/// The nearest view along -`towards` (unit, from the scene to the viewer) that shows all points.
View fitView(const std::vector<vec3>& points, const vec3& towards, const vec3& up, double aspect,
             const Margins& margins = {});

/// The direction, from the scene to the viewer, from which the rays are seen best: from the side, slightly above, with
/// little in the way and not through the eye of the scene's own camera.
vec3 bestDirection(const RayDrawing& drawing, const SceneDescription& scene);

/// A point of the screen; y up.
using vec2 = std::array<double, 2>;

/// Points of space to pixels of a pane.
class Projector
{
public:
    /// The pane has its lower left pixel at (0, 0).
    Projector(const View& view, int width, int height);

    /// Empty behind the viewer.
    std::optional<vec2> operator()(const vec3& point) const;
    /// The part of a segment before the viewer; empty if there is none.
    std::optional<std::array<vec2, 2>> segment(const vec3& from, const vec3& to) const;
    /// Pixels that a length of 1 at that point takes.
    double pixelsPerUnit(const vec3& point) const;

private:
    vec3 position, right, up, back;
    double scale, middleX, middleY, nearest;

    double depth(const vec3& point) const { return -dot(point - position, back); }
    vec2 onScreen(const vec3& point) const;
};

/// The segment nearest to a point of the screen, of those at most `tolerance` pixels away; -1: none. Of equally near ones
/// rays of the tree come before shadow rays.
int pickSegment(const RayDrawing& drawing, const Projector& projector, const vec2& at, double tolerance);

/// Distance of a point from a segment on the screen.
double distanceTo(const std::array<vec2, 2>& segment, const vec2& point);

} // namespace rt::viz
