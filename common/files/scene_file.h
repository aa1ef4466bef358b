// Scene files: TOML in and out. SCENES.md is the reference of the format.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/scene/scene_description.h"

namespace rt
{

/// A scene file that cannot be used. The message is complete: `file:line:column: what is wrong, what is expected`;
/// without line and column if the file could not be read at all.
struct SceneError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

inline constexpr std::size_t largestSceneFile = std::size_t(256) << 20; ///< bytes
inline constexpr int largestSide = 65536;                               ///< of a picture, in pixels
inline constexpr int mostPixels = 1 << 28;                              ///< of a picture
inline constexpr int deepestTrace = 1024;                               ///< the largest max_depth

/// The words of the file, in the order of the enums that they stand for.
inline constexpr std::array<std::string_view, 3> atCapWords{"black", "sky", "direct"};
inline constexpr std::array<std::string_view, 3> fresnelWords{"exact", "schlick", "none"};
inline constexpr std::array<std::string_view, 2> shadowThroughGlassWords{"block", "tint"};

/// Reads a scene file. Throws SceneError and nothing else.
SceneDescription loadScene(const std::string& path);

/// Reads a scene from text; `name` stands for the file in messages and becomes SceneDescription::file. File names in the
/// scene are relative to the folder of `name`. Throws SceneError and nothing else.
SceneDescription parseScene(std::string_view text, const std::string& name);

/// The scene as a file that reads back to the same numbers, bit for bit. Materials need distinct names; `file` and
/// `warnings` are not written.
std::string sceneToToml(const SceneDescription& scene);

} // namespace rt
