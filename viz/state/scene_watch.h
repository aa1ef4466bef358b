// A scene that follows its file.
#pragma once

#include <functional>
#include <optional>

#include "common/scene/scene_description.h"

namespace rt::viz
{

/// The scene, if its file or one that it names has been written since the last call (or since this one); throws one
/// sentence if it cannot be read.
std::function<std::optional<SceneDescription>()> watchScene(const SceneDescription& scene,
                                                            const std::function<SceneDescription()>& load);

} // namespace rt::viz
