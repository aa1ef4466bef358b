// Several numbers in one register, and which registers the processor has. Each lane does what one number alone would do, so
// bits do not depend on how many there are.
#pragma once

#include <cstring>

#include "common/base/vec.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define RAYTREE_X86 1
#else
#define RAYTREE_X86 0
#endif

// clang's `flatten` goes one level deep only: its programs keep to the baseline.
#if RAYTREE_X86 && !defined(__clang__)
#define RAYTREE_HAS_AVX2 1
/// The function and all that it calls is compiled for AVX2, whatever the rest is compiled for: nothing else may call it but
/// code that asked bestInstructions(). What is inlined here exists elsewhere for the baseline, under its own name.
#define RAYTREE_AVX2 [[gnu::target("avx2"), gnu::flatten]]
#else
#define RAYTREE_HAS_AVX2 0
#endif

namespace rt
{

/// The baseline, SSE2 on x86-64, runs anywhere. g++ and clang know such vectors on every processor.
enum class Instructions
{
    baseline,
    avx2
};

/// What this processor, and its operating system, can do.
inline Instructions bestInstructions()
{
#if RAYTREE_HAS_AVX2
    static const bool avx2 = (__builtin_cpu_init(), __builtin_cpu_supports("avx2"));
    if (avx2) return Instructions::avx2;
#endif
    return Instructions::baseline;
}

/// `bytes / sizeof(Number)` numbers; one for types that have no registers of several.
template <std::floating_point Number, int bytes>
struct LanesOf
{
    using Type = Number;
};
template <int bytes>
struct LanesOf<float, bytes>
{
    typedef float Type __attribute__((vector_size(bytes)));
};
template <int bytes>
struct LanesOf<double, bytes>
{
    typedef double Type __attribute__((vector_size(bytes)));
};

template <Instructions set>
inline constexpr int registerBytes = set == Instructions::avx2 ? 32 : 16;

template <std::floating_point Number, Instructions set>
using Lanes = typename LanesOf<Number, registerBytes<set>>::Type;

template <std::floating_point Number, Instructions set>
inline constexpr int laneCount = sizeof(Lanes<Number, set>) / sizeof(Number);

/// Are there registers of several?
template <std::floating_point Number>
inline constexpr bool hasLanes = laneCount<Number, Instructions::baseline> > 1;

/// Bit k says whether lane k of a comparison holds.
inline unsigned bitsOf(bool holds)
{
    return holds;
}

template <class Mask>
unsigned bitsOf(const Mask& mask)
{
    unsigned bits = 0;
    for (unsigned k = 0; k < sizeof mask / sizeof mask[0]; ++k) bits |= unsigned(mask[k] & 1) << k;
    return bits;
}

#if RAYTREE_X86
// The one thing that vectors cannot say: a single instruction for the above.
inline unsigned bitsOf(const decltype(Lanes<float, Instructions::baseline>{} < 0) & mask)
{
    return unsigned(__builtin_ia32_movmskps((Lanes<float, Instructions::baseline>)mask));
}
inline unsigned bitsOf(const decltype(Lanes<double, Instructions::baseline>{} < 0) & mask)
{
    return unsigned(__builtin_ia32_movmskpd((Lanes<double, Instructions::baseline>)mask));
}
#endif
#if RAYTREE_HAS_AVX2
[[gnu::target("avx2")]] inline unsigned bitsOf(const decltype(Lanes<float, Instructions::avx2>{} < 0) & mask)
{
    return unsigned(__builtin_ia32_movmskps256((Lanes<float, Instructions::avx2>)mask));
}
[[gnu::target("avx2")]] inline unsigned bitsOf(const decltype(Lanes<double, Instructions::avx2>{} < 0) & mask)
{
    return unsigned(__builtin_ia32_movmskpd256((Lanes<double, Instructions::avx2>)mask));
}
#endif

} // namespace rt
