// A scene as POV-Ray 3.7 reads it: the same geometry, light transport and ray depths, so that its picture can be compared
// number by number.
#pragma once

#include <string>

#include "common/scene/scene_description.h"

namespace rt::perf
{

/// Scene description language of POV-Ray 3.7. Throws SceneError, naming what POV-Ray does in another way: skies that are
/// no constant colour, glossy materials, coloured glass, and policies of [trace] other than the defaults.
std::string povScene(const SceneDescription& scene);

} // namespace rt::perf
