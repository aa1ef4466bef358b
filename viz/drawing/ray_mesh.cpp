#include "viz/drawing/ray_mesh.h"

#include <algorithm>
#include <cmath>

namespace rt::viz
{

namespace
{

struct Builder
{
    const RayDrawing& drawing;
    const RayMeshStyle& style;
    RayMesh mesh{};

    double radiusOf(const Segment& segment) const
    {
        const double widest = style.width * tubeRadius(drawing);
        if (segment.role == RayRole::normal) return 0.4 * widest;
        if (segment.role == RayRole::other) return 0.7 * widest;
        if (isShadow(segment.role)) return (segment.role == RayRole::beyond ? 0.26 : 0.34) * widest;
        return widest * (0.45 + 0.55 * std::sqrt(segment.weight));
    }

    /// The head from `tip` backwards; returns where the shaft ends.
    static vec3 addHead(Mesh& target, const Segment& segment, double radius, const vec3& tip, const Rgba& color)
    {
        const vec3 axis = unit(segment.to - segment.from);
        const bool thin = isShadow(segment.role) || segment.role == RayRole::normal;
        double headLength = (thin ? 10 : 7) * radius, headRadius = (thin ? 3.6 : 2.8) * radius;
        const double shrink = std::min(1.0, 0.4 * segment.length() / (2 * headLength));
        headLength *= shrink;
        headRadius *= std::max(0.6, shrink);
        const vec3 base = tip - headLength * axis;
        addCone(target, base, tip, headRadius, color);
        if (segment.role == RayRole::reflected)
            addCone(target, base - 0.95 * headLength * axis, base, headRadius, color);
        if (segment.role == RayRole::transmitted)
            addDisc(target, base - 0.45 * headLength * axis, axis, headRadius, 0.22 * headLength, color);
        return base + 0.05 * headLength * axis;
    }

    void addDashes(Mesh& target, const Segment& segment, double radius, const Rgba& color)
    {
        const double dash = 0.05 * drawing.size, whole = segment.length();
        const int count = std::clamp(int(whole / (1.8 * dash)), 1, 400);
        const vec3 step = (segment.to - segment.from) / double(count);
        for (int i = 0; i < count; ++i)
        {
            const vec3 from = segment.from + (i + 0.4) * step;
            addTube(target, from, from + 0.52 * step, radius, color, color);
        }
    }

    void addGlow(const Segment& segment, double radius, const Rgba& color)
    {
        addTube(mesh.glow, segment.from, segment.to, 2.1 * radius, color.withAlpha(0.25),
                color.withAlpha(segment.fades ? 0 : 0.25));
    }

    /// Shadow rays end at the surface of the ball that stands for the light.
    Segment trimmed(Segment segment) const
    {
        if (segment.role == RayRole::reaches || segment.role == RayRole::beyond)
            segment.to -= std::min(lightRadius(drawing), 0.9 * segment.length()) * unit(segment.to - segment.from);
        return segment;
    }

    void add(const Segment& whole)
    {
        const Segment segment = trimmed(whole);
        if (segment.role == RayRole::normal && !style.withNormals) return;
        const bool selected = segment.node == style.selected && !segment.notTraced();
        double radius = radiusOf(segment);
        Rgba color = colorOf(segment.role);
        if (selected && !isShadow(segment.role) && segment.role != RayRole::normal)
        {
            radius *= 1.25;
            addGlow(segment, radius, mix(color, {255, 255, 255}, 0.5));
        }
        if (!selected && style.selected >= 0) color = mix(color, color::skyHigh, 0.12);
        // In a large tree the shadow rays of other nodes step back.
        const bool stepsBack = drawing.nodes > crowded && isShadow(segment.role) && segment.node != style.selected;
        if (stepsBack) color = color.withAlpha(0.4);
        Mesh& target = stepsBack ? mesh.fading : mesh.solid;
        if (segment.role == RayRole::beyond || segment.role == RayRole::other)
            return addDashes(target, segment, radius, color);
        if (segment.fades)
        {
            // Opaque for the first part, so that a long ray is not pale as a whole.
            const vec3 middle = segment.notTraced() ? segment.from : segment.from + 0.55 * (segment.to - segment.from);
            if (!segment.notTraced())
            {
                const vec3 tip = middle;
                Segment firstPart = segment;
                firstPart.to = middle;
                addTube(mesh.solid, segment.from, middle, radius, color, color);
                if (segment.hasHead) addHead(mesh.solid, firstPart, radius, tip, color);
            }
            addTube(mesh.fading, middle, segment.to, radius, color.withAlpha(segment.notTraced() ? 0.8 : 1),
                    color.withAlpha(0));
            return;
        }
        const vec3 end = segment.hasHead ? addHead(target, segment, radius, segment.to, color) : segment.to;
        addTube(target, segment.from, end, radius, color, color);
    }
};

} // namespace

double tubeRadius(const RayDrawing& drawing)
{
    return 0.0115 * drawing.size;
}

RayMesh buildRayMesh(const RayDrawing& drawing, const RayMeshStyle& style)
{
    Builder builder{drawing, style};
    for (const auto& segment : drawing.segments) builder.add(segment);
    for (const auto& mark : drawing.blockers)
    {
        const double size = 5 * style.width * tubeRadius(drawing);
        addCross(builder.mesh.solid, mark.point, size, 0.13 * size, colorOf(RayRole::blocked));
    }
    return builder.mesh;
}

} // namespace rt::viz
