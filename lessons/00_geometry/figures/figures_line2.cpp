// Exercise 1.

#include "lessons/00_geometry/figures/figures.h"

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

    double scale() const
    {
        return side / (2 * half);
    }
    Point operator()(const V2& p) const
    {
        return corner + Point(side / 2 + (p.x - center.x) * scale(), side / 2 - (p.y - center.y) * scale());
    }
    /// A direction on the page.
    static Point turn(const V2& d)
    {
        return {d.x, -d.y};
    }
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

} // namespace rt::lesson00
