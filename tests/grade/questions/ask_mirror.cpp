// Lessons 02 and 03: mirrors, whole and partial.
#include "tests/grade/questions/question.h"

namespace rt::grade
{

namespace
{

Question askReflect(const V& D, const V& N)
{
    const auto ask = [=](const Candidate& candidate) {
        const V R = candidate.tracer.reflect(D, N);
        return Answer{{R.x, R.y, R.z}, {}};
    };
    return {fmt::format("R of D = {}, N = {}", text(D), text(N)), Shape::vector, forValues, ask, {}};
}

/// Arrives on the side of N.
V arriving(Random& random, const V& N, double cosine)
{
    return -cosine * N + std::sqrt(1 - cosine * cosine) * random.across(N);
}

Question oblique(Random& random, int)
{
    const V N = random.direction();
    return askReflect(arriving(random, N, random.in(0.2, 0.9)), N);
}

Question alongTheNormal(Random& random, int index)
{
    const V N = random.direction();
    return askReflect(arriving(random, N, index % 2 ? 1 : random.in(0.9, 0.99)), N);
}

Question grazing(Random& random, int)
{
    const V N = random.direction();
    return askReflect(arriving(random, N, random.in(0.02, 0.1)), N);
}

Question atAnAxis(Random& random, int)
{
    V N(0);
    N[random.whole(0, 2)] = random.sign();
    return askReflect(arriving(random, N, random.in(0.2, 0.95)), N);
}

/// A lamp-lit diffuse floor at y = 0, and a ceiling of the given material at y = 3; the ray meets the ceiling first.
struct Room
{
    Build build;
    V eye, D;
};

Room room(Random& random, const Material<double>& ceiling)
{
    Room r;
    r.build.material({.name = "floor", .color = random.color()}).floor();
    r.build.light({random.in(-1, 1), random.in(1.5, 2.5), random.in(-1, 1)}, random.in(4, 12));
    r.build.material(ceiling).plane({0, 3, 0}, {0, -1, 0});
    r.eye = {random.in(-3, 3), random.in(0.5, 1.5), random.in(-3, 3)};
    const double turn = random.in(0, 6.28), cosine = random.in(0.4, 0.9), sine = std::sqrt(1 - cosine * cosine);
    r.D = {sine * std::cos(turn), cosine, sine * std::sin(turn)};
    return r;
}

Question oneMirror(Random& random, int)
{
    const auto r = room(random, {.name = "mirror", .color = random.color(), .mirror = 1});
    return askColor("a coloured mirror above a floor", r.build.scene, r.eye, r.D);
}

/// Between a mirror floor and a mirror ceiling the ray goes to a wall, after some bounces.
Question severalBounces(Random& random, int)
{
    auto build = Build().material({.name = "wall", .color = random.color()}).plane({12, 0, 0}, {-1, 0, 0});
    build.light({random.in(8, 10), random.in(1, 2), random.in(-1, 1)}, random.in(20, 60)).depth(12);
    build.material({.name = "below", .color = random.color(), .mirror = 1}).floor();
    build.material({.name = "above", .color = random.color(), .mirror = 1}).plane({0, 3, 0}, {0, -1, 0});
    return askColor("a wall seen in two facing mirrors", build.scene, {random.in(-3, 0), random.in(0.5, 2.5), 0},
                    {1, random.sign() * random.in(0.4, 0.9), random.in(-0.2, 0.2)});
}

Question mirrorBalls(Random& random, int)
{
    auto build =
        Build().material({.name = "floor", .color = random.color()}).floor().light({2, 5, 3}, random.in(20, 60));
    build.material({.name = "ball", .color = random.color(), .mirror = 1});
    const V center(random.in(-1, 1), random.in(1.2, 1.6), random.in(-1, 1));
    build.sphere(center, 1);
    const V eye = center + V(random.in(-2, 2), random.in(1, 3), random.in(3, 5));
    // The lower half of the ball: what it reflects is the floor.
    return askTree("a mirror ball above a floor", build.scene, eye,
                   center + V(random.in(-0.4, 0.4), random.in(-0.6, -0.2), 0) - eye);
}

Question mirrorOrNot(Random& random, int index)
{
    const auto r = room(random, {.name = "ceiling", .color = random.color(), .mirror = index % 2 ? 1.0 : 0.0});
    return askTree(index % 2 ? "a mirror above a floor" : "a diffuse ceiling above a floor", r.build.scene, r.eye, r.D);
}

/// How many rays are traced between facing mirrors, and what is left of them.
Question cap(Random& random, int index)
{
    auto build = Build().material({.name = "m", .color = random.color(), .mirror = 1}).depth(index % 7);
    build.plane({0, 0, -random.in(1, 2)}, {0, 0, 1}).plane({0, 0, random.in(1, 2)}, {0, 0, -1}).light({0, 0, 0}, 1);
    return askTree(fmt::format("facing mirrors, max_depth {}", index % 7), build.scene,
                   {random.in(-1, 1), random.in(-1, 1), 0},
                   {random.in(-0.2, 0.2), random.in(-0.2, 0.2), random.sign()});
}

Question blend(Random& random, int)
{
    const double s = random.in(0.1, 0.9);
    const auto r = room(random, {.name = "ceiling", .color = V(random.in(0.5, 1)), .mirror = s});
    return askColor(fmt::format("a ceiling that reflects {:.6g}", s), r.build.scene, r.eye, r.D);
}

Question colouredBlend(Random& random, int)
{
    const double s = random.in(0.2, 0.8);
    const auto r = room(random, {.name = "ceiling", .color = random.color(), .mirror = s});
    return askColor(fmt::format("a coloured ceiling that reflects {:.6g}", s), r.build.scene, r.eye, r.D);
}

/// A share of 0 needs no ray, a share of 1 no lamp.
Question onlyWhatCounts(Random& random, int index)
{
    const double s = index % 2 ? 1 : 0;
    const auto r = room(random, {.name = "ceiling", .color = random.color(), .mirror = s});
    return askTree(fmt::format("a ceiling that reflects {}", s), r.build.scene, r.eye, r.D);
}

Question sharesInTheTree(Random& random, int)
{
    auto r = room(random, {.name = "ceiling", .color = random.color(), .mirror = random.in(0.2, 0.8)});
    r.build.scene.materials[0].mirror = random.in(0.2, 0.8);
    r.build.depth(random.whole(1, 4));
    return askTree("floor and ceiling partial mirrors", r.build.scene, r.eye, r.D);
}

} // namespace

std::vector<Criterion> mirrorCriteria()
{
    return {
        {"02-mirror", "colour of one mirror", oneMirror},
        {"02-mirror", "several bounces", severalBounces},
        {"02-mirror", "mirror balls", mirrorBalls},
        {"02-mirror", "mirrors and diffuse surfaces", mirrorOrNot},
        {"02-mirror", "the cap", cap},
        {"02-reflect", "oblique", oblique},
        {"02-reflect", "straight on and nearly so", alongTheNormal},
        {"02-reflect", "grazing", grazing},
        {"02-reflect", "normals along the axes", atAnAxis},
    };
}

std::vector<Criterion> partialCriteria()
{
    return {
        {"03-blend", "the blend of both parts", blend},
        {"03-blend", "colours", colouredBlend},
        {"03-blend", "no ray and no lamp without a share", onlyWhatCounts},
        {"03-blend", "shares in the tree", sharesInTheTree},
    };
}

} // namespace rt::grade
