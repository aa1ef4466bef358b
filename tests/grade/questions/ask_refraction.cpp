// Lesson 05: k, the transmitted vector, glass.
#include "tests/grade/questions/media.h"
#include "tests/grade/questions/question.h"

namespace rt::grade
{

namespace
{

Question askRefract(const V& D, const V& N, double n1, double n2)
{
    const auto ask = [=](const Candidate& candidate) {
        const auto T = candidate.tracer.refract(D, N, n1, n2);
        return T ? Answer{{1, T->x, T->y, T->z}, {}} : Answer{{0}, {}};
    };
    return {fmt::format("T of D = {}, N = {}, n1 = {:.6g}, n2 = {:.6g}", text(D), text(N), n1, n2),
            Shape::transmits,
            forValues,
            ask,
            {}};
}

Question refractAt(Random& random, double cosine, double n1, double n2)
{
    const V N = random.direction();
    return askRefract(-cosine * N + std::sqrt(1 - cosine * cosine) * random.across(N), N, n1, n2);
}

Question askK(double cos1, double n1, double n2)
{
    const auto ask = [=](const Candidate& candidate) {
        return Answer{{candidate.tracer.cosSquared2(cos1, n1, n2)}, {}};
    };
    return {
        fmt::format("k for cos1 = {:.6g}, n1 = {:.6g}, n2 = {:.6g}", cos1, n1, n2), Shape::number, forValues, ask, {}};
}

/// The denser medium's index, as a multiple of the other's, at least.
constexpr double leastRatio = 1.15;

/// Beyond the critical angle, or short of it: sin2 would be 1.02 at least, or is 0.98 at most.
double sineAround(Random& random, int index, const Media& m)
{
    return index % 2 ? random.in(0.5, 0.98) : random.in(1.02, std::max(1.05, 0.99 * m.dense / m.thin));
}

Question into(Random& random, int)
{
    const auto m = media(random, leastRatio);
    return refractAt(random, random.in(0.15, 0.98), m.thin, m.dense);
}
Question outOf(Random& random, int)
{
    const auto m = media(random, leastRatio);
    return refractAt(random, cosineFor(random.in(0.1, 0.95), m.dense, m.thin), m.dense, m.thin);
}
Question aroundCritical(Random& random, int index)
{
    const auto m = media(random, leastRatio);
    return refractAt(random, cosineFor(sineAround(random, index, m), m.dense, m.thin), m.dense, m.thin);
}
Question grazing(Random& random, int)
{
    const auto m = media(random, leastRatio);
    return refractAt(random, random.in(0.01, 0.1), m.thin, m.dense);
}
Question equalMedia(Random& random, int index)
{
    const double n = random.in(1, 2);
    return refractAt(random, random.in(0.3, 0.9), n, index % 2 ? n : n * random.in(1.05, 1.15));
}

Question kInto(Random& random, int)
{
    const auto m = media(random, leastRatio);
    return askK(random.in(0.05, 0.95), m.thin, m.dense);
}
Question kOutOf(Random& random, int)
{
    const auto m = media(random, leastRatio);
    return askK(cosineFor(random.in(0.1, 0.95), m.dense, m.thin), m.dense, m.thin);
}
Question kBeyondCritical(Random& random, int index)
{
    const auto m = media(random, leastRatio);
    return askK(cosineFor(sineAround(random, index, m), m.dense, m.thin), m.dense, m.thin);
}

/// A ball of glass, or a bubble, alone under a sky; the eye outside.
struct Ball
{
    Build build;
    V eye, D;
};

Ball ball(Random& random, double inside, double outside, double aside, const V& color = V(1))
{
    Ball b;
    b.build.fresnel(FresnelModel::none).sky(random.color());
    b.build.scene.sky.zenith = random.color();
    b.build.material({.name = "glass", .color = color, .ior = inside, .iorOutside = outside});
    const V center = random.vector(-2, 2), towards = random.direction();
    const double radius = random.in(0.5, 2);
    b.build.sphere(center, radius);
    b.eye = center - random.in(2, 4) * radius * towards + aside * radius * random.across(towards);
    b.D = towards;
    return b;
}

Question through(Random& random, int)
{
    const auto m = media(random, leastRatio);
    const auto b = ball(random, m.dense, m.thin, random.in(0.15, 0.85));
    return askTree("a glass ball", b.build.scene, b.eye, b.D);
}

Question bubble(Random& random, int index)
{
    const auto m = media(random, leastRatio);
    // The sine of the angle of incidence is how far aside the ray passes.
    const double aside =
        m.thin / m.dense * (index % 2 ? random.in(0.3, 0.95) : random.in(1.05, 0.97 * m.dense / m.thin));
    const auto b = ball(random, m.thin, m.dense, aside);
    return askTree("a bubble in glass", b.build.scene, b.eye, b.D);
}

Question fromWithin(Random& random, int)
{
    const auto m = media(random, leastRatio);
    auto b = ball(random, m.dense, m.thin, 0);
    const auto& sphere = b.build.scene.spheres[0];
    const V D = random.direction();
    // Inside a ball the sine of the angle at its surface is the distance of the ray's line from the centre.
    const double aside = random.in(0.1, 0.9) * m.thin / m.dense;
    return askTree("the eye in a glass ball", b.build.scene,
                   sphere.center + sphere.radius * (random.in(-0.3, 0.3) * D + aside * random.across(D)), D);
}

Question colours(Random& random, int)
{
    const auto m = media(random, leastRatio);
    const auto b = ball(random, m.dense, m.thin, random.in(0.1, 0.85), random.color());
    return askColor("a coloured glass ball", b.build.scene, b.eye, b.D);
}

/// Panes one behind the other: how deep is the glass followed?
Question panes(Random& random, int index)
{
    auto build = Build().fresnel(FresnelModel::none).sky(random.color()).depth(index % 6);
    build.material({.name = "glass", .color = V(random.in(0.6, 1)), .ior = random.in(1.2, 1.8)});
    for (const double height : {0.0, -1.0, -2.0, -3.0})
        build.plane({0, height, 0}, {0, int(height) % 2 ? -1.0 : 1.0, 0});
    return askTree(fmt::format("two panes of glass, max_depth {}", index % 6), build.scene,
                   {random.in(-1, 1), random.in(0.5, 2), random.in(-1, 1)},
                   {random.in(-0.8, 0.8), -1, random.in(-0.8, 0.8)});
}

} // namespace

std::vector<Criterion> refractionCriteria()
{
    return {
        {"05-glass", "through a ball", through},
        {"05-glass", "at a bubble, total internal reflection and not", bubble},
        {"05-glass", "out of a ball", fromWithin},
        {"05-glass", "colours", colours},
        {"05-glass", "panes and the cap", panes},
        {"05-refract", "into the denser medium", into},
        {"05-refract", "out of the denser medium", outOf},
        {"05-refract", "around the critical angle", aroundCritical},
        {"05-refract", "grazing", grazing},
        {"05-refract", "equal and similar media", equalMedia},
        {"05-k", "into the denser medium", kInto},
        {"05-k", "out of the denser medium", kOutOf},
        {"05-k", "around the critical angle", kBeyondCritical},
    };
}

} // namespace rt::grade
