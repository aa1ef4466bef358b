// Exercise 3.

#include "lessons/00_geometry/figures/figures.h"

#include <fmt/format.h>

namespace rt::lesson00
{

namespace
{

using Point = Svg::Point;

/// Parallel projection: the eye far away, turned round the y axis and lifted. y is up.
struct Projection
{
    V3 right, up, back; ///< back points to the eye
    Point center{0, 0}, middle{0, 0};
    double scale = 1;

    Projection(double turned, double lifted)
    {
        const double radians = std::acos(-1.0) / 180, t = turned * radians, l = lifted * radians;
        back = {std::sin(t) * std::cos(l), std::sin(l), std::cos(t) * std::cos(l)};
        right = {std::cos(t), 0, -std::sin(t)};
        up = cross(back, right);
    }

    Point flat(const V3& p) const
    {
        return {dot(p, right), -dot(p, up)};
    }
    Point operator()(const V3& p) const
    {
        return middle + scale * (flat(p) - center);
    }

    /// Chooses the scale so that the points fill a rectangle of pixels.
    void fit(const std::vector<V3>& points, const Point& corner, const Point& size)
    {
        Point low = flat(points[0]), high = low;
        for (const auto& p : points) low = min(low, flat(p)), high = max(high, flat(p));
        const Point extent = max(high - low, Point(1e-9));
        scale = std::min(size.x / extent.x, size.y / extent.y);
        center = 0.5 * (low + high);
        middle = corner + 0.5 * size;
    }
};

/// The circle is seen as an ellipse when the line points neither at the eye nor across its view.
Projection viewOf(const V3& D)
{
    const auto badness = [&](const Projection& view) { return std::abs(std::abs(dot(view.back, unit(D))) - 0.55); };
    Projection best(15, 18);
    for (const double turned : {30.0, -15.0, -30.0, 45.0, -45.0, 60.0, -60.0})
        if (const Projection view(turned, 18); badness(best) > 0.25 && badness(view) < badness(best)) best = view;
    return best;
}

/// The axes, and a part of the plane y = 0 that has the points above or below it.
struct Floor
{
    V3 low{0}, high{0};
    double step;

