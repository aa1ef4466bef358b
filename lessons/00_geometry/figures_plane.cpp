// Exercises 1 and 2.

#include "lessons/00_geometry/figures.h"

#include <fmt/format.h>

namespace rt::lesson00
{

namespace
{

using Point = Svg::Point;

/// A square of the plane on a square of pixels.
struct View
{
    V2 center;
    double half;        ///< half the side, in the plane
    double side = 600;  ///< in pixels
    Point corner{0, 0}; ///< top left, in pixels

    explicit View(const std::vector<V2>& points)
    {
        V2 low = points[0], high = points[0];
        for (const auto& p : points) low = min(low, p), high = max(high, p);
        center = 0.5 * (low + high);
        half = 0.58 * std::max(high.x - low.x, high.y - low.y);
    }

    double scale() const { return side / (2 * half); }
    Point operator()(const V2& p) const
    {
        return corner + Point(side / 2 + (p.x - center.x) * scale(), side / 2 - (p.y - center.y) * scale());
    }
    /// A direction on the page.
    static Point turn(const V2& d) { return {d.x, -d.y}; }
};

void drawGrid(Svg& svg, const View& view)
{
    const double step = niceStep(2 * view.half), bottom = view.center.y - view.half, left = view.center.x - view.half;
    for (const int axis : {0, 1})
    {
        const double from = view.center[axis] - view.half, to = view.center[axis] + view.half;
        for (double k = std::ceil(from / step); k * step <= to; ++k)
        {
            const double at = k * step;
            const V2 a = axis == 0 ? V2(at, bottom) : V2(left, at),
                     b = a + (axis == 0 ? V2(0, 1) : V2(1, 0)) * 2.0 * view.half;
            svg.line(view(a), view(b), k == 0 ? grey : faint, k == 0 ? 1.5 : 1);
        }
    }
}

void labelGrid(Svg& svg, const View& view)
{
    const double step = niceStep(2 * view.half), margin = 0.05 * view.half;
    for (const int axis : {0, 1})
        for (double k = std::ceil((view.center[axis] - view.half + margin) / step);
             k * step <= view.center[axis] + view.half - margin; ++k)
        {
            V2 at = view.center - V2(view.half);
            at[axis] = k * step;
            svg.label(view(at) + (axis == 0 ? Point(0, -6) : Point(4, -4)), number(k * step), grey, 12,
                      axis == 0 ? "middle" : "start");
        }
}

} // namespace

Svg drawLine2(const Functions& functions, const V2& P, const V2& Q)
{
    const auto slope = functions.slopeIntercept(P, Q);
    const auto line = functions.implicitForm(P, Q);
    const auto [n1, n2] = functions.normals2(line);
    const double distance = functions.distanceToOrigin(line);

    const V2 O(0), D = Q - P, along = normalize(D);
    const V2 foot = P - dot(P, along) * along;                   // of the perpendicular from the origin
    const V2 base = length(P - foot) < length(Q - foot) ? Q : P; // the normals stand where there is room
    std::vector<V2> shown = {O, P, Q, foot, base + n1, base + n2};
    const double size = View(shown).half;
    if (slope && std::abs(slope->b) < 3 * size) shown.push_back({0, slope->b});
    const View view(shown);

    Svg svg(940, 600, "Exercise 1: a line in 2D, its intercept, two normals, its distance to the origin");
    svg.keepLabelsLeftOf(600);
    svg.clip({0, 0}, {600, 600});
    drawGrid(svg, view);
    const Point far = 5000.0 * View::turn(along);
    svg.line(view(P) - far, view(P) + far, blue, 2.5);
    svg.endClip();
    labelGrid(svg, view);
    svg.line({600, 0}, {600, 600}, faint, 1);

    if (D.x != 0 && D.y != 0)
    {
        const V2 corner(Q.x, P.y);
        svg.path({view(P), view(corner), view(Q)}, ink, 1.5, "5 4");
        svg.beside(view(0.7 * P + 0.3 * corner), {0, D.y > 0 ? 1 : -1}, "run " + number(D.x), ink);
        svg.beside(view(0.5 * (corner + Q)), {D.x > 0 ? 1 : -1, 0}, "rise " + number(D.y), ink, 8);
    }
    for (const auto& [name, n] : {std::pair("n₁", n1), {"n₂", n2}})
    {
        svg.arrow(view(base), view(base + n), red);
        svg.beside(view(base + n), View::turn({-n.y, n.x}), name, red, 14, true);
    }
    const double size1 = length(n1) * length(D);
    if (std::abs(dot(n1, D)) <= 1e-9 * size1)
        svg.rightAngle(view(base), View::turn(n1), View::turn(base == P ? D : -D));
    if (view.scale() * length(foot) > 4)
    {
        svg.line(view(O), view(foot), green, 3);
        if (view.scale() * length(foot) > 30)
            svg.rightAngle(view(foot), View::turn(-foot), View::turn(base == P ? D : -D), 10);
        svg.beside(view(0.55 * foot), View::turn(base == P ? -D : D), "d", green, 10, true);
    }
    const Point onPage = View::turn(along),
                above = onPage.x > 0 ? Point(onPage.y, -onPage.x) : Point(-onPage.y, onPage.x);
    svg.beside(view(P), 2.0 * above - onPage, "P " + vector(P), ink, 26);
    svg.beside(view(Q), onPage - 2.0 * above, "Q " + vector(Q), ink, 26);
    svg.dot(view(P), ink);
    svg.dot(view(Q), ink);
    svg.dot(view(O), ink, 3.5);
    svg.beside(view(O), foot == O ? View::turn({D.y, -D.x}) : View::turn(-foot), "O", ink, 14);
    if (slope && shown.size() > 6 && view.scale() * std::abs(slope->b) > 4)
    {
        svg.dot(view({0, slope->b}), violet, 5.5);
        svg.beside(view({0, slope->b}), {1, slope->a > 0 ? 0.8 : -0.8}, "b", violet, 12, true);
    }

    const double n = length(V2(line.A, line.B));
    svg.keepLabelsLeftOf(940);
    svg.panel(
        {622, 50},
        {{"The line through P and Q", blue},
         {slope ? fmt::format("y = {}", sum({{slope->a, "x"}, {slope->b, ""}})) : "vertical: no y = ax + b", blue},
         {equation(line), blue},
         {""},
         {slope ? fmt::format("a = rise / run = {}", number(slope->a)) : "no run, no slope"},
         {slope      ? fmt::format("b = {}: where x = 0", number(slope->b))
          : P.x == 0 ? "the line is x = 0 itself"
                     : "x = 0 is met nowhere",
          violet},
         {""},
         {"n₁ = " + vector(n1), red},
         {"n₂ = " + vector(n2), red},
         {""},
         {"the distance to the origin", green},
         {"d = |C| / |n|", green},
         {fmt::format("|C| = {}, |n| = {}", number(std::abs(line.C)), number(n)), green},
         {fmt::format("d = {}", number(distance)), green}});
    return svg;
}

Svg drawPointsOfALine()
{
    Svg svg(940, 430, "Exercise 2a: n.p = 0 for every point p of a line through the origin");
    const Point O(270, 260), along = glm::normalize(Point(5, -2)), n(along.y, -along.x);
    const Point p = O + 190.0 * along, other = O - 130.0 * along, q = O + 150.0 * along + 105.0 * n;
    const Point shadow = O + 105.0 * n, tip = O + 175.0 * n;
    svg.line(O - 285.0 * along, O + 285.0 * along, blue, 2.5);
    svg.label(O - 262.0 * along + Point(0, -14), "l", blue, 18, "middle", true);
    svg.line(q, shadow, grey, 1.5, "5 4");
    svg.rightAngle(O, along, n);
    svg.rightAngle(O, -along, n);
    svg.rightAngle(shadow, along, -n, 10);
    svg.arrow(O, q - 5.0 * glm::normalize(q - O), grey, 2);
    svg.arrow(O, tip, red, 3);
    svg.arrow(O, p - 5.0 * along, ink, 3);
    svg.arrow(O, other + 5.0 * along, ink, 3);
    svg.dot(O, ink);
    svg.dot(p, ink);
    svg.dot(other, ink);
    svg.dot(q, grey);
    svg.label(tip + Point(-10, 4), "n", red, 18, "end", true);
    svg.label(O + Point(4, 26), "O", ink, 16, "middle");
    svg.label(p + Point(4, 28), "p", ink, 18, "middle", true);
    svg.label(other + Point(4, 28), "another p", ink, 16, "middle");
    svg.label(q + Point(12, 2), "q, not on l", grey);
    svg.panel({560, 60}, {{"All points p of l have n·p = 0"},
                          {""},
                          {"O lies on l. So the arrow from O to"},
                          {"any point p of l runs along l,"},
                          {"forwards or backwards."},
                          {""},
                          {"n stands at right angles on l:", red},
                          {"the angle between n and p is 90°,", red},
                          {"whichever p it is.", red},
                          {""},
                          {"n·p = |n| |p| cos 90° = 0", blue},
                          {"(and for p = O, |p| = 0)", blue},
                          {""},
                          {"Only they: q beside l reaches some", grey},
                          {"way along n, so n·q is not 0.", grey}});
    return svg;
}

Svg drawDifferenceOfPoints()
{
    Svg svg(940, 520, "Exercise 2b: n.p - n.p' = 0 for any two points p and p' of a line");
    const Point along = glm::normalize(Point(5, -2)), n(along.y, -along.x);

    // Left: the line of the exercise, through the origin.
    {
        const Point O(230, 250), p = O + 150.0 * along, q = O - 110.0 * along, shift = 22.0 * n;
        svg.line(O - 215.0 * along, O + 215.0 * along, blue, 2.5);
        svg.label(O - 200.0 * along + Point(0, 26), "l", blue, 18, "middle", true);
        svg.line(q, q + shift, violet, 1);
        svg.line(p, p + shift, violet, 1);
        svg.arrow(q + shift, p + shift, violet, 3);
        svg.label(0.7 * (p + shift) + 0.3 * (q + shift) + Point(0, -14), "p - p′", violet, 17, "end", true);
        svg.arrow(q, q + 120.0 * n, red, 3);
        svg.rightAngle(q, -along, n);
        svg.label(q + 120.0 * n + Point(-10, 4), "n", red, 18, "end", true);
        svg.dot(O, ink);
        svg.dot(p, ink);
        svg.dot(q, ink);
        svg.arrow(O, p - 5.0 * along, ink, 2.5);
        svg.arrow(O, q + 5.0 * along, ink, 2.5);
        svg.label(O + Point(4, 26), "O", ink, 16, "middle");
        svg.label(p + Point(4, 28), "p", ink, 18, "middle", true);
        svg.label(q + Point(4, 28), "p′", ink, 18, "middle", true);
    }
    // Right: a line beside the origin.
    {
        const Point O(690, 345), foot = O + 165.0 * n, p = foot + 190.0 * along, q = foot + 75.0 * along;
        svg.line(foot - 125.0 * along, foot + 245.0 * along, blue, 2.5);
        svg.arrow(O, foot + 60.0 * n, red, 3);
        svg.rightAngle(foot, -along, n);
        svg.label(foot + 60.0 * n + Point(-10, 4), "n", red, 18, "end", true);
        svg.dot(O, ink);
        svg.dot(p, ink);
        svg.dot(q, ink);
        svg.dot(foot, red);
        svg.arrow(O, p - 5.0 * glm::normalize(p - O), ink, 2);
        svg.arrow(O, q - 5.0 * glm::normalize(q - O), ink, 2);
        svg.arrow(q + 5.0 * along, p - 5.0 * along, violet, 3);
        svg.label(0.5 * (p + q) + Point(-6, -12), "p - p′", violet, 17, "end", true);
        svg.label(O + Point(0, 26), "O", ink, 16, "middle");
        svg.label(p + Point(12, 14), "p", ink, 18, "start", true);
        svg.label(q + Point(10, 22), "p′", ink, 18, "start", true);
        // How far both reach along n.
        const Point aside = -16.0 * along, middle = 0.5 * (O + foot) + 2.0 * aside;
        svg.line(O + aside, foot + aside, red, 1);
        svg.line(O + 0.6 * aside, O + 1.4 * aside, red, 1);
        svg.line(foot + 0.6 * aside, foot + 1.4 * aside, red, 1);
        svg.label(middle + Point(0, 2), "as far as both", red, 14, "end");
        svg.label(middle + Point(0, 20), "reach along n", red, 14, "end");
    }
    svg.line({465, 20}, {465, 500}, faint, 1);
    svg.panel({30, 420}, {{"The line l through the origin"},
                          {"p′ and p lie on l: the way from p′ to p runs"},
                          {"along l, at right angles to n. So"},
                          {"n·p - n·p′ = n·(p - p′) = 0", violet}});
    svg.panel({495, 420}, {{"The same for a line beside the origin"},
                           {"p and p′ no longer have n·p = 0, but"},
                           {"p - p′ still runs along the line:"},
                           {"n·p = n·p′, one number for all points: -C", violet}});
    return svg;
}

} // namespace rt::lesson00
