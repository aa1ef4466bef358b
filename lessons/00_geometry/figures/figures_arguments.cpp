// Exercise 2: the figures that carry the argument.

#include "lessons/00_geometry/figures/figures.h"

namespace rt::lesson00
{

Svg drawPointsOfALine()
{
    Svg svg(940, 430, "Exercise 2a: n.p = 0 for every point p of a line through the origin");
    const Svg::Point O(270, 260), along = glm::normalize(Svg::Point(5, -2)), n(along.y, -along.x);
    const Svg::Point p = O + 190.0 * along, other = O - 130.0 * along, q = O + 150.0 * along + 105.0 * n;
    const Svg::Point shadow = O + 105.0 * n, tip = O + 175.0 * n;
    svg.line(O - 285.0 * along, O + 285.0 * along, blue, 2.5);
    svg.label(O - 262.0 * along + Svg::Point(0, -14), "l", blue, 18, "middle", true);
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
    svg.label(tip + Svg::Point(-10, 4), "n", red, 18, "end", true);
    svg.label(O + Svg::Point(4, 26), "O", ink, 16, "middle");
    svg.label(p + Svg::Point(4, 28), "p", ink, 18, "middle", true);
    svg.label(other + Svg::Point(4, 28), "another p", ink, 16, "middle");
    svg.label(q + Svg::Point(12, 2), "q, not on l", grey);
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
    const Svg::Point along = glm::normalize(Svg::Point(5, -2)), n(along.y, -along.x);

    // Left: the line of the exercise, through the origin.
    {
        const Svg::Point O(230, 250), p = O + 150.0 * along, q = O - 110.0 * along, shift = 22.0 * n;
        svg.line(O - 215.0 * along, O + 215.0 * along, blue, 2.5);
        svg.label(O - 200.0 * along + Svg::Point(0, 26), "l", blue, 18, "middle", true);
        svg.line(q, q + shift, violet, 1);
        svg.line(p, p + shift, violet, 1);
        svg.arrow(q + shift, p + shift, violet, 3);
        svg.label(0.7 * (p + shift) + 0.3 * (q + shift) + Svg::Point(0, -14), "p - p′", violet, 17, "end", true);
        svg.arrow(q, q + 120.0 * n, red, 3);
        svg.rightAngle(q, -along, n);
        svg.label(q + 120.0 * n + Svg::Point(-10, 4), "n", red, 18, "end", true);
        svg.dot(O, ink);
        svg.dot(p, ink);
        svg.dot(q, ink);
        svg.arrow(O, p - 5.0 * along, ink, 2.5);
        svg.arrow(O, q + 5.0 * along, ink, 2.5);
        svg.label(O + Svg::Point(4, 26), "O", ink, 16, "middle");
        svg.label(p + Svg::Point(4, 28), "p", ink, 18, "middle", true);
        svg.label(q + Svg::Point(4, 28), "p′", ink, 18, "middle", true);
    }
    // Right: a line beside the origin.
    {
        const Svg::Point O(690, 345), foot = O + 165.0 * n, p = foot + 190.0 * along, q = foot + 75.0 * along;
        svg.line(foot - 125.0 * along, foot + 245.0 * along, blue, 2.5);
        svg.arrow(O, foot + 60.0 * n, red, 3);
        svg.rightAngle(foot, -along, n);
        svg.label(foot + 60.0 * n + Svg::Point(-10, 4), "n", red, 18, "end", true);
        svg.dot(O, ink);
        svg.dot(p, ink);
        svg.dot(q, ink);
        svg.dot(foot, red);
        svg.arrow(O, p - 5.0 * glm::normalize(p - O), ink, 2);
        svg.arrow(O, q - 5.0 * glm::normalize(q - O), ink, 2);
        svg.arrow(q + 5.0 * along, p - 5.0 * along, violet, 3);
        svg.label(0.5 * (p + q) + Svg::Point(-6, -12), "p - p′", violet, 17, "end", true);
        svg.label(O + Svg::Point(0, 26), "O", ink, 16, "middle");
        svg.label(p + Svg::Point(12, 14), "p", ink, 18, "start", true);
        svg.label(q + Svg::Point(10, 22), "p′", ink, 18, "start", true);
        // How far both reach along n.
        const Svg::Point aside = -16.0 * along, middle = 0.5 * (O + foot) + 2.0 * aside;
        svg.line(O + aside, foot + aside, red, 1);
        svg.line(O + 0.6 * aside, O + 1.4 * aside, red, 1);
        svg.line(foot + 0.6 * aside, foot + 1.4 * aside, red, 1);
        svg.label(middle + Svg::Point(0, 2), "as far as both", red, 14, "end");
        svg.label(middle + Svg::Point(0, 20), "reach along n", red, 14, "end");
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
