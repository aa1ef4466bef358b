// A sky to reflect, made by a formula: so the lesson needs no download.
#pragma once

#include "common/base/image.h"

namespace rt
{

/// A lat-long picture, twice as wide as high: blue above, haze at the horizon, sand below, and a sun of radiance 100 towards
/// (-7, 9, 9).
Image makeSky(int height);

} // namespace rt
