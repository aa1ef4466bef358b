#include "viz/drawing/shown_rays.h"

#include <algorithm>
#include <set>

namespace rt::viz
{

RayDrawing shownPart(const RayDrawing& drawing, const Controller& controller)
{
    const auto isShown = [&](const Segment& segment) {
        if (segment.shadow >= 0)
            return controller.isShadowReached(segment.shadow) && controller.isShadowShown(segment.shadow);
        if (segment.capped >= 0)
        {
            const auto kind = Kind(int(controller.tree().capped[std::size_t(segment.capped)].kind));
            return controller.isCappedReached(segment.capped) && controller.shows(kind) &&
                   controller.isShown(segment.node);
        }
        return controller.isReached(segment.node) && controller.isShown(segment.node);
    };
    RayDrawing part;
    part.size = drawing.size;
    std::set<int> nodes;
    for (const auto& segment : drawing.segments)
    {
        if (!isShown(segment)) continue;
        part.segments.push_back(segment);
        if (isRay(segment.role) && segment.capped < 0) nodes.insert(segment.node);
    }
    part.nodes = int(nodes.size());
    for (const auto& mark : drawing.blockers)
        if (controller.isShadowReached(mark.shadow) && controller.isShadowShown(mark.shadow))
            part.blockers.push_back(mark);
    return part;
}

std::vector<Segment> otherRays(const Controller& controller, const Extent& objects)
{
    std::vector<Segment> found;
    const auto* comparison = controller.comparison();
    if (!comparison) return found;
    const auto& tree = comparison->tree;
    const auto& match = comparison->match;
    for (auto segment : drawRays(tree, controller.scene(), objects).segments)
    {
        if (!isRay(segment.role) || segment.capped >= 0) continue;
        int mine = match.expectedOf[std::size_t(segment.node)];
        if (mine >= 0 && !match.differs[std::size_t(mine)]) continue;
        segment.name = labelOf(segment) + "′";
        for (int above = segment.node; mine < 0 && above >= 0;)
        {
            above = tree.nodes[std::size_t(above)].parent;
            if (above >= 0) mine = match.expectedOf[std::size_t(above)];
        }
        segment.node = std::max(0, mine);
        segment.role = RayRole::other;
        found.push_back(segment);
    }
    return found;
}

} // namespace rt::viz
