// Lesson 00, geometry. Lecture: "Tutorial 2 - Geometry".
#pragma once

#include "common/scene/lesson.h"

namespace rt::lesson00
{

template <std::floating_point Real>
struct Geometry
{
    using vec2 = glm::vec<2, Real, glm::defaultp>;
    using vec3 = Vec3<Real>;

    // y = ax + b
    struct SlopeIntercept
    {
        Real a, b;
    };

    // Ax + By + C = 0
    struct Implicit
    {
        Real A, B, C;
    };

    // P(t) = O + tD
    struct Parametric
    {
        vec3 O, D;
    };

    // Exercise 1. Given: a line in 2D through two points P and Q (which differ).

    // a) What is the slope-intercept form of this line? A vertical line has none.
    static std::optional<SlopeIntercept> slopeIntercept(const vec2& P, const vec2& Q)
    {
        // SOLUTION 00-slope
        if (P.x == Q.x) return std::nullopt;
        const Real a = (Q.y - P.y) / (Q.x - P.x); // rise over run
        const Real b = P.y - a * P.x;             // so that P lies on the line
        return SlopeIntercept{a, b};
        // END
    }

    // b) Verify your answer for a) for the two given points: which y has the line at x?
    static Real yAt(const SlopeIntercept& line, Real x)
    {
        // SOLUTION 00-verify
        return line.a * x + line.b;
        // END
    }

    // c) What is the implicit form of the line? Every line has one, and all its multiples are forms of the same line.
    static Implicit implicitForm(const vec2& P, const vec2& Q)
    {
        // SOLUTION 00-implicit
        const vec2 D = Q - P;
        const vec2 n(D.y, -D.x); // n.D = 0
        return {n.x, n.y, -dot(n, P)};
        // END
    }

    // d) Determine two normals for the line, with different directions.
    static std::pair<vec2, vec2> normals(const Implicit& line)
    {
        // SOLUTION 00-normals-2d
        const vec2 n(line.A, line.B);
        return {n, -n};
        // END
    }

    // e) How far is the line from the origin? (What have C and the length of the normal to do with it?)
    static Real distanceToOrigin(const Implicit& line)
    {
        // SOLUTION 00-distance
        const vec2 n(line.A, line.B);
        return std::abs(line.C) / length(n); // |C| = distance * |n|
        // END
    }

    // e) Another form of the same line: one whose normal has length 1. (What is its C?)
    static Implicit withUnitNormal(const Implicit& line)
    {
        // SOLUTION 00-unit-normal
        const Real n = length(vec2(line.A, line.B));
        return {line.A / n, line.B / n, line.C / n}; // now |C| is the distance
        // END
    }

    // Exercise 2 is done on paper: slides-notes/00-geometry.md.

    // Exercise 3. Given: a line in 3D through two points P and Q (which differ).

    // a) What is the length of this line segment?
    static Real segmentLength(const vec3& P, const vec3& Q)
    {
        // SOLUTION 00-length
        const vec3 D = Q - P;
        return std::sqrt(D.x * D.x + D.y * D.y + D.z * D.z);
        // END
    }

    // b) What is the parametric representation of this line?
    static Parametric parametricForm(const vec3& P, const vec3& Q)
    {
        // SOLUTION 00-parametric
        return {P, Q - P}; // P(0) = P, P(1) = Q
        // END
    }

    // c) Determine two normals for the line, with different directions.
    static std::pair<vec3, vec3> normals(const Parametric& line)
    {
        // SOLUTION 00-normals-3d
        const vec3 D = line.D;
        const vec3 a = abs(D);
        // An axis that D does not point along: the one that it points along least.
        const vec3 axis = a.x <= a.y && a.x <= a.z ? vec3(1, 0, 0) : a.y <= a.z ? vec3(0, 1, 0) : vec3(0, 0, 1);
        const vec3 n1 = cross(D, axis);
        const vec3 n2 = cross(D, n1);
        return {n1, n2};
        // END
    }

    // d) How many normals of unit length exist for this line, and how are they organized? The one at an angle, in radians:
    // where the angle is 0 is yours to choose, and which way round it grows.
    static vec3 unitNormal(const Parametric& line, Real angle)
    {
        // SOLUTION 00-circle
        const vec3 D = unit(line.D);
        const vec3 U = unit(normals(line).first);
        const vec3 V = cross(D, U); // at right angles to D and U, and of length 1 as they are
        return std::cos(angle) * U + std::sin(angle) * V;
        // END
    }
};

} // namespace rt::lesson00
