// Triangles with colours, made by hand: the same data for the screen and, later, for files.
#pragma once

#include <array>
#include <vector>

#include "viz/base/extent.h"
#include "viz/base/palette.h"

namespace rt::viz
{

struct Mesh
{
    std::vector<vec3> points;
    std::vector<vec3> normals; ///< one a point, unit
    std::vector<Rgba> colors;  ///< one a point
    std::vector<std::array<int, 3>> triangles;

    bool empty() const { return triangles.empty(); }
};

/// A round rod, its ends closed by discs; its colour runs from `start` to `end`.
void addTube(Mesh& mesh, const vec3& from, const vec3& to, double radius, const Rgba& start, const Rgba& end);
/// A cone whose tip is `tip`.
void addCone(Mesh& mesh, const vec3& base, const vec3& tip, double radius, const Rgba& color);
/// A flat ring around an axis: a disc with thickness.
void addDisc(Mesh& mesh, const vec3& centre, const vec3& axis, double radius, double thickness, const Rgba& color);
/// Three crossed bars.
void addCross(Mesh& mesh, const vec3& centre, double size, double thickness, const Rgba& color);
void addSphere(Mesh& mesh, const vec3& centre, double radius, int sides, const Rgba& color);
void addTriangle(Mesh& mesh, const vec3& a, const vec3& b, const vec3& c, const Rgba& color);

/// Two unit vectors at right angles to `axis` and to one another.
std::array<vec3, 2> across(const vec3& axis);

} // namespace rt::viz
