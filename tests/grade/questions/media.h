// Two media and the angles between them, for questions about refraction and Fresnel.
#pragma once

#include <cmath>

#include "tests/grade/questions/random.h"

namespace rt::grade
{

/// Indices of refraction.
struct Media
{
    double thin, dense;
};

/// The denser medium's index is at least `ratio` times the other's, at most 1.8 times.
inline Media media(Random& random, double ratio)
{
    const double thin = random.in(1, 1.4);
    return {thin, thin * random.in(ratio, 1.8)};
}

/// The cosine of an angle of incidence whose sin2 is this.
inline double cosineFor(double sin2, double n1, double n2)
{
    const double sin1 = sin2 * n2 / n1;
    return std::sqrt(1 - sin1 * sin1);
}

} // namespace rt::grade
