// Which triangles a ray meets.
#pragma once

#include "common/base/shapes.h"
#include "common/search/bvh.h"

namespace rt
{

template <std::floating_point Real>
class TriangleSearch
{
public:
    /// More triangles than this are searched through a hierarchy: tests/perf/README.md has the measurement.
    static constexpr std::size_t mostScanned = 2;

    explicit TriangleSearch(const std::vector<Triangle<Real>>& triangles, std::size_t most = mostScanned)
    {
        if (triangles.size() <= most) return;
        std::vector<Box<Number>> boxes(triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i)
            for (const auto& vertex : {triangles[i].a, triangles[i].b, triangles[i].c})
                boxes[i].add(Vec3<Number>(vertex));
        // intersectTriangle drops what is farther from the triangle's box than half of this, for three vertices.
        tree = Bvh<Number>(boxes, 4 * Shapes<Real>::triangleError);
    }

    /// Calls found(index, t) for each of these triangles, those that the constructor saw, for which meet(index) is a distance
    /// t <= limit, until it returns true. It may lower `limit`; triangles that are farther may be called for all the same.
    template <Instructions set, class Meet, class Found>
    bool visit(const std::vector<Triangle<Real>>& triangles, const Ray<Real>& ray, const Real& limit, Meet&& meet,
               Found&& found) const
    {
        const auto test = [&](std::int32_t index) {
            const std::optional<Real> t = meet(index);
            return t && *t <= limit && found(index, *t);
        };
        if (tree.empty() || !isUnit(ray.D))
        {
            for (std::size_t index = 0; index < triangles.size(); ++index)
                if (test(std::int32_t(index))) return true;
            return false;
        }
        return tree.template visitLeaves<set>(Vec3<Number>(ray.O), Vec3<Number>(ray.D), limit, [&](std::size_t leaf) {
            for (const std::int32_t index : tree.leafShapes()[leaf])
                if (index >= 0 && test(index)) return true;
            return false;
        });
    }

    std::size_t bytes() const { return tree.bytes(); }

private:
    using Number = Wide<Real>;

    Bvh<Number> tree;
};

} // namespace rt
