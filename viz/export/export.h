// The ray tree as files for other programs. No window is needed.
#pragma once

#include <string>
#include <vector>

#include "viz/state/controller.h"

namespace rt::viz
{

/// Writes `path` if it ends in .json, .vtp, .glb, .gltf or .html; otherwise path is a folder, made if need be, that gets
/// ray_tree.json, .vtp, .glb, .gltf, .html, and picture.png if there is a picture. Returns the files. Each is written whole
/// or not at all. Throws std::runtime_error with one sentence.
std::vector<std::string> exportTo(const std::string& path, const Controller& controller);

/// Throws std::runtime_error with one sentence if exportTo could not write there. Call it before long work.
void checkExport(const std::string& path);

} // namespace rt::viz
