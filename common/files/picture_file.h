// Pictures as files: .png and .ppm by ourselves, .exr and .hdr by OpenImageIO (picture_module.h).
#pragma once

#include <string>

#include "common/base/image.h"

namespace rt
{

/// Throws std::runtime_error with one sentence if writeImage could not write to this path: its ending is not one of
/// .png, .ppm, .exr, .hdr, or its folder does not exist or is not writable; NeedsOpenImageIO, where that is so. Call it before
/// a long render.
void checkWritable(const std::string& path);

/// .png and .ppm: 8-bit sRGB, clamped to [0, 1]. .exr (float) and .hdr: linear, unclamped. The file is written whole or not
/// at all. Throws as checkWritable, and std::runtime_error with one sentence.
void writeImage(const Image& image, const std::string& path);

/// What writeImage puts into a .png, as bytes in memory. Throws std::runtime_error with one sentence.
std::string pngBytes(const Image& image);

/// Reads a picture as linear RGB (files of whole numbers, as .png, are taken as sRGB). Throws
/// std::runtime_error with one sentence, or NeedsOpenImageIO.
Image readImage(const std::string& path);

} // namespace rt
