// Lesson 08: Phong.
#include "tests/grade/questions/question.h"

namespace rt::grade
{

namespace
{

Question askPhong(const V& L, const V& N, const V& view, double glossy, double exponent)
{
    const auto ask = [=](const Candidate& candidate) {
        return Answer{{candidate.tracer.phong(L, N, view, glossy, exponent)}, {}};
    };
    // A power of 200 makes 200 times the relative error of a cosine in float.
    return {fmt::format("phong(L = {}, N = {}, V = {}, f = {:.6g}, alpha = {:.6g})", text(L), text(N), text(view),
                        glossy, exponent),
            Shape::number,
            forTraces,
            ask,
            {}};
}

/// Light and eye above a surface, the eye at `angle` (radians) from the middle of the highlight.
struct Setup
{
    V L, N, view;
};

Setup setup(Random& random, double angle)
{
    while (true)
    {
        Setup s;
        s.N = random.direction();
        const double cosine = random.in(0.3, 0.95);
        s.L = cosine * s.N + std::sqrt(1 - cosine * cosine) * random.across(s.N);
        const V R = 2 * cosine * s.N - s.L;
        s.view = std::cos(angle) * R + std::sin(angle) * random.across(R);
        if (dot(s.view, s.N) > 0.05) return s;
    }
}

Question highlight(Random& random, int)
{
    const double exponent = random.in(1, 200);
    const auto s = setup(random, random.in(0, 1.2) / std::sqrt(exponent));
    return askPhong(s.L, s.N, s.view, 1, exponent);
}

Question blend(Random& random, int)
{
    const double exponent = random.in(1, 60);
    const auto s = setup(random, random.in(0, 1) / std::sqrt(exponent));
    return askPhong(s.L, s.N, s.view, random.in(0.2, 0.8), exponent);
}

Question withoutGloss(Random& random, int index)
{
    const auto s = setup(random, random.in(0, 0.5));
    return askPhong(s.L, s.N, s.view, index % 2 ? 0 : random.in(0.3, 0.6), random.in(1, 20));
}

/// V.R is negative, and an odd power of it would be: only the diffuse part is left. Every other is in the highlight.
Question awayFromTheHighlight(Random& random, int index)
{
    const auto s = setup(random, index % 2 ? random.in(1.65, 2) : random.in(0, 0.5));
    return askPhong(s.L, s.N, s.view, random.in(0.3, 0.7), random.whole(1, 6));
}

/// The lamp is behind the surface, and the eye where the formula would still see a highlight.
Question behindTheSurface(Random& random, int index)
{
    const V N = random.direction(), u = random.across(N);
    const double cosine = random.in(0.1, 0.5), sine = std::sqrt(1 - cosine * cosine);
    const double side = index % 2 ? 1 : -1;
    const V L = side * cosine * N + sine * u, view = glm::normalize(random.in(0.1, 0.5) * N - sine * u);
    return askPhong(L, N, view, random.in(0.4, 1), random.in(1, 10));
}

Question inAScene(Random& random, int)
{
    auto build = Build().material(
        {.name = "glossy", .color = random.color(), .glossy = random.in(0.3, 0.9), .exponent = random.in(2, 40)});
    build.floor();
    const V eye(random.in(-3, -1), random.in(1, 3), random.in(-0.5, 0.5));
    for (int i = random.whole(1, 3); i > 0; --i) // near where the highlight is seen
        build.light({random.in(1, 3), random.in(1, 3), random.in(-0.5, 0.5)}, random.in(5, 20) * random.color());
    if (random.coin())
        build.material({.name = "ball"}).sphere({random.in(-3, 3), random.in(0.5, 2), random.in(1.5, 3)}, 0.7);
    return askColor("a glossy floor", build.scene, eye, V(random.in(-0.3, 0.3), 0, 0) - eye);
}

/// V is the way back to the mirror, not to the eye.
Question inAMirror(Random& random, int)
{
    auto build = Build().material(
        {.name = "glossy", .color = random.color(), .glossy = random.in(0.6, 1), .exponent = random.in(4, 30)});
    build.floor().light({random.in(2.5, 3.5), random.in(2.5, 3.5), random.in(-0.3, 0.3)}, random.in(10, 30));
    build.material({.name = "mirror", .color = random.color(), .mirror = random.coin() ? 1 : random.in(0.5, 0.9)})
        .plane({0, 5, 0}, {0, -1, 0});
    const double slope = random.in(0.85, 1.15);
    return askColor("a highlight seen in a mirror", build.scene, {-8 + random.in(-0.3, 0.3), 3, random.in(-0.2, 0.2)},
                    {slope, 1, 0});
}

} // namespace

std::vector<Criterion> phongCriteria()
{
    return {
        {"08-phong", "around the highlight", highlight},
        {"08-phong", "part diffuse, part glossy", blend},
        {"08-phong", "with and without gloss", withoutGloss},
        {"08-phong", "away from the highlight", awayFromTheHighlight},
        {"08-phong", "a lamp behind the surface", behindTheSurface},
        {"08-phong", "lamps on a glossy floor", inAScene},
        {"08-phong", "seen in a mirror", inAMirror},
    };
}

} // namespace rt::grade
