// Does a scene's glass say what lies on its two sides? What contradicts is traced all the same, and told in a warning.
#pragma once

#include <string>
#include <vector>

#include "common/files/obj_file.h"
#include "common/scene/scene_description.h"

namespace rt
{

/// What is wrong with a glass mesh: open, of mixed sense, or wound inwards; "" if nothing is.
std::string glassMeshFault(const std::vector<MeshTriangle>& triangles);

/// One glass ball within another whose `ior` is not what it says of its outside; "" if there is none, or very many balls.
std::string nestedGlassFault(const SceneDescription& scene);

/// The first sphere that has the centre and the radius of another before it, so that no ray meets it; "" if there is none.
std::string equalSphereFault(const SceneDescription& scene);

} // namespace rt
