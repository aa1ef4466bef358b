// Lesson 00: Tutorial 2. Any correct answer is right: implicit forms up to a factor, normals of any length and either
// direction, parametric forms from either end, a circle that starts anywhere and runs either way.

#include "tests/cases/lesson00_cases.h"

#include <random>

namespace rt::cases
{

namespace
{

using lesson00::Implicit;
using lesson00::Parametric;
using lesson00::V2;
using lesson00::V3;

const double pi = std::acos(-1.0);

using cases::text; // of a V3 too: it would become a V2 otherwise

std::string text(const V2& v)
{
    return fmt::format("({:.9g}, {:.9g})", v.x, v.y);
}

std::string text(const Implicit& line)
{
    return fmt::format("{:.9g}x + {:.9g}y + {:.9g} = 0", line.A, line.B, line.C);
}

V2 normalOf(const Implicit& line)
{
    return {line.A, line.B};
}

/// From the origin along the normal of a form to the line.
double signedDistance(const Implicit& line, const V2& p)
{
    return (dot(normalOf(line), p) + line.C) / length(normalOf(line));
}

/// Random points whose coordinates are multiples of 1/64 below 8: exact in every scalar type.
struct Random
{
    std::mt19937 bits{2016};
    double number() { return (int(bits() % 1024u) - 512) / 64.0; }
    V2 point2()
    {
        const double x = number();
        return {x, number()};
    }
    V3 point3()
    {
        const V2 xy = point2();
        return {xy.x, xy.y, number()};
    }
};

/// Pairs of points in the plane, at least 1 apart.
template <class Visit>
void forLines2(Visit&& visit)
{
    Random random;
    for (int i = 0; i < 100; ++i)
    {
        const V2 P = random.point2(), Q = random.point2();
        if (length(Q - P) >= 1) visit(P, Q);
    }
}

/// Pairs of points in space: random, along each axis both ways, and nearly along one.
template <class Visit>
void forLines3(Visit&& visit)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
        {
            V3 D(0), nearly(1.0 / 1024);
            D[axis] = sign * 2;
            nearly[axis] = sign;
            visit(V3(0), D);
            visit(V3(1, -2, 3), V3(1, -2, 3) + D);
            visit(V3(1, -2, 3), V3(1, -2, 3) + nearly);
        }
    Random random;
    for (int i = 0; i < 100; ++i)
    {
        const V3 P = random.point3(), Q = random.point3();
        if (length(Q - P) >= 1) visit(P, Q);
    }
}

/// Is this a form of the line, up to a factor?
void sameLine(Check& check, const std::string& what, const Implicit& expected, const Implicit& got, double tolerance)
{
    const double turn = dot(normalOf(expected), normalOf(got)) < 0 ? -1 : 1;
    const auto scaled = [](const Implicit& l, double sign) { return V3(l.A, l.B, l.C) * (sign / length(normalOf(l))); };
    check.near(fmt::format("{}: {}, scaled to a normal of length 1", what, text(got)), scaled(expected, 1),
               scaled(got, turn), tolerance);
}

/// P(t) = O + tD meets the point.
void passes(Check& check, const std::string& what, const Parametric& line, const V3& point, double tolerance)
{
    const double t = dot(point - line.O, line.D) / dot(line.D, line.D);
    check.near(fmt::format("{}: the point of O + tD nearest to {}, with O = {}, D = {}", what, cases::text(point),
                           cases::text(line.O), cases::text(line.D)),
               point, line.O + t * line.D, tolerance);
}

/// Is n a normal of a line along D?
template <class Vector>
void isNormal(Check& check, const std::string& what, const Vector& n, const Vector& D, double tolerance)
{
    check.that(fmt::format("{} is not zero", what), length(n) > 0);
    check.near(fmt::format("cosine of the angle between {} = {} and the line's direction {}", what, text(n), text(D)),
               0, dot(n, D) / (length(n) * length(D)), tolerance);
}

template <class Vector>
void differInDirection(Check& check, const Vector& n1, const Vector& n2)
{
    check.that(fmt::format("n1 = {} and n2 = {} have different directions", text(n1), text(n2)),
               length(n1 / length(n1) - n2 / length(n2)) > 1e-3);
}

std::string points(const auto& P, const auto& Q)
{
    return fmt::format("line through {} and {}", text(P), text(Q));
}

void slopeCases(std::vector<GeometryCase>& cases)
{
    constexpr auto a = "Tutorial 2 - Geometry, exercise 1a", b = "Tutorial 2 - Geometry, exercise 1b";
    const auto add = [&](const GeometryCase& which) { cases.push_back(which); };
    add({"SlopeIntercept", "OfTheTutorialsLineIsTwoFifthsXPlusSixFifths", a, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             for (const auto& [P, Q] : {std::pair(V2(-3, 0), V2(2, 2)), {V2(2, 2), V2(-3, 0)}})
             {
                 const auto line = s.slopeIntercept(P, Q);
                 check.that(points(P, Q) + " has a slope, so std::nullopt is wrong", line.has_value());
                 if (!line) continue;
                 check.near("a in y = ax + b", 0.4, line->a, s.ulps(8));
                 check.near("b in y = ax + b", 1.2, line->b, s.ulps(8));
             }
         }});
    add({"SlopeIntercept", "OfAHorizontalLineHasSlopeZero", a, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             const auto line = s.slopeIntercept({1, 3}, {5, 3});
             check.that("a horizontal line has a slope, 0, so std::nullopt is wrong", line.has_value());
             check.near("a in y = ax + b, through (1, 3) and (5, 3)", 0, line ? line->a : NAN, 0);
             check.near("b in y = ax + b, through (1, 3) and (5, 3)", 3, line ? line->b : NAN, s.ulps(8));
         }});
    add({"SlopeIntercept", "OfAVerticalLineDoesNotExist", a, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             check.that("the line through (2, -1) and (2, 5) has no slope, so std::nullopt is right",
                        !s.slopeIntercept({2, -1}, {2, 5}));
             check.that("the line through (0, 5) and (0, -1) has no slope, so std::nullopt is right",
                        !s.slopeIntercept({0, 5}, {0, -1}));
         }});
    add({"SlopeIntercept", "HoldsForBothPoints", a, Kind::property, [](Check& check, const GeometrySubject& s) {
             forLines2([&](const V2& P, const V2& Q) {
                 if (std::abs(P.x - Q.x) < 1) return;
                 const auto line = s.slopeIntercept(P, Q);
                 check.that(points(P, Q) + " has a slope, so std::nullopt is wrong", line.has_value());
                 for (const V2& p : {P, Q})
                     check.near(fmt::format("{}: ax + b at x = {}", points(P, Q), p.x), p.y,
                                line ? line->a * p.x + line->b : NAN, s.ulps(2048));
             });
         }});
    add({"YAt", "GivesTheTutorialsPoints", b, Kind::knownValue, [](Check& check, const GeometrySubject& s) {
             check.near("0.4 * -3 + 1.2", 0, s.yAt({0.4, 1.2}, -3), s.ulps(8));
             check.near("0.4 * 2 + 1.2", 2, s.yAt({0.4, 1.2}, 2), s.ulps(8));
         }});
    add({"YAt", "IsAxPlusB", b, Kind::property, [](Check& check, const GeometrySubject& s) {
             Random random;
             for (int i = 0; i < 50; ++i)
             {
                 const double slope = random.number(), intercept = random.number(), x = random.number();
                 check.near(fmt::format("{} * {} + {}", slope, x, intercept), slope * x + intercept,
                            s.yAt({slope, intercept}, x), s.ulps(8));
             }
         }});
}

