// The functions of lesson 00 behind one face, in double: whoever wrote them and whichever type they compute in.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <glm/vec2.hpp>

#include "common/base/vec.h"

namespace rt::lesson00
{

using V2 = glm::vec<2, double, glm::defaultp>;
using V3 = Vec3<double>;

/// y = ax + b
struct SlopeIntercept
{
    double a, b;
};

/// Ax + By + C = 0
struct Implicit
{
    double A, B, C;
};

/// P(t) = O + tD
struct Parametric
{
    V3 O, D;
};

/// All may throw NotAttempted.
struct Functions
{
    std::function<std::optional<SlopeIntercept>(const V2& P, const V2& Q)> slopeIntercept;
    std::function<double(const SlopeIntercept& line, double x)> yAt;
    std::function<Implicit(const V2& P, const V2& Q)> implicitForm;
    std::function<std::pair<V2, V2>(const Implicit& line)> normals2;
    std::function<double(const Implicit& line)> distanceToOrigin;
    std::function<Implicit(const Implicit& line)> withUnitNormal;
    std::function<double(const V3& P, const V3& Q)> segmentLength;
    std::function<Parametric(const V3& P, const V3& Q)> parametricForm;
    std::function<std::pair<V3, V3>(const Parametric& line)> normals3;
    std::function<V3(const Parametric& line, double angle)> unitNormal;
};

/// Those of Geometry<Real>, or of an exercise.
template <class G>
Functions functionsOf()
{
    using Real = decltype(G::SlopeIntercept::a);
    using vec2 = typename G::vec2;
    using vec3 = typename G::vec3;
    constexpr auto out = [](const typename G::Implicit& l) { return Implicit{double(l.A), double(l.B), double(l.C)}; };
    constexpr auto in = [](const Implicit& l) { return typename G::Implicit{Real(l.A), Real(l.B), Real(l.C)}; };
    constexpr auto in3 = [](const Parametric& l) { return typename G::Parametric{vec3(l.O), vec3(l.D)}; };

    Functions f;
    f.slopeIntercept = [](const V2& P, const V2& Q) -> std::optional<SlopeIntercept> {
        const auto line = G::slopeIntercept(vec2(P), vec2(Q));
        if (!line) return std::nullopt;
        return SlopeIntercept{double(line->a), double(line->b)};
    };
    f.yAt = [](const SlopeIntercept& l, double x) { return double(G::yAt({Real(l.a), Real(l.b)}, Real(x))); };
    f.implicitForm = [out](const V2& P, const V2& Q) { return out(G::implicitForm(vec2(P), vec2(Q))); };
    f.normals2 = [in](const Implicit& line) {
        const auto [n1, n2] = G::normals(in(line));
        return std::pair(V2(n1), V2(n2));
    };
    f.distanceToOrigin = [in](const Implicit& line) { return double(G::distanceToOrigin(in(line))); };
    f.withUnitNormal = [in, out](const Implicit& line) { return out(G::withUnitNormal(in(line))); };
    f.segmentLength = [](const V3& P, const V3& Q) { return double(G::segmentLength(vec3(P), vec3(Q))); };
    f.parametricForm = [](const V3& P, const V3& Q) {
        const auto line = G::parametricForm(vec3(P), vec3(Q));
        return Parametric{V3(line.O), V3(line.D)};
    };
    f.normals3 = [in3](const Parametric& line) {
        const auto [n1, n2] = G::normals(in3(line));
        return std::pair(V3(n1), V3(n2));
    };
    f.unitNormal = [in3](const Parametric& line, double angle) { return V3(G::unitNormal(in3(line), Real(angle))); };
    return f;
}

} // namespace rt::lesson00
