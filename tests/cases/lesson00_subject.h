// What the cases of lesson 00 run on; in a student's process too, so nothing here knows the lesson.
#pragma once

#include <limits>

#include "lessons/00_geometry/functions.h"

namespace rt::cases
{

/// The lesson in some precision, a solved exercise, a student's, or a mutant. All functions may throw NotAttempted.
struct GeometrySubject : lesson00::Functions
{
    double epsilon = 0; ///< of its scalar type, but at least double's: answers come in double

    /// `count` units in the last place of 1, in its precision.
    double ulps(double count) const { return count * epsilon; }
};

template <class Geometry>
GeometrySubject geometrySubject()
{
    using Real = decltype(Geometry::SlopeIntercept::a);
    constexpr auto epsilon = double(std::numeric_limits<Real>::epsilon());
    return {lesson00::functionsOf<Geometry>(), std::max(epsilon, std::numeric_limits<double>::epsilon())};
}

} // namespace rt::cases
