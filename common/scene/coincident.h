// Which surfaces of a scene lie on one another: the bottom of a cube and the floor that it stands on, the walls of two boxes
// side by side, a ball that is there twice. Rounding would show now the one, now the other. What the file says decides, in the
// file's own digits, so that it is the same in all scalar types.
#pragma once

#include <numeric>
#include <stdexcept>

#include "common/scene/scene_description.h"
#include "common/search/bvh_build.h"

namespace rt
{

/// Flat surfaces that lie in one plane and on one another, by their indices among planes and triangles, in rising order; with
/// those that are connected through others, such as two cubes on one floor.
struct FlatSheet
{
    std::vector<int> planes, triangles;
};

/// Finds them. Triangles are compared with planes, with loose triangles, and with those of other meshes. Throws
/// std::runtime_error if it would take too long: 10^9 pairs of triangles in one place.
class CoincidentSurfaces
{
public:
    explicit CoincidentSurfaces(const SceneDescription& scene)
    {
        for (const auto& p : scene.planes) planes.push_back({p.point, unit(p.normal)});
        int owner = 0;
        for (const auto& t : scene.triangles) triangles.push_back({&t.vertices, owner++});
        for (const auto& mesh : scene.meshes)
        {
            for (const auto& vertices : *mesh.triangles) triangles.push_back({&vertices, owner});
            ++owner;
        }
        if (planes.empty() && owner < 2) return;
        root.resize(planes.size() + triangles.size());
        std::iota(root.begin(), root.end(), 0);
        comparePlanes();
        if (owner > 1) compareTriangles();
    }

    std::vector<FlatSheet> sheets()
    {
        std::vector<FlatSheet> all;
        std::vector<int> sheetOf(root.size(), -1), size(root.size(), 0);
        const int count = int(root.size()), firstTriangle = int(planes.size());
        for (int i = 0; i < count; ++i) ++size[std::size_t(find(i))];
        for (int i = 0; i < count; ++i)
        {
            const auto first = std::size_t(find(i));
            if (size[first] < 2) continue;
            if (sheetOf[first] < 0)
            {
                sheetOf[first] = int(all.size());
                all.emplace_back();
            }
            auto& sheet = all[std::size_t(sheetOf[first])];
            if (i < firstTriangle)
                sheet.planes.push_back(i);
            else
                sheet.triangles.push_back(i - firstTriangle);
        }
        return all;
    }

private:
    using Vec = Vec3<double>;

    struct PlaneOf
    {
        Vec P, N; ///< N has unit length
    };

    using Corners = std::array<Vec, 3>;

    struct Owned
    {
        const Corners* corners;
        int owner; ///< its mesh, or itself
    };

    struct Facet
    {
        const Corners* corners;
        int index, owner;
        Vec N;
        double area;
    };

    /// Is the distance 0, up to the rounding of the numbers? Where the plane faces along an axis nothing is rounded: exactly 0.
    static bool liesOn(const Vec& p, const PlaneOf& plane)
    {
        const Vec size = abs(plane.N), reach = (abs(p) + abs(plane.P)) * size;
        const bool isRounded = (size.x > 0) + (size.y > 0) + (size.z > 0) > 1;
        const double error = isRounded ? 8 * std::numeric_limits<double>::epsilon() * (reach.x + reach.y + reach.z) : 0;
        return std::abs(dot(p - plane.P, plane.N)) <= error;
    }

    static bool liesOn(const Corners& corners, const PlaneOf& plane)
    {
        return liesOn(corners[0], plane) && liesOn(corners[1], plane) && liesOn(corners[2], plane);
    }

    static Facet facetOf(const Owned& triangle, int index)
    {
        const auto& [a, b, c] = *triangle.corners;
        return {triangle.corners, index, triangle.owner, unit(cross(unit(b - a), unit(c - a))),
                length(cross(b - a, c - a))};
    }

    void comparePlanes()
    {
        for (std::size_t i = 0; i < planes.size(); ++i)
        {
            for (std::size_t k = 0; k < i; ++k)
                if (liesOn(planes[i].P, planes[k]) && isAlong(planes[i].N, planes[k].N)) join(int(k), int(i));
            for (std::size_t k = 0; k < triangles.size(); ++k)
                if (liesOn(*triangles[k].corners, planes[i])) join(int(i), int(planes.size() + k));
        }
    }

    static bool isAlong(const Vec& a, const Vec& b)
    {
        const Vec apart = cross(a, b);
        return largestChannel(abs(apart)) <= 8 * std::numeric_limits<double>::epsilon();
    }

    /// Only those whose boxes meet, which a hierarchy of the boxes tells.
    void compareTriangles()
    {
        std::vector<Facet> facets;
        for (std::size_t i = 0; i < triangles.size(); ++i)
            if (const auto facet = facetOf(triangles[i], int(planes.size() + i)); facet.area > 0)
                facets.push_back(facet);
        if (facets.empty()) return;
        const auto boxes = boxesOf(facets);
        const BvhTree tree = BvhBuilder{boxes}.build();
        long left = mostPairs;
        for (std::size_t i = 0; i < facets.size(); ++i)
            visitMeeting(tree, boxes, boxes[i], [&](std::size_t k) {
                if (k >= i || facets[k].owner == facets[i].owner) return;
                if (--left < 0)
                    throw std::runtime_error(
                        "too many triangles lie in one place, expected at most 10^9 pairs of them");
                if (find(facets[k].index) != find(facets[i].index) && areAlike(facets[i], facets[k]))
                    join(facets[k].index, facets[i].index);
            });
    }

