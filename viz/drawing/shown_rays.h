// The part of the ray tree that is to be seen now, and what another tree has in its place.
#pragma once

#include "viz/drawing/rays.h"
#include "viz/state/controller.h"

namespace rt::viz
{

/// Of a drawing of the controller's tree: what has happened so far, of the kinds that are shown, and not too weak.
RayDrawing shownPart(const RayDrawing& drawing, const Controller& controller);

/// The rays of the compared tree that differ from those of the controller's own, or that it does not have. Their node is
/// the one they are compared with, or their parent's; they are named "R₁′". Empty without a comparison.
std::vector<Segment> otherRays(const Controller& controller, const Extent& objects);

} // namespace rt::viz
