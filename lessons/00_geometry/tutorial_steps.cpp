// The way to the tutorial's answers: solutions in words, so exercises and hand-outs do without.
#include <fmt/format.h>

#include "lessons/00_geometry/tutorial.h"

namespace rt::lesson00
{

namespace
{

template <class... Arguments>
std::string step(fmt::format_string<Arguments...> format, Arguments&&... arguments)
{
    return "     " + fmt::format(format, std::forward<Arguments>(arguments)...) + "\n";
}

std::string slope(const Lines& lines)
{
    const V2 P = lines.P2, Q = lines.Q2, D = Q - P;
    const double a = D.y / D.x;
    return step("a = rise / run = ({} - {}) / ({} - {}) = {} / {} = {}", number(Q.y), operand(P.y), number(Q.x),
                operand(P.x), number(D.y), operand(D.x), number(a)) +
           step("b = P.y - a P.x = {} - {} * {} = {}", number(P.y), operand(a), operand(P.x), number(P.y - a * P.x));
}

std::string verify(const SlopeIntercept& line, double x, const std::string& y)
{
    return step("{} * {} + {} = {}", number(line.a), operand(x), operand(line.b), y);
}

std::string implicitForm(const Lines& lines)
{
    const V2 P = lines.P2, D = lines.Q2 - P;
    return step("D = Q - P = {}, so n = (D.y, -D.x) = {} is at right angles to it", vector(D), vector(V2(D.y, -D.x))) +
           step("C = -n.P = {}", number(-(D.y * P.x - D.x * P.y)));
}

std::string distance(const Implicit& line)
{
    return step("the point of the line nearest to the origin is s n with n.(s n) + C = 0, so s = -C / |n|²") +
           step("its distance is |s n| = |C| / |n|, with |n| = sqrt({}² + {}²) = sqrt({})", operand(line.A),
                operand(line.B), number(line.A * line.A + line.B * line.B));
}

std::string onPaper(const Lines& lines)
{
    const V2 D = lines.Q2 - lines.P2, n(D.y, -D.x), p = D, q = -0.5 * D;
    return fmt::format("a) n.p = 0: p runs along the line, n stands at right angles on it, and cos 90° = 0\n"
                       "     p = {}, n = {}: n.p = {} * {} + {} * {} = 0\n"
                       "b) n.p - n.p' = n.(p - p') = 0: the way from p' to p runs along the line too\n"
                       "     p = {}, p' = {}: p - p' = {}, n.(p - p') = {} * {} + {} * {} = 0\n",
                       vector(p), vector(n), number(n.x), operand(p.x), operand(n.y), operand(p.y), vector(p),
                       vector(q), vector(p - q), number(n.x), operand((p - q).x), operand(n.y), operand((p - q).y));
}

std::string segmentLength(const Lines& lines)
{
    const V3 D = lines.Q3 - lines.P3;
    return step("D = Q - P = {}", vector(D)) +
           step("|D| = sqrt({}² + {}² + {}²) = sqrt({})", operand(D.x), operand(D.y), operand(D.z), number(dot(D, D)));
}

std::string normals3(const Lines&)
{
    return step("cross(D, v) is at right angles to D for every v; so are all sums of such vectors");
}

} // namespace

const Steps& tutorialSteps()
{
    static constexpr Steps steps{slope, verify, implicitForm, distance, onPaper, segmentLength, normals3};
    return steps;
}

} // namespace rt::lesson00
