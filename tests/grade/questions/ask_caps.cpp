// Lesson 07: the cap, its policy, the cutoff, and light through glass.
#include "tests/grade/questions/question.h"

namespace rt::grade
{

namespace
{

/// Facing mirrors of one colour, which hide the sky.
Build corridor(Random& random, int depth, double grey)
{
    auto build = Build().depth(depth).material({.name = "m", .color = V(grey), .mirror = 1});
    build.plane({0, 0, -random.in(1, 2)}, {0, 0, 1}).plane({0, 0, random.in(1, 2)}, {0, 0, -1});
    return build.light({0, 0, 0}, random.in(0.5, 2));
}

Question along(Random& random, const std::string& what, const Build& build)
{
    return askTree(what, build.scene, {random.in(-1, 1), random.in(-1, 1), 0},
                   {random.in(-0.2, 0.2), random.in(-0.2, 0.2), random.sign()});
}

Question depth(Random& random, int index)
{
    const auto build = corridor(random, index % 7, random.in(0.5, 1));
    return along(random, fmt::format("facing mirrors, max_depth {}", index % 7), build);
}

Build glassBall(Random& random, int depth, AtCap policy)
{
    auto build = Build().sky(random.in(0.5, 2) * random.color()).depth(depth);
    build.scene.trace.atCap = policy;
    build.material({.name = "glass", .color = V(random.in(0.7, 1)), .ior = random.in(1.3, 1.8)});
    return build.sphere(V(0), 1);
}

const char* word(AtCap policy)
{
    return atCapWords[std::size_t(policy)].data();
}

Question glassTree(Random& random, int index)
{
    const auto build = glassBall(random, index % 4, AtCap::black);
    return askTree(fmt::format("a glass ball, max_depth {}", index % 4), build.scene, {0, random.in(0.2, 0.8), 4},
                   {0, 0, -1});
}

/// The ray that could add less than the cutoff: half-way between two bounces, on the logarithmic scale.
Question cutoff(Random& random, int)
{
    const double grey = random.in(0.4, 0.8);
    auto build = corridor(random, 40, grey);
    build.scene.trace.cutoff = 1; // so that the scene tells how bright it can be
    const double brightest = Scene<double>(build.scene).brightest;
    const int bounces = random.whole(1, 8);
    build.scene.trace.cutoff = brightest * std::pow(grey, bounces - 0.5);
    return along(random, fmt::format("facing mirrors, cutoff {:.6g}", build.scene.trace.cutoff), build);
}

/// The sky is bright, the ball is dark: the product counts.
Question cutoffUnderABrightSky(Random& random, int index)
{
    const V sky = random.in(20, 100) * random.color();
    const double dark = random.in(0.01, 0.05);
    auto build = Build()
                     .sky(sky)
                     .material({.name = "bowling ball", .color = dark * random.color(), .mirror = 1})
                     .sphere(V(0), 1);
    const double most = largestChannel(build.scene.materials[0].color) * largestChannel(sky);
    build.scene.trace.cutoff = most * (index % 2 ? random.in(0.5, 0.9) : random.in(1.1, 1.5));
    return askTree(fmt::format("a dark ball under a bright sky, cutoff {:.6g}", build.scene.trace.cutoff), build.scene,
                   {random.in(-0.3, 0.3), random.in(-0.3, 0.3), 4}, {0, 0, -1});
}

Question blackOrSky(Random& random, int index)
{
    const auto policy = index % 2 ? AtCap::sky : AtCap::black;
    const auto build = glassBall(random, random.whole(0, 3), policy);
    return askColor(
        fmt::format("a glass ball, max_depth {}, at_cap = \"{}\"", build.scene.trace.maxDepth, word(policy)),
        build.scene, {0, random.in(0.2, 0.8), 4}, {0, 0, -1});
}

/// A lit floor in a mirror above it, or the sky where there is no floor.
Question oneRayFurther(Random& random, int index, bool floor, AtCap policy)
{
    auto build = Build().sky(random.in(0.5, 2) * random.color()).depth(0);
    build.scene.trace.atCap = policy;
    build.material({.name = "mirror", .color = random.color(), .mirror = 1}).plane({0, 3, 0}, {0, -1, 0});
    build.light({random.in(-2, 2), random.in(1, 2.5), random.in(-2, 2)}, random.in(5, 15));
    if (floor) build.material({.name = "floor", .color = random.color()}).floor();
    return askTree(
        fmt::format("a mirror above {}, max_depth 0, at_cap = \"{}\"", floor ? "a floor" : "nothing", word(policy)),
        build.scene, {random.in(-1, 1), random.in(0.5, 1.5), index % 5 * 0.1}, {random.in(-1, 1), 1, random.in(-1, 1)});
}

Question directOrSky(Random& random, int index)
{
    return oneRayFurther(random, index, true, index % 2 ? AtCap::direct : AtCap::sky);
}
Question directMeetsNothing(Random& random, int index)
{
    return oneRayFurther(random, index, false, index % 2 ? AtCap::direct : AtCap::black);
}

/// A floor below a coloured glass ball; every other question is about the cap, or who never wrote it would be right.
Question tintOrCap(Random& random, int index)
{
    if (index % 2) return depth(random, index / 2);
    auto build = Build().material({.name = "floor", .color = random.color()}).floor();
    build.light({0, 4, 0}, random.in(10, 30)).light({random.in(3, 4), 4, 0}, random.in(10, 30));
    build.material({.name = "glass", .color = random.color(), .ior = 1.5}).sphere({0, 2, 0}, random.in(0.4, 0.7));
    const bool tint = index % 4 == 0;
    build.scene.trace.shadowThroughGlass = tint ? ShadowThroughGlass::tint : ShadowThroughGlass::block;
    const V at(random.in(-0.2, 0.2), 0, random.in(-0.2, 0.2)),
        eye(random.in(1, 2), random.in(0.5, 1), random.in(-1, 1));
    return askColor(fmt::format("below a glass ball, shadow_through_glass = \"{}\"", tint ? "tint" : "block"),
                    build.scene, eye, at - eye);
}

} // namespace

std::vector<Criterion> capCriteria()
{
    return {
        {"07-cap", "how deep mirrors are followed", depth},
        {"07-cap", "how deep glass is followed", glassTree},
        {"07-cap", "the cutoff", cutoff},
        {"07-cap", "the cutoff under a bright sky", cutoffUnderABrightSky},
        {"07-cap", "light through glass, and the cap", tintOrCap},
        {"07-policy", "black and sky", blackOrSky},
        {"07-policy", "direct and sky", directOrSky},
        {"07-policy", "direct that meets nothing, and black", directMeetsNothing},
    };
}

} // namespace rt::grade
