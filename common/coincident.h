// Which surfaces of a scene lie on one another: the bottom of a cube and the floor that it stands on, the walls of two boxes
// side by side, a ball that is there twice. Rounding would show now the one, now the other. What the file says decides, in the
// file's own digits, so that it is the same in all scalar types.
#pragma once

#include <numeric>

#include "common/scene_description.h"

namespace rt
{

/// Flat surfaces that lie in one plane and on one another, by their indices among planes and triangles, in rising order; with
/// those that are connected through others, such as two cubes on one floor.
struct FlatSheet
{
    std::vector<int> planes, triangles;
};

/// Finds them. Triangles are compared with planes, with loose triangles, and with those of other meshes.
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
        double area, nearest, farthest; ///< its plane's distance from the origin, up to rounding
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
        const Vec N = unit(cross(unit(b - a), unit(c - a)));
        const double area = length(cross(b - a, c - a)), reach = std::abs(a.x) + std::abs(a.y) + std::abs(a.z);
        // The normal of a small triangle far off zero, or of a narrow one, is less certain.
        const double narrow = area / std::max({length(b - a), length(c - a), length(c - b)});
        const double error = 32 * std::numeric_limits<double>::epsilon() * reach * (1 + reach / narrow);
        const double distance = std::abs(dot(N, a));
        return {triangle.corners, index, triangle.owner, N, area, distance - error, distance + error};
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

    /// In the order of their planes' distances from the origin, so that only those are compared that may share one.
    void compareTriangles()
    {
        std::vector<Facet> facets;
        for (std::size_t i = 0; i < triangles.size(); ++i)
            if (const auto facet = facetOf(triangles[i], int(planes.size() + i)); facet.area > 0)
                facets.push_back(facet);
        std::sort(facets.begin(), facets.end(), [](const auto& a, const auto& b) { return a.nearest < b.nearest; });
        std::vector<const Facet*> open;
        long left = mostCompared;
        for (const auto& facet : facets)
        {
            for (std::size_t k = 0; k < open.size();)
            {
                if (--left < 0) return;
                if (open[k]->farthest < facet.nearest)
                {
                    open[k] = open.back();
                    open.pop_back();
                    continue;
                }
                if (open[k]->owner != facet.owner && areAlike(facet, *open[k])) join(open[k]->index, facet.index);
                ++k;
            }
            open.push_back(&facet);
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

    /// Some 0.3 s. Only fine meshes that share large parts of one plane need more; what is left is not looked for.
    static constexpr long mostCompared = 100'000'000;

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
