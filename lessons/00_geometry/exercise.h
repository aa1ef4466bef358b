// Exercise 00, geometry. Lecture: "Tutorial 2 - Geometry".
// Made from geometry.h by make_exercises.py: the TODOs are yours.
#pragma once

#include "common/exercise.h"

namespace rt::exercise00
{

using Real = double;

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
        // TODO 00-slope (2 points): The slope-intercept form of a line
        // Slide: Tutorial 2 - Geometry, exercise 1a
        todo("00-slope");
    }

    // b) Verify your answer for a) for the two given points: which y has the line at x?
    static Real yAt(const SlopeIntercept& line, Real x)
    {
        // TODO 00-verify (1 point): The line's y at a given x
        // Slide: Tutorial 2 - Geometry, exercise 1b
        todo("00-verify");
    }

    // c) What is the implicit form of the line? Every line has one, and all its multiples are forms of the same line.
    static Implicit implicitForm(const vec2& P, const vec2& Q)
    {
        // TODO 00-implicit (2 points): The implicit form of a line
        // Slide: Tutorial 2 - Geometry, exercise 1c
        todo("00-implicit");
    }

    // d) Determine two normals for the line, with different directions.
    static std::pair<vec2, vec2> normals(const Implicit& line)
    {
        // TODO 00-normals-2d (1 point): Two normals of a line in 2D
        // Slide: Tutorial 2 - Geometry, exercise 1d
        todo("00-normals-2d");
    }

    // e) How far is the line from the origin? (What have C and the length of the normal to do with it?)
    static Real distanceToOrigin(const Implicit& line)
    {
        // TODO 00-distance (2 points): The distance of a line to the origin
        // Slide: Tutorial 2 - Geometry, exercise 1e
        todo("00-distance");
    }

    // e) Another form of the same line: one whose normal has length 1. (What is its C?)
    static Implicit withUnitNormal(const Implicit& line)
    {
        // TODO 00-unit-normal (1 point): The implicit form with a normal of length 1
        // Slide: Tutorial 2 - Geometry, exercise 1e
        todo("00-unit-normal");
    }

    // Exercise 2 is done on paper: slides-notes/00-geometry.md.

    // Exercise 3. Given: a line in 3D through two points P and Q (which differ).

    // a) What is the length of this line segment?
    static Real segmentLength(const vec3& P, const vec3& Q)
    {
        // TODO 00-length (1 point): The length of a segment in 3D
        // Slide: Tutorial 2 - Geometry, exercise 3a
        todo("00-length");
    }

    // b) What is the parametric representation of this line?
    static Parametric parametricForm(const vec3& P, const vec3& Q)
    {
        // TODO 00-parametric (1 point): The parametric form of a line in 3D
        // Slide: Tutorial 2 - Geometry, exercise 3b
        todo("00-parametric");
    }

    // c) Determine two normals for the line, with different directions.
    static std::pair<vec3, vec3> normals(const Parametric& line)
    {
        // TODO 00-normals-3d (2 points): Two normals of a line in 3D
        // Slide: Tutorial 2 - Geometry, exercise 3c
        todo("00-normals-3d");
    }

    // d) How many normals of unit length exist for this line, and how are they organized? The one at an angle, in radians:
    // where the angle is 0 is yours to choose, and which way round it grows.
    static vec3 unitNormal(const Parametric& line, Real angle)
    {
        // TODO 00-circle (3 points): All unit normals of a line in 3D
        // Slide: Tutorial 2 - Geometry, exercise 3d
        todo("00-circle");
    }
};

} // namespace rt::exercise00