void implicitCases(std::vector<GeometryCase>& cases)
{
    constexpr auto c = "Tutorial 2 - Geometry, exercise 1c", d = "Tutorial 2 - Geometry, exercise 1d",
                   e = "Tutorial 2 - Geometry, exercise 1e";
    const auto add = [&](const GeometryCase& which) { cases.push_back(which); };
    add({"Implicit", "OfTheTutorialsLineIsTwoXMinusFiveYPlusSix", c, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             sameLine(check, "through (-3, 0) and (2, 2)", {2, -5, 6}, s.implicitForm({-3, 0}, {2, 2}), s.ulps(16));
             sameLine(check, "through (2, 2) and (-3, 0)", {2, -5, 6}, s.implicitForm({2, 2}, {-3, 0}), s.ulps(16));
         }});
    add({"Implicit", "ExistsForVerticalAndHorizontalLines", c, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             sameLine(check, "through (2, -1) and (2, 5)", {1, 0, -2}, s.implicitForm({2, -1}, {2, 5}), s.ulps(16));
             sameLine(check, "through (0, -1) and (0, 5)", {1, 0, 0}, s.implicitForm({0, -1}, {0, 5}), s.ulps(16));
             sameLine(check, "through (1, 3) and (5, 3)", {0, 1, -3}, s.implicitForm({1, 3}, {5, 3}), s.ulps(16));
             sameLine(check, "through (0, 0) and (2, 1)", {1, -2, 0}, s.implicitForm({0, 0}, {2, 1}), s.ulps(16));
         }});
    add({"Implicit", "IsZeroOnTheLineAndElsewhereTellsTheDistance", c, Kind::property,
         [](Check& check, const GeometrySubject& s) {
             forLines2([&](const V2& P, const V2& Q) {
                 const auto line = s.implicitForm(P, Q);
                 const auto what = fmt::format("{}, {}: distance (Ax + By + C) / |n| of", points(P, Q), text(line));
                 const V2 D = (Q - P) / length(Q - P), aside(-D.y, D.x);
                 const double side = dot(aside, normalOf(line)) < 0 ? -1 : 1;
                 check.near(what + " P", 0, signedDistance(line, P), s.ulps(512));
                 check.near(what + " Q", 0, signedDistance(line, Q), s.ulps(512));
                 check.near(what + " a point 3 beside", 3, side * signedDistance(line, P + 3.0 * aside), s.ulps(512));
             });
         }});
    add({"Normals2D", "OfTheTutorialsLineAreAlongTwoMinusFive", d, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             const auto [n1, n2] = s.normals2({2, -5, 6});
             const double first = dot(n1, V2(2, -5)) < 0 ? -1 : 1;
             const V3 expected = V3(2, -5, 0) / std::sqrt(29.0);
             check.near("one normal of 2x - 5y + 6 = 0, scaled to length 1, turned to (2, -5)", expected,
                        first * V3(n1, 0) / length(n1), s.ulps(16));
             check.near("the other, turned round", expected, -first * V3(n2, 0) / length(n2), s.ulps(16));
         }});
    add({"Normals2D", "StandAtRightAnglesOnTheLineToBothSides", d, Kind::property,
         [](Check& check, const GeometrySubject& s) {
             const auto ask = [&](const Implicit& line) {
                 const auto [n1, n2] = s.normals2(line);
                 const V2 along(line.B, -line.A);
                 isNormal(check, text(line) + ": n1", n1, along, s.ulps(16));
                 isNormal(check, text(line) + ": n2", n2, along, s.ulps(16));
                 differInDirection(check, n1, n2);
             };
             for (const auto& line : {Implicit{3, 0, 6}, {0, 3, -6}, {-1, 0, 0}, {0, -0.5, 0}, {1, 1, 5}, {3, 4, -1}})
                 ask(line);
             Random random;
             for (int i = 0; i < 50; ++i)
             {
                 const V2 n = random.point2();
                 if (length(n) > 0.1) ask({n.x, n.y, random.number()});
             }
         }});
    add({"Distance", "OfTheTutorialsLineIsSixOverTheRootOf29", e, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             check.near("distance of 2x - 5y + 6 = 0", 6 / std::sqrt(29.0), s.distanceToOrigin({2, -5, 6}), s.ulps(8));
         }});
    add({"Distance", "IsTheSameForAllFormsOfALine", e, Kind::knownValue, [](Check& check, const GeometrySubject& s) {
             for (const double k : {-1.0, 10.0, -0.25, 1024.0})
             {
                 const Implicit line{3 * k, 4 * k, 10 * k};
                 check.near("distance of " + text(line), 2, s.distanceToOrigin(line), s.ulps(8));
             }
             check.near("distance of x - 3 = 0", 3, s.distanceToOrigin({1, 0, -3}), s.ulps(8));
             check.near("distance of 2y + 8 = 0", 4, s.distanceToOrigin({0, 2, 8}), s.ulps(8));
             check.near("distance of x + y = 0", 0, s.distanceToOrigin({1, 1, 0}), 0);
         }});
    add({"Distance", "IsHowFarTheNearestPointIs", e, Kind::property, [](Check& check, const GeometrySubject& s) {
             for (int i = 0; i < 50; ++i)
             {
                 const double angle = i * 0.7, scale = 1 + i % 7, h = i * 0.25;
                 const V2 n(scale * std::cos(angle), scale * std::sin(angle)); // the nearest point is h n/|n|
                 const Implicit line{n.x, n.y, -scale * h};
                 check.near("distance of " + text(line), h, s.distanceToOrigin(line), s.ulps(32));
             }
         }});
    add({"UnitNormalForm", "HasANormalOfLengthOneAndIsTheSameLine", e, Kind::property,
         [](Check& check, const GeometrySubject& s) {
             const auto ask = [&](const Implicit& line) {
                 const auto got = s.withUnitNormal(line);
                 check.near(fmt::format("length of the normal of {}, made from {}", text(got), text(line)), 1,
                            length(normalOf(got)), s.ulps(8));
                 sameLine(check, "made from " + text(line), line, got, s.ulps(32));
             };
             for (const auto& line : {Implicit{2, -5, 6}, {3, 0, 6}, {0, -3, 6}, {1, 0, 0}, {-0.5, 0, 4}}) ask(line);
             Random random;
             for (int i = 0; i < 50; ++i)
             {
                 const V2 n = random.point2();
                 if (length(n) > 0.1) ask({n.x, n.y, random.number()});
             }
         }});
    add({"UnitNormalForm", "HasTheDistanceAsItsC", e, Kind::knownValue, [](Check& check, const GeometrySubject& s) {
             check.near("|C| of 2x - 5y + 6 = 0 with |n| = 1", 6 / std::sqrt(29.0),
                        std::abs(s.withUnitNormal({2, -5, 6}).C), s.ulps(8));
             check.near("|C| of 3x + 4y - 10 = 0 with |n| = 1", 2, std::abs(s.withUnitNormal({3, 4, -10}).C),
                        s.ulps(8));
         }});
}

