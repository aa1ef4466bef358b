#include "lessons/00_geometry/tutorial.h"

#include <fmt/format.h>

#include "common/base/todo.h"

namespace rt::lesson00
{

namespace
{

/// What is left of a sum that should be zero; rounding errors of numbers of that size count as zero.
std::string rest(double x, double size)
{
    return number(std::abs(x) <= 1e-12 * size ? 0 : x);
}

V3 rest(const V3& v, double size)
{
    const auto tiny = lessThanEqual(abs(v), V3(1e-12 * size));
    return {tiny.x ? 0 : v.x, tiny.y ? 0 : v.y, tiny.z ? 0 : v.z};
}

double sizeOf(const Implicit& line, const V2& point)
{
    return std::abs(line.A * point.x) + std::abs(line.B * point.y) + std::abs(line.C);
}

template <class Vector>
std::string normalText(const char* name, const Vector& n, const Vector& D)
{
    return fmt::format("     {0} = {1}, {0}.D = {2}{3}\n", name, vector(n), rest(dot(n, D), length(n) * length(D)),
                       n == Vector(0) ? ", but it has no direction" : "");
}

/// The lines of one answer; what has not been written yet is said in their place.
std::string attempt(const std::function<std::string()>& write)
{
    try
    {
        return write();
    }
    catch (const NotAttempted& missing)
    {
        return fmt::format("     not attempted: {}\n", missing.id);
    }
}

struct Writer
{
    const Functions& f;
    const Lines& lines;
    const Steps* steps;

    std::string slope() const
    {
        const V2 P = lines.P2, Q = lines.Q2, D = Q - P;
        const auto line = f.slopeIntercept(P, Q);
        if (!line && D.x == 0) return fmt::format("     none: the line is vertical, x = {}\n", number(P.x));
        if (!line) return "     none, but the line is not vertical\n";
        return (steps ? steps->slope(lines) : "") + fmt::format("     y = {}\n", sum({{line->a, "x"}, {line->b, ""}}));
    }

    std::string verify() const
    {
        const auto line = f.slopeIntercept(lines.P2, lines.Q2);
        if (!line) return "     there is nothing to verify\n";
        std::string text;
        for (const auto& [name, point] : {std::pair("P", lines.P2), {"Q", lines.Q2}})
        {
            const double y = f.yAt(*line, point.x);
            const double size = std::abs(line->a * point.x) + std::abs(line->b);
            const bool same = std::abs(y - point.y) <= 1e-9 * std::max(size, std::abs(point.y));
            text += (steps ? steps->verify(*line, point.x, rest(y, size)) : "") +
                    fmt::format("     at x = {} the line has y = {}, {}\n", number(point.x), rest(y, size),
                                same ? fmt::format("as {} has", name)
                                     : fmt::format("but {} has y = {}", name, number(point.y)));
        }
        return text;
    }

    std::string implicitForm() const
    {
        const V2 P = lines.P2, Q = lines.Q2;
        const auto line = f.implicitForm(P, Q);
        std::string text = (steps ? steps->implicitForm(lines) : "") + fmt::format("     {}\n", equation(line));
        for (const auto& [name, point] : {std::pair("P", P), {"Q", Q}})
            text += fmt::format("     at {}: {} * {} + {} * {} + {} = {}\n", name, number(line.A), operand(point.x),
                                operand(line.B), operand(point.y), operand(line.C),
                                rest(line.A * point.x + line.B * point.y + line.C, sizeOf(line, point)));
        return text;
    }

    std::string normals2() const
    {
        const V2 D = lines.Q2 - lines.P2;
        const auto [n1, n2] = f.normals2(f.implicitForm(lines.P2, lines.Q2));
        return normalText("n1", n1, D) + normalText("n2", n2, D);
    }

    std::string distance() const
    {
        const auto line = f.implicitForm(lines.P2, lines.Q2);
        const double n = length(V2(line.A, line.B)), d = f.distanceToOrigin(line);
        return (steps ? steps->distance(line) : "") +
               fmt::format("     distance = {}\n     distance * |n| = {} * {} = {}, and |C| = {}\n", number(d),
                           number(d), number(n), number(d * n), number(std::abs(line.C)));
    }

    std::string unitForm() const
    {
        const auto line = f.withUnitNormal(f.implicitForm(lines.P2, lines.Q2));
        return fmt::format("     with a normal of length {}: {}, |C| = {}\n", number(length(V2(line.A, line.B))),
                           equation(line), number(std::abs(line.C)));
    }

