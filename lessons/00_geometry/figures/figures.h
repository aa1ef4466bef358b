// The figures, one function each. They throw NotAttempted, or std::runtime_error if a number is not finite.
#pragma once

#include "lessons/00_geometry/figures/svg.h"
#include "lessons/00_geometry/tutorial.h"

namespace rt::lesson00
{

Svg drawLine2(const Functions& functions, const V2& P, const V2& Q);
Svg drawPointsOfALine();
Svg drawDifferenceOfPoints();
Svg drawLine3(const Functions& functions, const V3& P, const V3& Q);

/// A step of 1, 2 or 5 times a power of ten of which about ten fill the length.
double niceStep(double length);

} // namespace rt::lesson00
