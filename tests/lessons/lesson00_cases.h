// Lesson 00 is functions of numbers, without scenes: it has a subject and cases of its own.
#pragma once

#include "common/todo.h"
#include "lessons/00_geometry/functions.h"
#include "tests/lessons/check.h"

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

/// Like Case. Groups are one for each exercise; a group asks only the function that it is about.
struct GeometryCase
{
    const char* group;
    const char* name;
    const char* slide;
    Kind kind;
    void (*run)(Check&, const GeometrySubject&);
};

std::vector<GeometryCase> geometryCases();

/// Runs one case; a case that throws anything but NotAttempted has failed.
Check runCase(const GeometryCase& which, const GeometrySubject& subject);

} // namespace rt::cases
