// Pictures: linear RGB in memory, files (picture_module.h), and our own comparison.
#pragma once

#include <string>
#include <vector>

#include "common/vec.h"

namespace rt
{

/// Row by row from the top left; linear RGB, unclamped. In double, so that a pixel keeps the bits that `trace` returned.
struct Image
{
    int width = 0, height = 0;
    std::vector<Vec3<double>> pixels;

    Image() = default;
    Image(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h), Vec3<double>(0)) {}

    Vec3<double>& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    const Vec3<double>& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

/// Stands for a pixel whose exercise has not been attempted.
inline const Vec3<double> magenta{1, 0, 1};

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

/// The 8-bit sRGB value of a linear channel, clamped to [0, 1], rounded to nearest; NaN gives 0.
unsigned char toSrgb8(double linear);

/// Throws std::runtime_error with one sentence if no file of any kind can be written there: its folder is missing or not
/// writable, or the path is itself a folder. Call it before long work.
void checkFolder(const std::string& path);

/// Writes text whole or not at all (a temporary file in the same folder, then a rename). Throws std::runtime_error.
void writeTextFile(const std::string& path, const std::string& text);

/// Reads a whole text file. Throws std::runtime_error with one sentence.
std::string readTextFile(const std::string& path);

struct Comparison
{
    bool sameSize = false;
    int wrong = 0;      ///< pixels with a channel that is not finite or not within tolerance
    double worst = 0;   ///< largest difference of a channel
    int x = -1, y = -1; ///< the pixel where it is

    bool equal() const { return sameSize && wrong == 0; }
};

/// A channel is wrong unless both values are finite and |a - b| <= absolute + relative * |b|. (OpenImageIO's own comparison
/// passes a picture that is all NaN, and one that is smaller.)
Comparison compare(const Image& a, const Image& b, double absolute, double relative);

} // namespace rt
