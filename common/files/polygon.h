// Polygons in space, cut into triangles: convex ones by a fan, others by their ears.
#pragma once

#include <array>
#include <vector>

#include "common/base/vec.h"

namespace rt
{

using Corner2 = std::array<double, 2>;

/// The polygon as seen from its front, its largest side about 1. At least three corners.
std::vector<Corner2> flattened(const std::vector<Vec3<double>>& corners);

/// Does it turn one way only? Then a fan fills it.
bool isConvex(const std::vector<Corner2>& polygon);

/// The triangles, as numbers of corners, of a polygon that turns to the left: each but the last is an ear, three corners that
/// follow each other and have no other one within. Empty if there is no ear, as where the polygon crosses itself. Takes time
/// that grows with the square of the number of corners.
/// Meisters, "Polygons have ears", American Mathematical Monthly 82 (1975).
std::vector<std::array<std::size_t, 3>> earsOf(const std::vector<Corner2>& polygon);

} // namespace rt