void spaceCases(std::vector<GeometryCase>& cases)
{
    constexpr auto a = "Tutorial 2 - Geometry, exercise 3a", b = "Tutorial 2 - Geometry, exercise 3b",
                   c = "Tutorial 2 - Geometry, exercise 3c", d = "Tutorial 2 - Geometry, exercise 3d";
    const auto add = [&](const GeometryCase& which) { cases.push_back(which); };
    add({"Length", "OfTheTutorialsSegmentIsTheRootOf53", a, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             check.near("length from (-4, 1, 1) to (2, 2, 5)", std::sqrt(53.0), s.segmentLength({-4, 1, 1}, {2, 2, 5}),
                        s.ulps(8));
             check.near("length from (2, 2, 5) to (-4, 1, 1)", std::sqrt(53.0), s.segmentLength({2, 2, 5}, {-4, 1, 1}),
                        s.ulps(8));
         }});
    add({"Length", "CountsAllThreeCoordinates", a, Kind::knownValue, [](Check& check, const GeometrySubject& s) {
             check.near("length along x", 5, s.segmentLength({-2, 1, 1}, {3, 1, 1}), s.ulps(8));
             check.near("length along y", 5, s.segmentLength({1, 3, 1}, {1, -2, 1}), s.ulps(8));
             check.near("length along z", 5, s.segmentLength({1, 1, -2}, {1, 1, 3}), s.ulps(8));
             check.near("length of (3, 4, 12)", 13, s.segmentLength({1, 1, 1}, {4, 5, 13}), s.ulps(8));
         }});
    add({"Length", "DoublesWhenTheSegmentIsDoubled", a, Kind::property, [](Check& check, const GeometrySubject& s) {
             forLines3([&](const V3& P, const V3& Q) {
                 const double once = s.segmentLength(P, Q), twice = s.segmentLength(P - (Q - P), Q);
                 check.near(points(P, Q) + ": twice the segment", 2 * length(Q - P), twice, s.ulps(32));
                 check.near(points(P, Q) + ": the segment", length(Q - P), once, s.ulps(32));
             });
         }});
    add({"Parametric", "FormOfTheTutorialsLineRunsAlongSixOneFour", b, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             const auto line = s.parametricForm({-4, 1, 1}, {2, 2, 5});
             const double turn = dot(line.D, V3(6, 1, 4)) < 0 ? -1 : 1;
             check.near("D, scaled to length 1, turned to (6, 1, 4)", V3(6, 1, 4) / std::sqrt(53.0),
                        turn * line.D / length(line.D), s.ulps(16));
             passes(check, "tutorial", line, {-4, 1, 1}, s.ulps(32));
             passes(check, "tutorial", line, {2, 2, 5}, s.ulps(32));
         }});
    add({"Parametric", "FormPassesThroughBothPoints", b, Kind::property, [](Check& check, const GeometrySubject& s) {
             forLines3([&](const V3& P, const V3& Q) {
                 const auto line = s.parametricForm(P, Q);
                 passes(check, points(P, Q), line, P, s.ulps(128));
                 passes(check, points(P, Q), line, Q, s.ulps(128));
             });
         }});
    add({"Normals3D", "OfTheTutorialsLineAreAtRightAnglesToSixOneFour", c, Kind::knownValue,
         [](Check& check, const GeometrySubject& s) {
             const V3 D(6, 1, 4);
             const auto [n1, n2] = s.normals3({{-4, 1, 1}, D});
             isNormal(check, "n1", n1, D, s.ulps(16));
             isNormal(check, "n2", n2, D, s.ulps(16));
             differInDirection(check, n1, n2);
         }});
    add({"Normals3D", "ExistForEveryDirection", c, Kind::property, [](Check& check, const GeometrySubject& s) {
             forLines3([&](const V3& P, const V3& Q) {
                 const auto [n1, n2] = s.normals3({P, Q - P});
                 isNormal(check, points(P, Q) + ": n1", n1, Q - P, s.ulps(64));
                 isNormal(check, points(P, Q) + ": n2", n2, Q - P, s.ulps(64));
                 differInDirection(check, n1, n2);
             });
         }});
    add({"Circle", "IsOfUnitVectorsAtRightAnglesToTheLine", d, Kind::property,
         [](Check& check, const GeometrySubject& s) {
             forLines3([&](const V3& P, const V3& Q) {
                 for (int i = 0; i < 12; ++i)
                 {
                     const double angle = i * pi / 6;
                     const V3 N = s.unitNormal({P, Q - P}, angle);
                     const auto what = fmt::format("{}: N at {} degrees", points(P, Q), 30 * i);
                     check.near("length of " + what, 1, length(N), s.ulps(32));
                     isNormal(check, what, N, Q - P, s.ulps(64));
                 }
             });
         }});
    add({"Circle", "TurnsByTheAngle", d, Kind::property, [](Check& check, const GeometrySubject& s) {
             forLines3([&](const V3& P, const V3& Q) {
                 const V3 start = s.unitNormal({P, Q - P}, 0), quarter = s.unitNormal({P, Q - P}, pi / 2);
                 for (int i = 0; i < 12; ++i)
                 {
                     const double angle = i * pi / 6;
                     const V3 N = s.unitNormal({P, Q - P}, angle);
                     const auto what = fmt::format("{}: N at {} degrees, times N at", points(P, Q), 30 * i);
                     check.near(what + " 0", std::cos(angle), dot(N, start), s.ulps(64));
                     check.near(what + " 90", std::sin(angle), dot(N, quarter), s.ulps(64));
                 }
             });
         }});
}

} // namespace

std::vector<GeometryCase> geometryCases()
{
    std::vector<GeometryCase> cases;
    slopeCases(cases);
    implicitCases(cases);
    spaceCases(cases);
    return cases;
}

Check runCase(const GeometryCase& which, const GeometrySubject& subject)
{
    Check check;
    try
    {
        which.run(check, subject);
    }
    catch (const NotAttempted&)
    {
        throw;
    }
    catch (const std::exception& error)
    {
        check.failures.push_back({"the case ran", "to its end", error.what()});
    }
    return check;
}

} // namespace rt::cases
