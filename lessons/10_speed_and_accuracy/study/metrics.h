// How wrong a picture is.
#pragma once

#include <vector>

#include "common/base/image.h"

#include "subject.h"

namespace rt::lesson10
{

/// A picture against its reference. Linear values; white is 1.
struct Errors
{
    double maxAbsolute = 0, rms = 0;         ///< over all channels of all pixels
    double maxRelative = 0, rmsRelative = 0; ///< |a - b| / max(|b|, 1/255)
    double psnr = 0;                         ///< 20 log10(1 / rms) dB; infinite for the same bits
    int visible = 0;                         ///< pixels with a channel off by more than 1/255
    int nonFinite = 0;                       ///< pixels with a channel that is NaN or infinite; each counts as off by 1
};

/// Both have the same size.
Errors errorsAgainst(const Image& image, const Image& reference);

/// The pixels with a channel that is not within the tolerance of the reference's.
int pixelsOff(const Image& image, const Image& reference, double tolerance);

/// What the rays of a picture did, against those of the reference.
struct Rays
{
    double perPixel = 0; ///< shadow rays included, all samples
    int wrongFirst = 0,
        wrongShape = 0; ///< pixels whose camera ray met something else; whose ray tree has another shape
    int acnePixels = 0, leakPixels = 0; ///< pixels with at least one such ray
};

Rays raysAgainst(const std::vector<PixelFacts>& facts, const std::vector<PixelFacts>& reference);

} // namespace rt::lesson10