    std::string onPaper() const
    {
        return steps ? steps->onPaper(lines) : "To be shown by drawing; slides-notes/00-geometry.md does.\n";
    }

    std::string segmentLength() const
    {
        const double l = f.segmentLength(lines.P3, lines.Q3);
        return (steps ? steps->segmentLength(lines) : "") + fmt::format("     length = {}\n", number(l));
    }

    std::string parametricForm() const
    {
        const auto line = f.parametricForm(lines.P3, lines.Q3);
        std::string text = fmt::format("     P(t) = {} + t {}\n", vector(line.O), vector(line.D));
        for (const auto& [name, point] : {std::pair("P", lines.P3), {"Q", lines.Q3}})
        {
            const double t = dot(point - line.O, line.D) / dot(line.D, line.D);
            text +=
                fmt::format("     P({}) = {}, {} = {}\n", rest(t, 1),
                            vector(rest(line.O + t * line.D, length(line.O) + length(line.D))), name, vector(point));
        }
        return text;
    }

    std::string normals3() const
    {
        const V3 D = lines.Q3 - lines.P3;
        const auto [n1, n2] = f.normals3({lines.P3, D});
        return (steps ? steps->normals3(lines) : "") + normalText("n1", n1, D) + normalText("n2", n2, D);
    }

    std::string circle() const
    {
        const V3 D = lines.Q3 - lines.P3;
        std::string text = "     one for each angle: a circle of radius 1 around the line, at right angles to it\n";
        for (int degrees = 0; degrees < 360; degrees += 45)
        {
            const V3 N = f.unitNormal({lines.P3, D}, degrees * std::acos(-1.0) / 180);
            text += fmt::format("     {:3}°: N = {}, |N| = {}, N.D = {}\n", degrees, vector(rest(N, 1)),
                                number(length(N)), rest(dot(N, D), length(D)));
        }
        return text;
    }
};

} // namespace

std::string operand(double x)
{
    return x < 0 ? "(" + number(x) + ")" : number(x);
}

std::string number(double x)
{
    return fmt::format("{:.6g}", x + 0.0); // -0 + 0 = 0
}

std::string vector(const V2& v)
{
    return fmt::format("({}, {})", number(v.x), number(v.y));
}

std::string vector(const V3& v)
{
    return fmt::format("({}, {}, {})", number(v.x), number(v.y), number(v.z));
}

std::string sum(const std::vector<std::pair<double, std::string>>& terms)
{
    std::string text;
    for (const auto& [factor, name] : terms)
    {
        if (factor == 0) continue;
        const bool negative = std::signbit(factor);
        text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        if (std::abs(factor) != 1 || name.empty()) text += number(std::abs(factor));
        text += name;
    }
    return text.empty() ? "0" : text;
}

std::string equation(const Implicit& line)
{
    return sum({{line.A, "x"}, {line.B, "y"}, {line.C, ""}}) + " = 0";
}

std::string tutorialText(const Functions& functions, const Lines& lines, const Steps* steps)
{
    const Writer w{functions, lines, steps};
    const auto answer = [&](const char* question, std::string (Writer::*write)() const) {
        return fmt::format("{}\n{}", question, attempt([&] { return (w.*write)(); }));
    };
    return fmt::format("Tutorial 2 - Geometry\n\nExercise 1. The line in 2D through P = {} and Q = {}\n",
                       vector(lines.P2), vector(lines.Q2)) +
           answer("a) slope-intercept form, y = ax + b", &Writer::slope) +
           answer("b) does it hold for the two points?", &Writer::verify) +
           answer("c) implicit form, Ax + By + C = 0", &Writer::implicitForm) +
           answer("d) two normals", &Writer::normals2) +
           answer("e) distance to the origin, C and the length of n = (A, B)", &Writer::distance) +
           attempt([&] { return w.unitForm(); }) + "\nExercise 2. A line in 2D through the origin, with a normal n\n" +
           w.onPaper() +
           fmt::format("\nExercise 3. The line in 3D through P = {} and Q = {}\n", vector(lines.P3), vector(lines.Q3)) +
           answer("a) length of the segment", &Writer::segmentLength) +
           answer("b) parametric form, P(t) = O + tD", &Writer::parametricForm) +
           answer("c) two normals", &Writer::normals3) + answer("d) all normals of length 1", &Writer::circle);
}

} // namespace rt::lesson00
