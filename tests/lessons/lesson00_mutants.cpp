#include "tests/lessons/lesson00_mutants.h"
#include "lessons/00_geometry/geometry.h"

namespace rt::cases
{

namespace
{

using namespace lesson00;
using G = Geometry<double>;

std::vector<GeometryMutant> planeMutants()
{
    const auto slope = [](const char* mistake, std::optional<SlopeIntercept> (*wrong)(V2, V2)) {
        return GeometryMutant{mistake, "SlopeIntercept", [wrong](Functions& f) { f.slopeIntercept = wrong; }};
    };
    const auto yAt = [](const char* mistake, double (*wrong)(SlopeIntercept, double)) {
        return GeometryMutant{mistake, "YAt", [wrong](Functions& f) { f.yAt = wrong; }};
    };
    const auto implicit = [](const char* mistake, Implicit (*wrong)(V2, V2)) {
        return GeometryMutant{mistake, "Implicit", [wrong](Functions& f) { f.implicitForm = wrong; }};
    };
    const auto normals = [](const char* mistake, std::pair<V2, V2> (*wrong)(Implicit)) {
        return GeometryMutant{mistake, "Normals2D", [wrong](Functions& f) { f.normals2 = wrong; }};
    };
    const auto distance = [](const char* mistake, double (*wrong)(Implicit)) {
        return GeometryMutant{mistake, "Distance", [wrong](Functions& f) { f.distanceToOrigin = wrong; }};
    };
    const auto unitForm = [](const char* mistake, Implicit (*wrong)(Implicit)) {
        return GeometryMutant{mistake, "UnitNormalForm", [wrong](Functions& f) { f.withUnitNormal = wrong; }};
    };
    using Slope = std::optional<SlopeIntercept>;
    return {
        slope("the slope is run over rise",
              [](V2 P, V2 Q) {
                  if (P.x == Q.x) return Slope();
                  const double a = (Q.x - P.x) / (Q.y - P.y);
                  return Slope({a, P.y - a * P.x});
              }),
        slope("b has the wrong sign in front of aP.x",
              [](V2 P, V2 Q) {
                  if (P.x == Q.x) return Slope();
                  const double a = (Q.y - P.y) / (Q.x - P.x);
                  return Slope({a, P.y + a * P.x});
              }),
        slope("the slope has the wrong sign",
              [](V2 P, V2 Q) {
                  if (P.x == Q.x) return Slope();
                  const double a = (P.y - Q.y) / (Q.x - P.x);
                  return Slope({a, P.y - a * P.x});
              }),
        slope("b is the y of the first point",
              [](V2 P, V2 Q) {
                  if (P.x == Q.x) return Slope();
                  return Slope({(Q.y - P.y) / (Q.x - P.x), P.y});
              }),
        slope("a vertical line gets an infinite slope",
              [](V2 P, V2 Q) {
                  const double a = (Q.y - P.y) / (Q.x - P.x);
                  return Slope({a, P.y - a * P.x});
              }),
        slope("a vertical line gets slope 0",
              [](V2 P, V2 Q) {
                  if (P.x == Q.x) return Slope({0, P.y});
                  return functionsOf<G>().slopeIntercept(P, Q);
              }),
        slope("a horizontal line gets none",
              [](V2 P, V2 Q) {
                  if (P.y == Q.y) return Slope();
                  return functionsOf<G>().slopeIntercept(P, Q);
              }),
        slope("there never is a slope", [](V2, V2) { return Slope(); }),
        slope("a constant",
              [](V2, V2) {
                  return Slope({0, 0});
              }),

        yAt("a and b are swapped", [](SlopeIntercept line, double x) { return line.b * x + line.a; }),
        yAt("b is subtracted", [](SlopeIntercept line, double x) { return line.a * x - line.b; }),
        yAt("b is forgotten", [](SlopeIntercept line, double x) { return line.a * x; }),
        yAt("a constant", [](SlopeIntercept, double) { return 0.0; }),

        implicit("the direction is taken for the normal",
                 [](V2 P, V2 Q) {
                     const V2 n = Q - P;
                     return Implicit{n.x, n.y, -dot(n, P)};
                 }),
        implicit("x and y are swapped, but no sign is changed",
                 [](V2 P, V2 Q) {
                     const V2 n(Q.y - P.y, Q.x - P.x);
                     return Implicit{n.x, n.y, -dot(n, P)};
                 }),
        implicit("C has the wrong sign",
                 [](V2 P, V2 Q) {
                     const auto line = G::implicitForm(P, Q);
                     return Implicit{line.A, line.B, -line.C};
                 }),
        implicit("C is forgotten",
                 [](V2 P, V2 Q) {
                     const auto line = G::implicitForm(P, Q);
                     return Implicit{line.A, line.B, 0};
                 }),
        implicit("made from the slope, so not for vertical lines",
                 [](V2 P, V2 Q) {
                     const double a = (Q.y - P.y) / (Q.x - P.x);
                     return Implicit{a, -1, P.y - a * P.x};
                 }),
        implicit("a constant",
                 [](V2, V2) {
                     return Implicit{0, 0, 0};
                 }),

        normals("the same normal twice", [](Implicit l) { return std::pair(V2(l.A, l.B), V2(l.A, l.B)); }),
        normals("the same direction twice", [](Implicit l) { return std::pair(V2(l.A, l.B), V2(2 * l.A, 2 * l.B)); }),
        normals("the line's direction", [](Implicit l) { return std::pair(V2(l.B, -l.A), V2(-l.B, l.A)); }),
        normals("swapped coordinates", [](Implicit l) { return std::pair(V2(l.B, l.A), V2(-l.B, -l.A)); }),
        normals("only one sign is changed", [](Implicit l) { return std::pair(V2(l.A, l.B), V2(l.A, -l.B)); }),
        normals("a constant", [](Implicit) { return std::pair(V2(0), V2(0)); }),

        distance("C alone", [](Implicit l) { return std::abs(l.C); }),
        distance("a negative distance", [](Implicit l) { return l.C / length(V2(l.A, l.B)); }),
        distance("divided by |n|²", [](Implicit l) { return std::abs(l.C) / (l.A * l.A + l.B * l.B); }),
        distance("multiplied by |n|", [](Implicit l) { return std::abs(l.C) * length(V2(l.A, l.B)); }),
        distance("|A| + |B| for the length",
                 [](Implicit l) { return std::abs(l.C) / (std::abs(l.A) + std::abs(l.B)); }),
        distance("the distance along y", [](Implicit l) { return std::abs(l.C / l.B); }),
        distance("a constant", [](Implicit) { return 0.0; }),

        unitForm("C is not divided",
                 [](Implicit l) {
                     const double n = length(V2(l.A, l.B));
                     return Implicit{l.A / n, l.B / n, l.C};
                 }),
        unitForm("all three numbers count as the normal",
                 [](Implicit l) {
                     const double n = length(V3(l.A, l.B, l.C));
                     return Implicit{l.A / n, l.B / n, l.C / n};
                 }),
        unitForm("divided by |n|²",
                 [](Implicit l) {
                     const double n = l.A * l.A + l.B * l.B;
                     return Implicit{l.A / n, l.B / n, l.C / n};
                 }),
        unitForm("unchanged", [](Implicit l) { return l; }),
        unitForm("C loses its sign",
                 [](Implicit l) {
                     const double n = length(V2(l.A, l.B));
                     return Implicit{l.A / n, l.B / n, std::abs(l.C) / n};
                 }),
        unitForm("a constant",
                 [](Implicit) {
                     return Implicit{1, 0, 0};
                 }),
    };
}

std::vector<GeometryMutant> spaceMutants()
{
    const auto size = [](const char* mistake, double (*wrong)(V3, V3)) {
        return GeometryMutant{mistake, "Length", [wrong](Functions& f) { f.segmentLength = wrong; }};
    };
    const auto parametric = [](const char* mistake, Parametric (*wrong)(V3, V3)) {
        return GeometryMutant{mistake, "Parametric", [wrong](Functions& f) { f.parametricForm = wrong; }};
    };
    const auto normals = [](const char* mistake, std::pair<V3, V3> (*wrong)(V3)) {
        return GeometryMutant{mistake, "Normals3D", [wrong](Functions& f) {
                                  f.normals3 = [wrong](const Parametric& l) { return wrong(l.D); };
                              }};
    };
    const auto circle = [](const char* mistake, V3 (*wrong)(V3, double)) {
        return GeometryMutant{mistake, "Circle", [wrong](Functions& f) {
                                  f.unitNormal = [wrong](const Parametric& l, double angle) {
                                      return wrong(l.D, angle);
                                  };
                              }};
    };
    return {
        size("no root", [](V3 P, V3 Q) { return dot(Q - P, Q - P); }),
        size("z is forgotten", [](V3 P, V3 Q) { return length(V2(Q - P)); }),
        size("the sides are added",
             [](V3 P, V3 Q) { return std::abs(Q.x - P.x) + std::abs(Q.y - P.y) + std::abs(Q.z - P.z); }),
        size("the distance of Q from the origin", [](V3, V3 Q) { return length(Q); }),
        size("a difference of lengths", [](V3 P, V3 Q) { return std::abs(length(Q) - length(P)); }),
        size("a sum of points", [](V3 P, V3 Q) { return length(P + Q); }),
        size("a constant", [](V3, V3) { return 1.0; }),

        parametric("the second point is taken for the direction",
                   [](V3 P, V3 Q) {
                       return Parametric{P, Q};
                   }),
        parametric("the points are added",
                   [](V3 P, V3 Q) {
                       return Parametric{P, P + Q};
                   }),
        parametric("starts at the origin",
                   [](V3 P, V3 Q) {
                       return Parametric{V3(0), Q - P};
                   }),
        parametric("the direction is zero",
                   [](V3 P, V3) {
                       return Parametric{P, V3(0)};
                   }),
        parametric("O and D are swapped",
                   [](V3 P, V3 Q) {
                       return Parametric{Q - P, P};
                   }),
        parametric("starts between the origin and P",
                   [](V3 P, V3 Q) {
                       return Parametric{0.5 * P, Q - P};
                   }),

        normals("made in the xy plane, so not along z",
                [](V3 D) { return std::pair(V3(-D.y, D.x, 0), V3(D.y, -D.x, 0)); }),
        normals("made with a fixed axis, so not along y",
                [](V3 D) { return std::pair(cross(D, V3(0, 1, 0)), -cross(D, V3(0, 1, 0))); }),
        normals("z is kept", [](V3 D) { return std::pair(V3(-D.y, D.x, D.z), V3(D.y, -D.x, D.z)); }),
        normals("the same direction twice",
                [](V3 D) {
                    return std::pair(V3(G::normals({V3(0), D}).first), 2.0 * G::normals({V3(0), D}).first);
                }),
        normals("the line's own direction", [](V3 D) { return std::pair(D, -D); }),
        normals("the second is the sum of a normal and D",
                [](V3 D) {
                    const V3 n = G::normals({V3(0), D}).first;
                    return std::pair(n, n + D);
                }),
        normals("a constant", [](V3) { return std::pair(V3(0), V3(0)); }),

        circle("the angle is in degrees",
               [](V3 D, double angle) {
                   return V3(G::unitNormal({V3(0), D}, angle * std::acos(-1.0) / 180));
               }),
        circle("only two normals, n and -n",
               [](V3 D, double angle) {
                   return (std::cos(angle) < 0 ? -1.0 : 1.0) * unit(G::normals({V3(0), D}).first);
               }),
        circle("always the same normal",
               [](V3 D, double) {
                   return V3(G::unitNormal({V3(0), D}, 0));
               }),
        circle("not of length 1",
               [](V3 D, double angle) {
                   return length(D) * G::unitNormal({V3(0), D}, angle);
               }),
        circle("V is as long as D",
               [](V3 D, double angle) {
                   const V3 U = unit(G::normals({V3(0), D}).first);
                   return std::cos(angle) * U + std::sin(angle) * cross(D, U);
               }),
        circle("U and V are not at right angles: an ellipse",
               [](V3 D, double angle) {
                   const V3 U = G::unitNormal({V3(0), D}, 0), V = G::unitNormal({V3(0), D}, 1);
                   return std::cos(angle) * U + std::sin(angle) * V;
               }),
        circle("an ellipse made a circle, but its angles are not",
               [](V3 D, double angle) {
                   const V3 U = G::unitNormal({V3(0), D}, 0), V = G::unitNormal({V3(0), D}, 1);
                   return unit(std::cos(angle) * U + std::sin(angle) * V);
               }),
        circle("a circle around y instead", [](V3, double angle) { return V3(std::cos(angle), 0, std::sin(angle)); }),
        circle("a fixed axis, so no circle around y",
               [](V3 D, double angle) {
                   const V3 U = unit(cross(D, V3(0, 1, 0)));
                   return std::cos(angle) * U + std::sin(angle) * cross(unit(D), U);
               }),
        circle("only half a turn",
               [](V3 D, double angle) {
                   return V3(G::unitNormal({V3(0), D}, angle / 2));
               }),
        circle("a constant", [](V3, double) { return V3(0); }),
    };
}

} // namespace

std::vector<GeometryMutant> geometryMutants()
{
    auto mutants = planeMutants();
    for (const auto& mutant : spaceMutants()) mutants.push_back(mutant);
    return mutants;
}

} // namespace rt::cases
