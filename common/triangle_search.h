// Which triangles a ray meets.
#pragma once

#include "common/bvh.h"
#include "common/shapes.h"

namespace rt
{

template <std::floating_point Real>
class TriangleSearch
{
public:
    /// More triangles than this are searched through a hierarchy.
    static constexpr std::size_t mostScanned = 8;

    explicit TriangleSearch(const std::vector<Triangle<Real>>& triangles, std::size_t most = mostScanned)
    {
        if (triangles.size() <= most) return;
        Real extent = 0;
        std::vector<Box<Real>> boxes(triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i)
        {
            const auto& t = triangles[i];
            for (const auto& vertex : {t.a, t.b, t.c}) boxes[i].add(vertex);
            const Vec3<Real> sum = abs(t.a) + abs(t.b) + abs(t.c);
            extent = std::max(extent, sum.x + sum.y + sum.z);
        }
        // intersectTriangle drops what is farther from the triangle's box than half of this.
        tree = Bvh<Real>(boxes, 2 * Shapes<Real>::triangleError, extent);
    }

    /// Calls found(index, t) for each of these triangles, those that the constructor saw, that the ray meets at t <= limit,
    /// until it returns true. It may lower `limit`; triangles that are farther may be called for all the same.
    template <class Found>
    bool visit(const std::vector<Triangle<Real>>& triangles, const Ray<Real>& ray, const Real& limit,
               Found&& found) const
    {
        const auto test = [&](std::int32_t index) {
            const auto t = Shapes<Real>::intersectTriangle(ray, triangles[std::size_t(index)]);
            return t && *t <= limit && found(index, *t);
        };
        if (tree.empty())
        {
            for (std::size_t index = 0; index < triangles.size(); ++index)
                if (test(std::int32_t(index))) return true;
            return false;
        }
        return tree.visitLeaves(ray.O, ray.D, limit, [&](std::size_t leaf) {
            for (const std::int32_t index : tree.leafShapes()[leaf])
                if (index >= 0 && test(index)) return true;
            return false;
        });
    }

    std::size_t bytes() const { return tree.bytes(); }

private:
    Bvh<Real> tree;
};

} // namespace rt
