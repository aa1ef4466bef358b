// Which of many lamps have a name beside them: two hundred names would be a wall.
#pragma once

#include <vector>

#include "viz/base/extent.h"

namespace rt::viz
{

inline constexpr std::size_t mostNamedLamps = 12;

/// Those that could bring most light to a point, and the first ones among equals; all of them if there are few.
std::vector<bool> namedLamps(const SceneDescription& scene, const vec3& at);

} // namespace rt::viz
