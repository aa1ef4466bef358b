// Several numbers in one register. Each lane does what one number alone would do, so bits do not depend on how many there are.
#pragma once

#include <cstring>

#include "common/vec.h"

namespace rt
{

// What the build's instruction set has; the baseline, SSE2 on x86-64, runs anywhere. g++ and clang know such vectors.
#if defined(__AVX__)
inline constexpr int registerBytes = 32;
#else
inline constexpr int registerBytes = 16;
#endif

/// Real for types that have no registers of several.
template <std::floating_point Real>
struct LanesOf
{
    using Type = Real;
};
template <>
struct LanesOf<float>
{
    typedef float Type __attribute__((vector_size(16))); // four children a node: more are not needed
};
template <>
struct LanesOf<double>
{
    typedef double Type __attribute__((vector_size(registerBytes)));
};

template <std::floating_point Real>
using Lanes = typename LanesOf<Real>::Type;

template <std::floating_point Real>
inline constexpr int laneCount = sizeof(Lanes<Real>) / sizeof(Real);

template <std::floating_point Real>
Lanes<Real> load(const Real* from)
{
    Lanes<Real> lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

template <std::floating_point Real>
void store(const Lanes<Real>& lanes, Real* to)
{
    std::memcpy(to, &lanes, sizeof lanes);
}

} // namespace rt