    /// In coordinates from -1 to 1, as the hierarchy has them; wider by more than all rounding.
    static std::vector<Box<float>> boxesOf(const std::vector<Facet>& facets)
    {
        Box<double> all;
        for (const auto& facet : facets)
            for (const auto& corner : *facet.corners) all.add(corner);
        const Vec middle = all.middle(), half = all.high - middle;
        const double size = largestChannel(half), reach = largestChannel(max(abs(all.low), abs(all.high)));
        const double pad = double(std::numeric_limits<float>::epsilon()) * 8 +
                           std::numeric_limits<double>::epsilon() * 128 * (reach / size);
        std::vector<Box<float>> boxes(facets.size());
        for (std::size_t i = 0; i < facets.size(); ++i)
            for (const auto& corner : *facets[i].corners)
            {
                const Vec placed = (corner - middle) / size;
                boxes[i].add(Vec3<float>(placed - pad));
                boxes[i].add(Vec3<float>(placed + pad));
            }
        return boxes;
    }

    /// Calls visit(i) for each of the boxes that meets `box`.
    template <class Visit>
    static void visitMeeting(const BvhTree& tree, const std::vector<Box<float>>& boxes, const Box<float>& box,
                             Visit&& visit)
    {
        const auto meets = [&](const float* low, const float* high, int step) {
            for (int axis = 0; axis < 3; ++axis)
                if (low[axis * step] > box.high[axis] || high[axis * step] < box.low[axis]) return false;
            return true;
        };
        std::vector<std::int32_t> open{0};
        while (!open.empty())
        {
            const auto entry = open.back();
            open.pop_back();
            if (entry >= 0)
            {
                const BvhNode& node = tree.nodes[std::size_t(entry)];
                for (int k = 0; k < bvhWidth; ++k)
                    if (node.children >> k & 1 && meets(node.planes + k, node.planes + k + 3 * bvhWidth, bvhWidth))
                        open.push_back(node.child[k]);
                continue;
            }
            for (const auto shape : tree.leaves[std::size_t(~entry)])
                if (shape >= 0 && meets(&boxes[std::size_t(shape)].low.x, &boxes[std::size_t(shape)].high.x, 1))
                    visit(std::size_t(shape));
        }
    }

    static bool areAlike(const Facet& p, const Facet& q)
    {
        const Facet &small = p.area < q.area ? p : q, &large = p.area < q.area ? q : p;
        return liesOn(*small.corners, {(*large.corners)[0], large.N}) && overlap(small, large);
    }

    /// Of two triangles in one plane. A common edge or corner is no overlap.
    static bool overlap(const Facet& p, const Facet& q)
    {
        const Vec size = abs(q.N);
        const int main = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const int x = (main + 1) % 3, y = (main + 2) % 3;
        const auto separates = [&](const Facet& one, const Facet& two) {
            for (std::size_t k = 0; k < 3; ++k)
            {
                const Vec &from = (*one.corners)[k], edge = (*one.corners)[(k + 1) % 3] - from;
                const auto side = [&](const Vec& v) { return edge[x] * (v[y] - from[y]) - edge[y] * (v[x] - from[x]); };
                const double inner = side((*one.corners)[(k + 2) % 3]);
                const auto isOut = [&](const Vec& v) { return inner > 0 ? side(v) <= 0 : side(v) >= 0; };
                if (std::all_of(two.corners->begin(), two.corners->end(), isOut)) return true;
            }
            return false;
        };
        return !separates(p, q) && !separates(q, p);
    }

    int find(int i)
    {
        while (root[std::size_t(i)] != i) i = root[std::size_t(i)] = root[std::size_t(root[std::size_t(i)])];
        return i;
    }

    void join(int a, int b)
    {
        a = find(a), b = find(b);
        root[std::size_t(std::max(a, b))] = std::min(a, b);
    }

    static constexpr long mostPairs = 1'000'000'000; ///< some seconds

    std::vector<PlaneOf> planes;
    std::vector<Owned> triangles;
    std::vector<int> root; ///< planes, then triangles: each names an earlier one of its sheet, or itself
};

/// The first sphere in the file with the same centre and radius; `sphere` itself if there is none before it.
inline std::vector<int> firstOfEqualSpheres(const std::vector<SphereDescription>& spheres)
{
    const auto key = [&](int i) {
        const auto& s = spheres[std::size_t(i)];
        return std::array{s.center.x, s.center.y, s.center.z, s.radius};
    };
    std::vector<int> order(spheres.size()), first(spheres.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    for (std::size_t k = 0; k < order.size(); ++k)
        first[std::size_t(order[k])] =
            k > 0 && key(order[k]) == key(order[k - 1]) ? first[std::size_t(order[k - 1])] : order[k];
    return first;
}

} // namespace rt
