#include "viz/drawing/rays.h"

#include <algorithm>
#include <cmath>

namespace rt::viz
{

namespace
{

/// How far a ray is drawn that does not stop: through the scene and a little further.
double reach(const vec3& origin, const vec3& direction, const Extent& objects)
{
    const double closest = std::max(0.0, dot(objects.centre - origin, direction));
    return closest + 0.8 * objects.radius;
}

/// The depth down to which all nodes together are few enough to draw.
int drawnDepth(const RayTree& tree)
{
    std::vector<int> count;
    for (const auto& node : tree.nodes)
    {
        const auto depth = std::size_t(std::max(0, node.depth));
        if (count.size() <= depth) count.resize(depth + 1);
        ++count[depth];
    }
    int sum = 0, depth = 0;
    while (std::size_t(depth) < count.size() && sum + count[std::size_t(depth)] <= mostDrawnNodes)
        sum += count[std::size_t(depth++)];
    return depth - 1;
}

struct Drawer
{
    const RayTree& tree;
    const SceneDescription& scene;
    const Extent& objects;
    RayDrawing drawing{};

    void add(const Segment& segment)
    {
        if (isFinite(segment.from) && isFinite(segment.to) && segment.length() > 0) drawing.segments.push_back(segment);
    }

    void addRay(const RayTree::Node& node)
    {
        Segment segment{.role = rayRole(node.kind), .node = node.id, .from = node.origin};
        segment.weight = std::clamp(largestChannel(node.throughput), 0.0, 1.0);
        const double longest = reach(node.origin, node.direction, objects) + 6 * objects.radius;
        if (node.hit && node.hit->t <= longest)
            segment.to = node.hit->point;
        else
        {
            segment.fades = true;
            segment.to =
                node.origin + (node.hit ? longest : reach(node.origin, node.direction, objects)) * node.direction;
        }
        add(segment);
    }

    void addNormal(const RayTree::Node& node)
    {
        const double size = std::min(sizeOf(scene, node.hit->primitive).value_or(objects.radius), objects.radius);
        const vec3 N = node.hit->inside ? -node.hit->normal : node.hit->normal;
        add({.role = RayRole::normal,
             .node = node.id,
             .from = node.hit->point,
             .to = node.hit->point + std::clamp(0.5 * size, 0.09 * objects.radius, 0.22 * objects.radius) * N});
    }

    void addShadow(int index)
    {
        const auto& shadow = tree.shadows[std::size_t(index)];
        const auto& node = tree.nodes[std::size_t(shadow.node)];
        if (!node.hit) return;
        const vec3 I = node.hit->point, light = I + shadow.distance * shadow.direction;
        Segment segment{.role = RayRole::reaches,
                        .node = shadow.node,
                        .light = shadow.light,
                        .shadow = index,
                        .from = I,
                        .to = light};
        segment.weight = std::clamp(largestChannel(node.throughput), 0.0, 1.0);
        if (!shadow.visible)
        {
            // Without a blocker's point all of it is beyond: nothing is known but that no light comes.
            segment.hasHead = false;
            const vec3 end = shadow.blocker ? shadow.blocker->point : I;
            segment.role = RayRole::blocked;
            segment.to = end;
            add(segment);
            if (shadow.blocker) drawing.blockers.push_back({shadow.node, shadow.light, index, end});
            segment.role = RayRole::beyond;
            segment.from = end;
            segment.to = light;
        }
        add(segment);
    }

    void addCapped(int index)
    {
        const auto& capped = tree.capped[std::size_t(index)];
        const auto& node = tree.nodes[std::size_t(capped.node)];
        if (!node.hit || capped.weight == 0) return;
        add({.role = rayRole(capped.kind),
             .node = capped.node,
             .capped = index,
             .from = node.hit->point,
             .to = node.hit->point + 0.3 * objects.radius * unit(capped.direction),
             .weight = 0.5 * std::clamp(largestChannel(node.throughput) * capped.weight, 0.0, 1.0),
             .hasHead = false,
             .fades = true,
             .stopped = capped.reason});
    }
};

} // namespace

RayDrawing drawRays(const RayTree& tree, const SceneDescription& scene, const Extent& objects)
{
    Drawer drawer{tree, scene, objects};
    drawer.drawing.size = objects.radius;
    const int depth = drawnDepth(tree);
    const auto drawn = [&](int id) {
        return id >= 0 && std::size_t(id) < tree.nodes.size() && tree.nodes[std::size_t(id)].depth <= depth &&
               tree.nodes[std::size_t(id)].weight != 0;
    };
    for (const auto& node : tree.nodes)
    {
        if (!drawn(node.id)) continue;
        ++drawer.drawing.nodes;
        drawer.addRay(node);
        if (node.hit) drawer.addNormal(node);
    }
    for (std::size_t i = 0; i < tree.shadows.size(); ++i)
        if (drawn(tree.shadows[i].node)) drawer.addShadow(int(i));
    for (std::size_t i = 0; i < tree.capped.size(); ++i)
        if (drawn(tree.capped[i].node)) drawer.addCapped(int(i));
    return drawer.drawing;
}

double lightRadius(const RayDrawing& drawing)
{
    return 0.045 * drawing.size;
}

std::vector<vec3> rayPoints(const RayDrawing& drawing, bool withLights)
{
    std::vector<vec3> points;
    for (const auto& segment : drawing.segments)
    {
        const bool toLight = segment.role == RayRole::reaches || segment.role == RayRole::beyond;
        points.push_back(segment.from);
        points.push_back(toLight && !withLights ? segment.from + 0.3 * (segment.to - segment.from) : segment.to);
    }
    return points;
}

std::string subscript(int number)
{
    std::string digits;
    for (const char c : std::to_string(number))
        if (c == '-')
            digits += "₋";
        else
            digits += std::string("\xE2\x82") + char(0x80 + (c - '0')); // U+2080: subscript zero
    return digits;
}

std::string labelOf(const Segment& segment)
{
    if (segment.role == RayRole::other) return segment.name;
    const char* letter = "L";
    if (segment.role == RayRole::camera) letter = "D";
    if (segment.role == RayRole::reflected) letter = "R";
    if (segment.role == RayRole::transmitted) letter = "T";
    if (segment.role == RayRole::normal) letter = "N";
    return letter + subscript(*letter == 'L' ? segment.light : segment.node);
}

} // namespace rt::viz
