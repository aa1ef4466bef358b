// The scenes that are measured, by name.
#pragma once

#include <string>

#include "common/scene/scene_description.h"

namespace rt::perf
{

/// s1 .. s5 (files in tests/perf/scenes), s5:N (N spheres of mixed materials on the same area, 1 <= N <= 10^7), s6 (a
/// sphereflake of 7,381 spheres), s6:L (one of L levels, 0 <= L <= 7), or a scene file. Throws SceneError.
SceneDescription benchScene(const std::string& name);

/// The same light from `count` lamps on a circle above the scene.
void setLights(SceneDescription& scene, int count);

/// The same view with another size.
void setSize(SceneDescription& scene, int width, int height);

} // namespace rt::perf
