// Lesson 04: the sky.
#include "tests/grade/questions/question.h"

namespace rt::grade
{

namespace
{

Question askLatLong(const V& D)
{
    const auto ask = [=](const Candidate& candidate) {
        const auto [u, v] = candidate.tracer.latLong(D);
        return Answer{{u, v}, {"u", "v"}};
    };
    return {"latLong of " + text(D), Shape::numbers, forValues, ask, {}};
}

V direction(double longitude, double latitude)
{
    return {std::sin(latitude) * std::sin(longitude), std::cos(latitude), -std::sin(latitude) * std::cos(longitude)};
}

// Straight up, straight down and straight back are left out: there u is anything, or both 0 and 1.
Question ahead(Random& random, int)
{
    return askLatLong(direction(random.in(-1.5, 1.5), random.in(0.3, 2.8)));
}
Question behind(Random& random, int)
{
    return askLatLong(direction(random.sign() * random.in(1.6, 3.1), random.in(0.3, 2.8)));
}
Question nearThePoles(Random& random, int index)
{
    const double latitude = random.in(0.05, 0.3);
    return askLatLong(direction(random.in(-3.1, 3.1), index % 2 ? latitude : std::acos(-1.0) - latitude));
}

/// Of the upper half, away from the horizon where a gradient has a kink.
V upwards(Random& random)
{
    const double y = random.in(0.1, 0.95), turn = random.in(0, 6.28), r = std::sqrt(1 - y * y);
    return {r * std::cos(turn), y, r * std::sin(turn)};
}

Question oneColour(Random& random, int)
{
    return askColor("an empty scene", Build().sky(random.in(0.5, 3) * random.color()).scene, random.vector(-3, 3),
                    random.direction());
}

Question gradient(Random& random, int)
{
    auto scene = Build().sky(random.color()).scene;
    scene.sky.zenith = 2.0 * random.color();
    return askColor("a sky that changes with height", scene, random.vector(-3, 3), upwards(random));
}

Question sun(Random& random, int index)
{
    auto scene = Build().sky(random.color()).scene;
    const V towards = random.direction();
    const double size = random.in(10, 40), radius = size / 2 * std::acos(-1.0) / 180;
    scene.sky.sun = Sun{.direction = towards, .color = random.in(10, 100) * random.color(), .size = size};
    const double angle = radius * (index % 2 ? random.in(0, 0.9) : random.in(1.1, 2));
    return askColor("a sky with a sun", scene, random.vector(-3, 3),
                    std::cos(angle) * towards + std::sin(angle) * random.across(towards));
}

/// 0.01 of 100: nothing may be clamped on the way.
Question bowlingBall(Random& random, int)
{
    const double dark = random.in(0.01, 0.05);
    auto build = Build().sky(random.in(30, 100) * random.color()).depth(4);
    build.material(
        {.name = "bowling ball", .color = dark * random.color(), .mirror = random.coin() ? 1 : random.in(0.3, 0.9)});
    build.sphere(V(0), 1);
    const V towards = random.direction();
    return askTree("a dark ball under a bright sky", build.scene, -4.0 * towards,
                   4.0 * towards + random.in(0, 0.8) * random.across(towards));
}

/// Is the sky seen where nothing is, and not behind the cap?
Question behindTheCap(Random& random, int index)
{
    auto build = Build().sky(random.in(0.5, 3) * random.color()).depth(index % 3);
    build.material({.name = "m", .color = random.color(), .mirror = 1});
    build.plane({0, 0, 0}, {1, 0, 1}).plane({0, 0, 0}, {-1, 0, 1}); // two bounces
    return askTree(fmt::format("a corner of mirrors, max_depth {}", index % 3), build.scene,
                   {random.in(0.2, 0.6) * random.sign(), random.in(-1, 1), 6}, {0, random.in(-0.1, 0.1), -1});
}

} // namespace

std::vector<Criterion> skyCriteria()
{
    return {
        {"04-miss", "a sky of one colour", oneColour},
        {"04-miss", "a gradient", gradient},
        {"04-miss", "a sun", sun},
        {"04-miss", "a dark ball under a bright sky", bowlingBall},
        {"04-miss", "the cap", behindTheCap},
        {"04-latlong", "ahead", ahead},
        {"04-latlong", "behind", behind},
        {"04-latlong", "near zenith and nadir", nearThePoles},
    };
}

} // namespace rt::grade
