// Vectors and colours: GLM's, in the scalar type that the tracer runs in.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <limits>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

// __GCC_IEC_559 is 0 under each of the flags that -ffast-math is made of; clang has no such macro.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) ||                               \
    (defined(__GCC_IEC_559) && __GCC_IEC_559 == 0)
#error "raytree must not be built with -ffast-math: NaN, infinity and the order of operations are part of its results"
#endif

namespace rt
{

/// A point, a direction or a linear RGB colour. Right-handed, y up; lengths in scene units.
template <std::floating_point Real>
using Vec3 = glm::vec<3, Real, glm::defaultp>;

using std::abs; // here and in exercises: without it abs(-0.5) is C's, of whole numbers, which is 0

/// What a scene's numbers are computed with before they become Real: double for float, else Real itself.
template <std::floating_point Real>
using Wide = decltype(Real() + double());

template <std::floating_point Real>
inline constexpr Real infinity = std::numeric_limits<Real>::infinity();

/// unit(v) where the square of v's length has no full precision.
template <std::floating_point Real>
[[gnu::noinline]] Vec3<Real> unitOfExtreme(const Vec3<Real>& v)
{
    const Real largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0 && largest <= std::numeric_limits<Real>::max())) return v;
    const int exponent = -std::ilogb(largest);
    const Vec3<Real> scaled(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent));
    return scaled / std::sqrt(dot(scaled, scaled));
}

/// Has a square of v's length all its digits?
template <std::floating_point Real>
constexpr bool isPlainSquare(Real squared)
{
    using Limits = std::numeric_limits<Real>;
    return squared >= Limits::min() / Limits::epsilon() && squared <= Limits::max();
}

/// The unit vector along v; the zero vector stays zero. glm::normalize gives NaN for a zero vector, and zero for vectors
/// so long that their square overflows; here v is first scaled by a power of two, which costs no precision.
template <std::floating_point Real>
[[gnu::always_inline]] inline Vec3<Real> unit(const Vec3<Real>& v)
{
    const Real squared = dot(v, v);
    if (isPlainSquare(squared)) return v / std::sqrt(squared);
    return unitOfExtreme(v);
}

/// The same; `instead` if v is zero.
template <std::floating_point Real>
[[gnu::always_inline]] inline Vec3<Real> unitOr(const Vec3<Real>& v, const Vec3<Real>& instead)
{
    const Real squared = dot(v, v);
    if (isPlainSquare(squared)) return v / std::sqrt(squared);
    return v == Vec3<Real>(0) ? instead : unitOfExtreme(v);
}

/// The largest of the three channels.
template <std::floating_point Real>
Real largestChannel(const Vec3<Real>& color)
{
    return std::max({color.x, color.y, color.z});
}

/// True if no component is NaN or infinite.
template <std::floating_point Real>
bool isFinite(const Vec3<Real>& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The shortest digits that read back to x.
inline std::string shortestDigits(double x)
{
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, x).ptr};
}

/// A number that a scalar type cannot hold; `field` names it as a scene's description does: `sphere0.radius`.
struct UnfitNumber : std::range_error
{
    UnfitNumber(std::string name, const std::string& sentence) : std::range_error(sentence), field(std::move(name)) {}
    std::string field;
};

/// `value` in Real; throws UnfitNumber, naming `what`, if it overflows, or vanishes though it was not zero.
template <std::floating_point Real>
Real narrow(double value, const std::string& what)
{
    const Real narrowed = Real(value);
    if (!std::isfinite(narrowed) || (narrowed == 0 && value != 0))
        throw UnfitNumber(what, what + " = " + shortestDigits(value) + " does not fit the tracer's scalar type");
    return narrowed;
}

/// Of a point or direction each number may vanish beside the others.
template <std::floating_point Real>
Vec3<Real> narrow(const Vec3<double>& v, const std::string& what)
{
    const Vec3<Real> narrowed(v);
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(narrowed[axis])) narrow<Real>(v[axis], what);
    return narrowed;
}

/// Of a colour no channel may vanish.
template <std::floating_point Real>
Vec3<Real> narrowColor(const Vec3<double>& color, const std::string& what)
{
    return {narrow<Real>(color.x, what), narrow<Real>(color.y, what), narrow<Real>(color.z, what)};
}

} // namespace rt
