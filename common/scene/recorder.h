// Erasable instruments: what a lesson tells about its rays. Every use in a lesson is a whole statement that starts with
// `rec.`; without them the picture has the same bits.
#pragma once

#include <optional>
#include <source_location>

#include "common/base/hit.h"
#include "common/base/light.h"

namespace rt
{

#if defined(__cpp_lib_source_location)
using SourceLine = std::source_location;
#else
/// clang 14 cannot yet compile its library's std::source_location.
class SourceLine
{
public:
    static constexpr SourceLine current(unsigned line = __builtin_LINE()) { return SourceLine(line); }
    constexpr unsigned line() const { return number; }

private:
    explicit constexpr SourceLine(unsigned line) : number(line) {}
    unsigned number;
};
#endif

/// rec.ray(ray, hit)                          a ray was followed: preorder and ray.depth make the tree
/// rec.shadow(light, I, L, distance, visible) a light was asked for
/// rec.own(color)                             what the point itself sends, before its children add to it
/// rec.capped(ray) or (ray, color)            a ray was not followed; `color` stands in for what it would have brought
/// rec.cutoff(ray)                            a ray was not followed, since it could not have brought enough
/// rec.fresnel(Fr)                            the reflected share at a dielectric
/// rec.color(color)                           what the ray returns
template <class R, class Real>
concept RayRecorder = requires(R rec, const Ray<Real>& ray, const std::optional<Hit<Real>>& hit,
                               const Light<Real>& light, const Point<Real>& I, const Vec3<Real>& v, Real distance)
{
    rec.ray(ray, hit);
    rec.shadow(light, I, v, distance, true);
    rec.own(v);
    rec.capped(ray);
    rec.capped(ray, v);
    rec.cutoff(ray);
    rec.fresnel(distance);
    rec.color(v);
};

/// Records nothing and costs nothing: a test compares the object code with that of the erased text.
struct NoRecorder
{
    void ray(const auto&, const auto&) const {}
    void shadow(const auto&, const auto&, const auto&, auto, bool) const {}
    void own(const auto&) const {}
    void capped(const auto&) const {}
    void capped(const auto&, const auto&) const {}
    void cutoff(const auto&) const {}
    void fresnel(auto) const {}
    void color(const auto&) const {}
};

} // namespace rt
