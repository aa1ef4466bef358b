// A picture as the bytes of a file, for files that hold pictures.
#pragma once

#include <string>

#include "common/image.h"

namespace rt::viz
{

/// What writeImage puts into a .png: 8-bit sRGB. Throws std::runtime_error with one sentence.
std::string pngBytes(const Image& image);

} // namespace rt::viz
