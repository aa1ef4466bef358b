// The picture that should be, the one that is, and where they differ.
#pragma once

#include <optional>
#include <string>

#include "common/scene/scene_description.h"
#include "tests/grade/result.h"

namespace rt::grade
{

/// A picture that a case asked for.
struct Seen
{
    SceneDescription scene;
    Image picture;
};

/// The triple of a case that failed with "NAME.exr: ...": NAME.exr is a stored picture of the course. The title is the scene's
/// file, relative to the project; (x, y) is the worst pixel, in pixels of the scene file's own size. Nothing if `what` names no
/// stored picture, or the sizes differ.
std::optional<PictureTriple> triple(const std::string& what, const Seen& seen);

/// Side by side, each pixel as a square of `scale` pixels.
Image sideBySide(const PictureTriple& triple, int scale);

/// The same for a terminal with 24-bit colours: two pixels a character, half the size.
std::string halfBlocks(const PictureTriple& triple);

} // namespace rt::grade
