#include "viz/drawing/mesh.h"

#include <cmath>
#include <numbers>

namespace rt::viz
{

namespace
{

constexpr int sides = 14;
using std::numbers::pi;

int addPoint(Mesh& mesh, const vec3& point, const vec3& normal, const Rgba& color)
{
    mesh.points.push_back(point);
    mesh.normals.push_back(normal);
    mesh.colors.push_back(color);
    return int(mesh.points.size()) - 1;
}

/// The surface between two circles around one axis. `slope` tilts its normals towards the axis' direction.
void addBand(Mesh& mesh, const vec3& a, double ra, const vec3& b, double rb, double slope, const Rgba& start,
             const Rgba& end)
{
    const vec3 axis = unit(b - a);
    const auto [u, v] = across(axis);
    const int first = int(mesh.points.size());
    for (int i = 0; i <= sides; ++i)
    {
        const double angle = 2 * pi * i / sides;
        const vec3 out = std::cos(angle) * u + std::sin(angle) * v, normal = unit(out + slope * axis);
        addPoint(mesh, a + ra * out, normal, start);
        addPoint(mesh, b + rb * out, normal, end);
    }
    for (int i = 0; i < sides; ++i)
    {
        const int p = first + 2 * i;
        mesh.triangles.push_back({p, p + 2, p + 1});
        mesh.triangles.push_back({p + 1, p + 2, p + 3});
    }
}

void addCap(Mesh& mesh, const vec3& centre, const vec3& axis, double radius, const Rgba& color)
{
    const auto [u, v] = across(axis);
    const int middle = addPoint(mesh, centre, axis, color);
    for (int i = 0; i <= sides; ++i)
    {
        const double angle = 2 * pi * i / sides;
        addPoint(mesh, centre + radius * (std::cos(angle) * u + std::sin(angle) * v), axis, color);
        if (i > 0) mesh.triangles.push_back({middle, middle + i, middle + i + 1});
    }
}

} // namespace

std::array<vec3, 2> across(const vec3& axis)
{
    const vec3 other = std::abs(axis.x) < 0.6 ? vec3(1, 0, 0) : vec3(0, 1, 0);
    const vec3 u = unit(cross(axis, other));
    return {u, cross(axis, u)};
}

void addTube(Mesh& mesh, const vec3& from, const vec3& to, double radius, const Rgba& start, const Rgba& end)
{
    const vec3 axis = unit(to - from);
    addBand(mesh, from, radius, to, radius, 0, start, end);
    addCap(mesh, from, -axis, radius, start);
    addCap(mesh, to, axis, radius, end);
}

void addCone(Mesh& mesh, const vec3& base, const vec3& tip, double radius, const Rgba& color)
{
    addBand(mesh, base, radius, tip, 0, radius / glm::length(tip - base), color, color);
    addCap(mesh, base, -unit(tip - base), radius, color);
}

void addDisc(Mesh& mesh, const vec3& centre, const vec3& axis, double radius, double thickness, const Rgba& color)
{
    addTube(mesh, centre - 0.5 * thickness * axis, centre + 0.5 * thickness * axis, radius, color, color);
}

void addCross(Mesh& mesh, const vec3& centre, double size, double thickness, const Rgba& color)
{
    for (int i = 0; i < 4; ++i)
    {
        const vec3 bar = size / std::sqrt(3.0) * vec3(1, i & 1 ? -1 : 1, i & 2 ? -1 : 1);
        addTube(mesh, centre - bar, centre + bar, thickness, color, color);
    }
}

void addSphere(Mesh& mesh, const vec3& centre, double radius, int around, const Rgba& color)
{
    const int rows = around / 2, first = int(mesh.points.size());
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= around; ++i)
        {
            const double theta = pi * j / rows, phi = 2 * pi * i / around;
            const vec3 N(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            addPoint(mesh, centre + radius * N, N, color);
        }
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < around; ++i)
        {
            const int p = first + j * (around + 1) + i, below = p + around + 1;
            mesh.triangles.push_back({p, p + 1, below});
            mesh.triangles.push_back({p + 1, below + 1, below});
        }
}

void addTriangle(Mesh& mesh, const vec3& a, const vec3& b, const vec3& c, const Rgba& color)
{
    const vec3 N = unit(cross(unit(b - a), unit(c - a)));
    const int p = addPoint(mesh, a, N, color);
    addPoint(mesh, b, N, color);
    addPoint(mesh, c, N, color);
    mesh.triangles.push_back({p, p + 1, p + 2});
}

} // namespace rt::viz
