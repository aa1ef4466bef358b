// What a ray that leaves one triangle meets of others. Its origin is rounded, so it may lie a little beside its triangle, and
// before or behind those that touch it. Where it lies is known all the same: on that triangle. So what can be told from the
// triangles alone, from common corners and from who lies on which side of whose plane, is not asked of the origin; and no
// distance is too small.
//
// Kept out of line: copies of it in each search took longer to compile than all the rest of a student's program.
#pragma once

#include <array>

#include "common/base/shapes.h"

namespace rt
{

template <std::floating_point Real>
class LeaveTriangle
{
public:
    LeaveTriangle(const Ray<Real>& leavingRay, const Triangle<Real>& leftTriangle)
        : ray(leavingRay), left(leftTriangle), side(dot(ray.D, left.N))
    {
    }

    /// Will the rounded origin do? If it still lies within the triangle, seen along the ray; never in float.
    [[gnu::noinline]] bool startsWithin() const
    {
        if constexpr (!std::is_same_v<Real, Wide<Real>>) return false;
        const Crossing line(ray, left);
        return (line.u > 0 && line.v > 0 && line.w > 0) || (line.u < 0 && line.v < 0 && line.w < 0);
    }

    /// The same in more digits, if there are more: the origin is moved into the triangle, by no more than it was rounded.
    [[gnu::noinline]] LeaveTriangle<Wide<Real>> fromWithin() const
    {
        using Number = Wide<Real>;
        auto wide = widened(left);
        wide.N = normal(wide);
        LeaveTriangle<Number> inside(widened(ray), wide);
        const typename Shapes<Number>::Crossing line(inside.ray, inside.left);
        const Number area = line.u + line.v + line.w;
        const auto share = [&](Number x) { return std::max<Number>(x / area, std::numeric_limits<Real>::epsilon()); };
        const Number u = share(line.u), v = share(line.v), w = share(line.w);
        const auto O = (u * inside.left.a + v * inside.left.b + w * inside.left.c) / (u + v + w);
        if (isFinite(O)) inside.ray.O = O;
        return inside;
    }

    const Vec3<Real>& origin() const { return ray.O; }

    static Ray<Wide<Real>> widened(const Ray<Real>& ray)
    {
        return {.O = Vec3<Wide<Real>>(ray.O), .D = Vec3<Wide<Real>>(ray.D)};
    }

    static Triangle<Wide<Real>> widened(const Triangle<Real>& triangle)
    {
        using Vec = Vec3<Wide<Real>>;
        return {Vec(triangle.a), Vec(triangle.b), Vec(triangle.c)}; // whatIsKnown makes its own normal
    }

    /// The distance t > 0 to the other triangle, or nothing: the smallest number for one that the ray meets where it starts.
    [[gnu::noinline]] std::optional<Real> meet(const Triangle<Real>& other) const
    {
        Crossing line(ray, other);
        if (!line.isInside() && !closeGaps(line, other)) return std::nullopt;
        const Real t = line.distance();
        if (!(std::abs(t) < infinity<Real>) || !Shapes<Real>::isNear(ray.O + t * ray.D, ray.O, other))
            return std::nullopt;
        if (isOtherSideAtCorner(other, t)) return std::nullopt;
        switch (whatIsKnown(other))
        {
        case Known::ahead:
            return std::max(t, std::numeric_limits<Real>::denorm_min());
        case Known::never:
            return std::nullopt;
        case Known::notBehind:
            if (t == 0) return std::numeric_limits<Real>::denorm_min();
            break;
        case Known::nothing:
            break;
        }
        return t > 0 ? std::optional(t) : std::nullopt;
    }

private:
    using Crossing = typename Shapes<Real>::Crossing;
    using Corners = std::array<Vec3<Real>, 3>;

    enum class Known
    {
        ahead,     ///< its plane is ahead
        never,     ///< its plane is behind, or it is behind the plane that the ray leaves
        notBehind, ///< a common corner: where the ray starts on its plane, it meets it
        nothing
    };

    template <std::floating_point Number>
    static Vec3<Number> normal(const Triangle<Number>& triangle)
    {
        return unit(cross(unit(triangle.b - triangle.a), unit(triangle.c - triangle.a)));
    }

    static Corners cornersOf(const Triangle<Real>& triangle) { return {triangle.a, triangle.b, triangle.c}; }

    static int find(const Vec3<Real>& corner, const Triangle<Real>& triangle)
    {
        return corner == triangle.a ? 0 : corner == triangle.b ? 1 : corner == triangle.c ? 2 : -1;
    }

    static bool haveOneSign(Wide<Real> a, Wide<Real> b) { return (a > 0 && b > 0) || (a < 0 && b < 0); }

