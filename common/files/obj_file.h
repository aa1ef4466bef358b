// Triangle meshes from Wavefront OBJ files.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "common/base/vec.h"

namespace rt
{

using MeshTriangle = std::array<Vec3<double>, 3>;

inline constexpr std::size_t mostMeshTriangles = std::size_t(1) << 24; ///< of one file

/// True if the corners lie on one line, up to the rounding of the two directions.
bool isDegenerate(const MeshTriangle& triangle);

/// The faces of the file, in its order, each with more than three corners cut into triangles: a fan around its first one if it
/// is convex. Positions and faces are used, nothing else. Triangles without area are left out, which adds one warning. Throws std::runtime_error with one
/// sentence, `path:line: what, expected`; without the line if it is about the whole file.
std::vector<MeshTriangle> readObj(const std::string& path, std::vector<std::string>& warnings);

} // namespace rt
