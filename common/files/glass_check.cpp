#include "common/files/glass_check.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/scene/coincident.h"

namespace rt
{

namespace
{

/// An edge of a triangle, its ends in an order of their own; `turn` is 1 if the triangle passes it in that order, else -1.
struct Edge
{
    std::array<double, 6> ends;
    int turn;
};

bool isBefore(const Vec3<double>& p, const Vec3<double>& q)
{
    return std::array{p.x, p.y, p.z} < std::array{q.x, q.y, q.z};
}

std::vector<Edge> sortedEdges(const std::vector<MeshTriangle>& triangles)
{
    std::vector<Edge> edges;
    edges.reserve(triangles.size() * 3);
    for (const auto& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k)
        {
            auto p = triangle[k], q = triangle[(k + 1) % 3];
            const int turn = isBefore(p, q) ? 1 : -1;
            if (turn < 0) std::swap(p, q);
            edges.push_back({{p.x, p.y, p.z, q.x, q.y, q.z}, turn});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
    return edges;
}

std::string edgeText(const Edge& edge)
{
    const auto& e = edge.ends;
    return fmt::format("the edge from [{}, {}, {}] to [{}, {}, {}]", e[0], e[1], e[2], e[3], e[4], e[5]);
}

} // namespace

std::string glassMeshFault(const std::vector<MeshTriangle>& triangles)
{
    const auto edges = sortedEdges(triangles);
    const Edge* mixed = nullptr;
    for (auto first = edges.begin(); first != edges.end();)
    {
        auto last = first;
        int sum = 0;
        for (; last != edges.end() && last->ends == first->ends; ++last) sum += last->turn;
        if ((last - first) % 2 != 0)
            return fmt::format("this glass is open: {} belongs to one triangle only; nobody knows what is inside",
                               edgeText(*first));
        if (sum != 0 && !mixed) mixed = &*first;
        first = last;
    }
    if (mixed)
        return fmt::format("the triangles of this glass face both inwards and outwards: both at {} turn the same way; "
                           "expected counter-clockwise as seen from outside for all",
                           edgeText(*mixed));
    double volume = 0;
    for (const auto& [a, b, c] : triangles)
        volume += dot(a - triangles[0][0], cross(b - triangles[0][0], c - triangles[0][0]));
    if (volume < 0)
        return "the triangles of this glass face inwards, so that it is a hollow in a world of glass; expected their "
               "corners counter-clockwise as seen from outside";
    return "";
}

std::string nestedGlassFault(const SceneDescription& scene)
{
    std::vector<std::size_t> glass;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        if (scene.materials[std::size_t(scene.spheres[i].material)].isDielectric()) glass.push_back(i);
    if (glass.size() > 1000) return ""; // each is compared with each
    for (const auto inner : glass)
    {
        const SphereDescription& ball = scene.spheres[inner];
        const std::size_t none = scene.spheres.size();
        std::size_t around = none;
        for (const auto outer : glass)
        {
            const SphereDescription& other = scene.spheres[outer];
            if (ball.radius < other.radius && length(ball.center - other.center) + ball.radius <= other.radius &&
                (around == none || other.radius < scene.spheres[around].radius))
                around = outer;
        }
        if (around == none) continue;
        const auto& within = scene.materials[std::size_t(ball.material)];
        const auto& outside = scene.materials[std::size_t(scene.spheres[around].material)];
        if (within.iorOutside != outside.ior)
            return fmt::format("sphere{} lies in sphere{}, which has ior {}, but its material '{}' has ior_outside {}",
                               inner, around, outside.ior, within.name, within.iorOutside);
    }
    return "";
}

std::string equalSphereFault(const SceneDescription& scene)
{
    const auto first = firstOfEqualSpheres(scene.spheres);
    for (std::size_t i = 0; i < first.size(); ++i)
        if (first[i] != int(i))
            return fmt::format("sphere{} has the centre and the radius of sphere{}, and is never met", i, first[i]);
    return "";
}

} // namespace rt