    /// Above the triangle's plane; exactly 0 for its own corners.
    static Wide<Real> height(const Vec3<Real>& corner, const Triangle<Real>& triangle)
    {
        if (find(corner, triangle) >= 0) return 0;
        return dot(Vec3<Wide<Real>>(corner) - Vec3<Wide<Real>>(triangle.a), Vec3<Wide<Real>>(triangle.N));
    }

    /// How far the origin may have been rounded off, and vertices as seen from there.
    Real rounding(const Triangle<Real>& other) const
    {
        return 16 * std::numeric_limits<Real>::epsilon() * (sum(ray.O) + sum(other.a) + sum(other.b) + sum(other.c));
    }

    static Real sum(const Vec3<Real>& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

    /// From within a fold the ray cannot pass below the common edge, nor out of a mesh between the triangles at a common corner,
    /// whatever its rounded origin says: edges that it misses by no more than rounding are moved to it. True if it is inside then.
    bool closeGaps(Crossing& line, const Triangle<Real>& other) const
    {
        const int a = find(other.a, left) >= 0, b = find(other.b, left) >= 0, c = find(other.c, left) >= 0;
        if (a + b + c == 0) return false;
        // The value of an edge is a distance from it times its length.
        const auto slack = rounding(other) * (sum(other.b - other.a) + sum(other.c - other.a));
        const auto area = line.u + line.v + line.w;
        bool atCorner = false;
        const auto close = [&](auto& edge, int ends) {
            if (ends == 0 || haveOneSign(edge, area) || !(std::abs(edge) <= slack)) return;
            edge = 0;
            if (ends == 1) atCorner = true;
        };
        close(line.u, b + c);
        close(line.v, c + a);
        close(line.w, a + b);
        if (!line.isInside() || !haveOneSign(area, line.u + line.v + line.w)) return false;
        return !atCorner || (std::abs(area) > 4 * slack && haveOneSign(dot(ray.D, normal(other)), -side));
    }

    /// What leaves an inner side meets inner sides first; so where it starts, but for rounding, at a common corner, outer ones are
    /// not met. They would be if it had got out between two triangles that it missed by as little.
    bool isOtherSideAtCorner(const Triangle<Real>& other, Real t) const
    {
        const auto theirs = cornersOf(other);
        if (std::count_if(theirs.begin(), theirs.end(), [&](const auto& p) { return find(p, left) >= 0; }) != 1)
            return false;
        const Real along = dot(ray.D, normal(other));
        return haveOneSign(along, side) && std::abs(t * along) <= rounding(other);
    }

    /// The number of the other triangle's corner that is not on the common edge; -1 if there is none such.
    int commonEdge(const Triangle<Real>& other) const
    {
        const bool a = find(other.a, left) >= 0, b = find(other.b, left) >= 0, c = find(other.c, left) >= 0;
        if (a + b + c != 2) return -1;
        return !a ? 0 : !b ? 1 : 2;
    }

    Known whatIsKnown(Triangle<Real> other) const
    {
        other.N = normal(other); // in these digits
        const auto theirs = cornersOf(other);
        int common = 0, above = 0;
        for (const auto& corner : theirs)
        {
            common += find(corner, left) >= 0;
            const auto h = height(corner, left);
            above += side == 0 ? h != 0 : haveOneSign(h, side);
        }
        if (above == 0 || common == 3) return Known::never;
        if (side == 0) return Known::nothing;
        const Real along = dot(ray.D, other.N);
        if (common == 2) return isAheadInFold(other, along) ? Known::ahead : Known::never;

        int before = 0, behind = 0;
        for (const auto& corner : cornersOf(left))
        {
            const auto h = height(corner, other);
            before += haveOneSign(h, -along);
            behind += haveOneSign(h, along);
        }
        if (before == 0) return Known::never;
        if (behind > 0) return common == 1 ? Known::notBehind : Known::nothing;
        return Known::ahead;
    }

    /// The two triangles form a fold that is open to the ray's side. Which side of the other one faces into it? Its front,
    /// if the ray leaves a front and both have the same sense, that is, pass their common edge in opposite ways.
    bool isAheadInFold(const Triangle<Real>& other, Real along) const
    {
        const auto theirs = cornersOf(other), ours = cornersOf(left);
        const auto opposite = std::size_t(commonEdge(other));
        const auto& p = theirs[(opposite + 1) % 3];
        const auto& q = theirs[(opposite + 2) % 3];
        const bool sameSense = ours[std::size_t(find(q, left) + 1) % 3] == p;
        return haveOneSign(along, sameSense ? -side : side);
    }

    template <std::floating_point>
    friend class LeaveTriangle;

    Ray<Real> ray;
    Triangle<Real> left;
    Real side; ///< to which the ray leaves: the sign is that of D.N
};

} // namespace rt
