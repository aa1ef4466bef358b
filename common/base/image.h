// Pictures in memory: linear RGB, and our own comparison. Their files are those of files/picture_file.h.
#pragma once

#include <vector>

#include "common/base/vec.h"

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

/// The 8-bit sRGB value of a linear channel, clamped to [0, 1], rounded to nearest; NaN gives 0.
unsigned char toSrgb8(double linear);

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
