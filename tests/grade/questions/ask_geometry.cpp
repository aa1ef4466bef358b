// Lesson 00. Any correct answer is right: what is compared are facts about it that all of them share.
#include "tests/grade/questions/question.h"

namespace rt::grade
{

namespace
{

using lesson00::Implicit;
using lesson00::V2;
using lesson00::V3;

std::string text(const V2& v)
{
    return fmt::format("({:.6g}, {:.6g})", v.x, v.y);
}

std::string text(const Implicit& line)
{
    return fmt::format("{:.6g}x + {:.6g}y + {:.6g} = 0", line.A, line.B, line.C);
}

template <class Ask>
Question facts(const std::string& what, const Ask& ask)
{
    return {what, Shape::numbers, forValues, [ask](const Candidate& candidate) { return ask(candidate.geometry); }, {}};
}

V2 point2(Random& random)
{
    const double x = random.in(-8, 8);
    return {x, random.in(-8, 8)};
}

/// Two points, neither above each other nor at the same height.
std::pair<V2, V2> points2(Random& random)
{
    const V2 P = point2(random), D(random.sign() * random.in(1, 5), random.sign() * random.in(1, 5));
    return {P, P + D};
}

std::pair<V2, V2> alongAnAxis2(Random& random, int index)
{
    const V2 P = point2(random);
    const double step = random.sign() * random.in(1, 5);
    return {P, index % 2 ? V2(P.x, P.y + step) : V2(P.x + step, P.y)};
}

Implicit form(Random& random)
{
    return {random.sign() * random.in(0.5, 5), random.sign() * random.in(0.5, 5), random.sign() * random.in(0.5, 8)};
}

Question askSlope(const std::pair<V2, V2>& through)
{
    const auto [P, Q] = through;
    return facts(
        fmt::format("slopeIntercept of the line through {} and {}", text(P), text(Q)), [P = P, Q = Q](const auto& g) {
            const auto line = g.slopeIntercept(P, Q);
            return line ? Answer{{1, line->a, line->b}, {"has a slope", "a", "b"}} : Answer{{0}, {"has a slope"}};
        });
}

Question askYAt(Random& random, int)
{
    const lesson00::SlopeIntercept line{random.in(-4, 4), random.in(-8, 8)};
    const double x = random.sign() * random.in(0.5, 8);
    return facts(fmt::format("y at x = {:.6g} of y = {:.6g}x + {:.6g}", x, line.a, line.b), [=](const auto& g) {
        return Answer{{g.yAt(line, x)}, {"y"}};
    });
}

/// The signed distances of three points from the line of a form, up to its sign: the last one's is positive.
Answer distances(const Implicit& line, const V2& P, const V2& Q)
{
    const V2 n(line.A, line.B), D = Q - P, aside = V2(-D.y, D.x) / length(D);
    const auto distance = [&](const V2& p) { return (dot(n, p) + line.C) / length(n); };
    const double side = distance(P + 3.0 * aside) < 0 ? -1 : 1;
    return {{side * distance(P), side * distance(Q), side * distance(P + 3.0 * aside)},
            {"distance of P from the line of your form", "distance of Q", "distance of a point 3 beside"}};
}

Question askImplicit(const std::pair<V2, V2>& through)
{
    const auto [P, Q] = through;
    return facts(fmt::format("implicitForm of the line through {} and {}", text(P), text(Q)),
                 [P = P, Q = Q](const auto& g) { return distances(g.implicitForm(P, Q), P, Q); });
}

/// Of two vectors: are they at right angles to the line, not zero, and not the same direction?
template <class Vector>
Answer areNormals(const std::pair<Vector, Vector>& normals, const Vector& D)
{
    const auto n1 = normals.first / length(normals.first), n2 = normals.second / length(normals.second);
    return {
        {dot(n1, D) / length(D), dot(n2, D) / length(D), double(length(n1 - n2) > 1e-3)},
        {"cosine of the angle of n1 to the line", "cosine of the angle of n2 to the line", "they differ in direction"}};
}

Question askNormals2(const Implicit& line)
{
    return facts("normals of " + text(line),
                 [=](const auto& g) { return areNormals(g.normals2(line), V2(line.B, -line.A)); });
}

Question askDistance(Random& random, int index)
{
    auto line = form(random);
    if (index % 5 == 0) line.A = 0;
    if (index % 5 == 1) line.B = 0;
    return facts("distanceToOrigin of " + text(line), [=](const auto& g) {
        return Answer{{g.distanceToOrigin(line)}, {"distance"}};
    });
}

Question askUnitForm(Random& random, int index)
{
    auto line = form(random);
    if (index % 5 == 0) line.A = 0;
    if (index % 5 == 1) line.B = 0;
    return facts("withUnitNormal of " + text(line), [=](const auto& g) {
        const auto got = g.withUnitNormal(line);
        const double sign = dot(V2(got.A, got.B), V2(line.A, line.B)) < 0 ? -1 : 1;
        return Answer{{sign * got.A, sign * got.B, sign * got.C}, {"A", "B", "C"}};
    });
}

std::pair<V3, V3> points3(Random& random)
{
    const V3 P = random.vector(-8, 8);
    return {P, P + random.in(1, 8) * random.direction()};
}

V3 alongAnAxis3(Random& random, int index)
{
    V3 D(0);
    D[index % 3] = random.sign() * random.in(0.5, 5);
    return D;
}

Question askLength(Random& random, int)
{
    const auto [P, Q] = points3(random);
    return facts(fmt::format("segmentLength from {} to {}", text(P), text(Q)), [P = P, Q = Q](const auto& g) {
        return Answer{{g.segmentLength(P, Q)}, {"length"}};
    });
}

Question askParametric(Random& random, int)
{
    const auto [P, Q] = points3(random);
    return facts(fmt::format("parametricForm of the line through {} and {}", text(P), text(Q)),
                 [P = P, Q = Q](const auto& g) {
                     const auto line = g.parametricForm(P, Q);
                     const V3 D = line.D / length(line.D);
                     const auto distance = [&](const V3& p) { return length(cross(p - line.O, D)); };
                     return Answer{{distance(P), distance(Q)}, {"distance of P from the line O + tD", "distance of Q"}};
                 });
}

Question askNormals3(const V3& P, const V3& D)
{
    return facts(fmt::format("normals of the line ({}) + t ({})", text(P), text(D)), [=](const auto& g) {
        return areNormals(g.normals3({P, D}), D);
    });
}

/// The unit normals at four angles: of length 1, at right angles to the line, and as far apart as the angles are.
Question askCircle(Random& random, const V3& D)
{
    const double angle = random.in(0, 6), step = random.in(0.3, 1.3);
    return facts(fmt::format("unitNormal of the line along {} at {:.6g}, {:.6g} and {:.6g}", text(D), angle,
                             angle + step, angle + 2 * step),
                 [=](const auto& g) {
                     const lesson00::Parametric line{V3(1, -2, 3), D};
                     const V3 a = g.unitNormal(line, angle), b = g.unitNormal(line, angle + step),
                              c = g.unitNormal(line, angle + 2 * step);
                     const V3 d = D / length(D);
                     return Answer{{length(a), length(b), dot(a, d), dot(b, d), dot(a, b), dot(b, c), dot(a, c)},
                                   {"length of the first", "length of the second", "cosine of the first to the line",
                                    "cosine of the second to the line", "cosine between the first two",
                                    "cosine between the second and the third",
                                    "cosine between the first and the third"}};
                 });
}

} // namespace

std::vector<Criterion> geometryCriteria()
{
    return {
        {"00-slope", "slanting lines", [](Random& r, int) { return askSlope(points2(r)); }},
        {"00-slope", "vertical and horizontal lines", [](Random& r, int i) { return askSlope(alongAnAxis2(r, i)); }},
        {"00-verify", "any line", askYAt},
        {"00-implicit", "slanting lines", [](Random& r, int) { return askImplicit(points2(r)); }},
        {"00-implicit", "vertical and horizontal lines",
         [](Random& r, int i) { return askImplicit(alongAnAxis2(r, i)); }},
        {"00-normals-2d", "any line", [](Random& r, int) { return askNormals2(form(r)); }},
        {"00-normals-2d", "vertical and horizontal lines",
         [](Random& r, int i) {
             auto line = form(r);
             (i % 2 ? line.A : line.B) = 0;
             return askNormals2(line);
         }},
        {"00-distance", "any line", askDistance},
        {"00-unit-normal", "any line", askUnitForm},
        {"00-length", "any segment", askLength},
        {"00-parametric", "any line", askParametric},
        {"00-normals-3d", "any line",
         [](Random& r, int) { return askNormals3(r.vector(-5, 5), r.in(0.5, 5) * r.direction()); }},
        {"00-normals-3d", "along the axes",
         [](Random& r, int i) { return askNormals3(r.vector(-5, 5), alongAnAxis3(r, i)); }},
        {"00-circle", "any line", [](Random& r, int) { return askCircle(r, r.in(0.5, 5) * r.direction()); }},
        {"00-circle", "along the axes", [](Random& r, int i) { return askCircle(r, alongAnAxis3(r, i)); }},
    };
}

} // namespace rt::grade