    explicit Floor(const std::vector<V3>& points)
    {
        for (const auto& p : points) low = min(low, p), high = max(high, p);
        step = niceStep(1.6 * std::max({high.x - low.x, high.z - low.z, (high.y - low.y) / 2}));
        low = floor(low / step) * step;
        high = ceil(high / step) * step;
    }
    V3 tip(int axis) const
    {
        V3 tip(0);
        tip[axis] = high[axis] + 0.7 * step;
        return tip;
    }
};

void drawFloor(Svg& svg, const Projection& view, const Floor& ground)
{
    const auto& [low, high, step] = ground;
    for (double x = low.x; x <= high.x + step / 2; x += step)
        svg.line(view({x, 0, low.z}), view({x, 0, high.z}), faint, 1);
    for (double z = low.z; z <= high.z + step / 2; z += step)
        svg.line(view({low.x, 0, z}), view({high.x, 0, z}), faint, 1);
    for (int axis = 0; axis < 3; ++axis)
    {
        svg.arrow(view(V3(0)), view(ground.tip(axis)), grey, 1.5);
        svg.beside(view(ground.tip(axis)), view(ground.tip(axis)) - view(V3(0)), std::string(1, "xyz"[axis]), grey, 12);
        for (double k = axis == 1 ? 1 : std::round(low[axis] / step); k * step <= high[axis]; ++k)
        {
            if (k == 0) continue;
            V3 at = axis == 0 ? V3(0, 0, high.z) : axis == 1 ? V3(0) : V3(high.x, 0, 0);
            at[axis] = k * step;
            svg.label(view(at) + (axis == 0   ? Point(0, 16)
                                  : axis == 1 ? Point(-6, 4)
                                              : Point(8, 8)),
                      number(at[axis]), grey, 11,
                      axis == 0   ? "middle"
                      : axis == 1 ? "end"
                                  : "start");
        }
    }
}

} // namespace

Svg drawLine3(const Functions& functions, const V3& P, const V3& Q)
{
    const auto line = functions.parametricForm(P, Q);
    const auto [n1, n2] = functions.normals3(line);
    const double size = functions.segmentLength(P, Q);

    const V3 D = Q - P, M = 0.5 * (P + Q);
    Projection view = viewOf(D);
    // The circle has radius 1, unless that would be too small or too large to see. The line sticks out of it.
    const double seen = std::max(length(D), length(M)), radius = seen < 2.5 || seen > 15 ? 0.16 * seen : 1;
    const V3 reach = std::max(0.56 * length(D), 1.3 * radius) * unit(D);
    constexpr int corners = 96;
    std::vector<V3> circle;
    for (int i = 0; i <= corners; ++i)
        circle.push_back(M + radius * functions.unitNormal(line, 2 * std::acos(-1.0) * i / corners));

    std::vector<V3> shown = circle;
    for (const V3& p : {P, Q, V3(0), V3(P.x, 0, P.z), V3(Q.x, 0, Q.z), M - reach, M + reach}) shown.push_back(p);
    const Floor ground(shown);
    for (const double x : {ground.low.x, ground.high.x})
        for (const double z : {ground.low.z, ground.high.z}) shown.push_back({x, 0, z});
    for (int axis = 0; axis < 3; ++axis) shown.push_back(ground.tip(axis));
    view.fit(shown, {40, 40}, {530, 400});

    Svg svg(940, 490, "Exercise 3: a line in 3D and the circle of its unit normals");
    svg.keepLabelsLeftOf(610);
    drawFloor(svg, view, ground);
    // Where the points are above the floor, and the line's shadow on it.
    svg.line(view({P.x, 0, P.z}), view({Q.x, 0, Q.z}), "#9ca3af", 2, "2 4");
    for (const V3& p : {P, Q}) svg.line(view(p), view({p.x, 0, p.z}), "#9ca3af", 1.5, "4 4");

    // Back half, line, front half.
    std::vector<Point> disc;
    for (const auto& p : circle) disc.push_back(view(p));
    svg.area(disc, red, 0.1);
    const auto half = [&](bool front) {
        std::vector<Point> run;
        const auto flush = [&] {
            if (run.size() > 1) svg.path(run, red, front ? 2.5 : 2, front ? "" : "6 4");
            run.clear();
        };
        for (std::size_t i = 0; i + 1 < circle.size(); ++i)
        {
            if ((dot(0.5 * (circle[i] + circle[i + 1]) - M, view.back) > 0) != front)
            {
                flush();
                continue;
            }
            if (run.empty()) run.push_back(view(circle[i]));
            run.push_back(view(circle[i + 1]));
        }
        flush();
    };
    half(false);
    svg.line(view(M - reach), view(M + reach), blue, 2.5);
    for (int i = 0; i < corners; i += corners / 12) svg.line(view(M), view(circle[std::size_t(i)]), red, 0.8);
    half(true);

    for (const auto& [name, n] : {std::pair("n₁", n1), {"n₂", n2}})
    {
        const Point tip = view(M + radius * unit(n));
        svg.arrow(view(M), tip, red, 3);
        const Point away = glm::length(tip - view(M)) > 1 ? glm::normalize(tip - view(M)) : Point(0, -1);
        svg.label(tip + 16.0 * away + Point(0, 6), name, red, 17, "middle", true);
    }
    const double side = view(Q).x < view(P).x ? -1 : 1;
    svg.dot(view(P), ink);
    svg.dot(view(Q), ink);
    svg.beside(view(P), {-0.7 * side, -1}, "P " + vector(P), ink, 20);
    svg.beside(view(Q), {0.7 * side, -1}, "Q " + vector(Q), ink, 20);
    svg.keepLabelsLeftOf(940);

    std::vector<Svg::Line> words = {{"The line through P and Q", blue},
                                    {"P(t) = O + tD", blue},
                                    {"O = " + vector(line.O), blue},
                                    {"D = " + vector(line.D), blue},
                                    {""},
                                    {"length " + number(size)},
                                    {""},
                                    {"Two of its normals", red},
                                    {"n₁ = " + vector(n1), red},
                                    {"n₂ = " + vector(n2), red},
                                    {"(drawn with length 1)", red},
                                    {""},
                                    {"All unit normals: a circle of", red},
                                    {"radius 1, at right angles to", red},
                                    {"the line (dashed: behind it)", red}};
    if (radius != 1) words[10].words = fmt::format("(drawn with length {})", number(radius));
    if (radius != 1) words.push_back({fmt::format("(drawn with radius {})", number(radius)), red});
    svg.panel({622, 60}, words);
    return svg;
}

} // namespace rt::lesson00
