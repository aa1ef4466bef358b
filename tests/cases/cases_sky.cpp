// Lesson 04: light from outside the scene, unclamped. True in every later lesson too.

#include "tests/cases/cases.h"

namespace rt::cases
{

std::vector<Case> skyCases()
{
    constexpr auto slide = "Reflecting a HDR Sky";
    return {
        {"Sky", "IsWhatARaySeesThatMeetsNothing", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("an empty scene", V(0.25, 0.5, 2), s.color(Build().sky({0.25, 0.5, 2}).scene, V(0), {1, 2, 3}),
                        0);
             check.near("no sky is a black sky", V(0), s.color(Build().floor().scene, {0, 1, 0}, {0, 1, 0}), 0);
         }},
        {"Sky", "MakesABlackBowlingBallShine", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto ball =
                 Build().sky(V(100)).material({.name = "bowling", .color = V(0.01), .mirror = 1}).sphere(V(0), 1).scene;
             check.near("0.01 * 100", V(1), s.color(ball, {0, 0, 3}, {0, 0.2, -1}), s.ulps(64));
         }},
        {"Sky", "IsNotClampedOnTheWay", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("a sky of 1000", V(1000), s.color(Build().sky(V(1000)).scene, V(0), {0, 1, 0}), s.ulps(64));
             auto scene = Build().sky(V(4096)).material({.name = "dark", .color = V(1 / 64.0), .mirror = 1}).scene;
             scene.planes = {{.point = {0, 0, 0}, .normal = {1, 0, 1}, .material = 0},
                             {.point = {0, 0, 0}, .normal = {-1, 0, 1}, .material = 0}};
             check.near("4096 after two mirrors of 1/64", V(1), s.color(scene, {-0.25, 0, 8}, {0, 0, -1}), s.ulps(64));
         }},
        {"Sky", "ReachesDiffuseSurfacesOnlyThroughMirrors", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = Build().sky(V(5)).floor().light({0, 2, 0}, 4).scene;
             check.near("a floor under a bright sky: the lamp only", V(1), s.color(scene, {0.5, 0.5, 0}, {-1, -1, 0}),
                        s.ulps(64));
         }},
        {"Sky", "IsNotSeenBehindTheCap", "Cap recursion", Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto ball = Build().sky(V(1)).depth(0).material({.name = "m", .mirror = 1}).sphere(V(0), 1).scene;
             check.near("a mirror at MAXDEPTH 0", V(0), s.color(ball, {0, 0, 3}, {0, 0, -1}), 0);
         }},
        {"Sky", "OfOneColourMakesAMirrorBallVanish", slide, Kind::property,
         [](Check& check, const Subject& s) {
             auto build = Build().sky({1, 0.5, 0.25}).material({.name = "mirror", .mirror = 1});
             const auto scene = build.sphere(V(0), 1).sphere({1.5, 0.3, -2}, 0.7).scene;
             for (int i = 0; i < 40; ++i)
                 check.near("every ray sees the same sky", V(1, 0.5, 0.25),
                            s.color(scene, {0, 0, 5}, {std::sin(i) * 0.4, std::cos(i * 1.7) * 0.3, -1}), s.ulps(64));
         }},
        {"Sky", "GrowsFromTheHorizonToTheZenith", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto scene = Build().sky({1, 1, 1}).scene;
             scene.sky.zenith = V(0, 0.5, 1);
             check.near("the zenith", V(0, 0.5, 1), s.color(scene, V(0), {0, 1, 0}), s.ulps(8));
             check.near("the horizon", V(1), s.color(scene, V(0), {1, 0, 0}), s.ulps(8));
             check.near("30 degrees above it", V(0.5, 0.75, 1), s.color(scene, V(0), {std::sqrt(3.0), 1, 0}),
                        s.ulps(16));
             check.near("below it", V(1), s.color(scene, V(0), {1, -1, 0}), s.ulps(8));
         }},
        {"Sky", "HasASunOfItsSize", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto scene = Build().sky({0, 0, 1}).scene;
             scene.sky.sun = Sun{.direction = {0, 1, 0}, .color = V(100), .size = 10};
             const auto at = [&](double degrees) {
                 const double angle = degrees * SkyFormulas<double>::PI / 180;
                 return s.color(scene, V(0), {std::sin(angle), std::cos(angle), 0});
             };
             check.near("4.9 degrees from its middle", V(100), at(4.9), s.ulps(8));
             check.near("5.1 degrees from its middle", V(0, 0, 1), at(5.1), s.ulps(8));
         }},
        {"LatLong", "PutsTheAxesWhereTheyBelong", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto expect = [&](const V& D, double u, double v) {
                 const auto [gotU, gotV] = s.latLong(D);
                 const auto where = fmt::format("({}, {}, {})", D.x, D.y, D.z);
                 check.near("u of " + where, u, gotU, s.ulps(8));
                 check.near("v of " + where, v, gotV, s.ulps(8));
             };
             expect({0, 0, -1}, 0.5, 0.5);
             expect({1, 0, 0}, 0.75, 0.5);
             expect({-1, 0, 0}, 0.25, 0.5);
             expect({0, 1, -1}, 0.5, 0.25);
             expect({0, -1, -1}, 0.5, 0.75);
             expect({1, 0, -1}, 0.625, 0.5);
             expect({-1, 0, 1}, 0.125, 0.5);
             check.near("v of the zenith", 0, s.latLong({0, 1, 0})[1], s.ulps(8));
             check.near("v of the nadir", 1, s.latLong({0, -1, 0})[1], s.ulps(8));
         }},
        {"LatLong", "StaysInThePicture", slide, Kind::property,
         [](Check& check, const Subject& s) {
             for (int i = 0; i < 200; ++i)
             {
                 const auto [u, v] = s.latLong({std::sin(i * 1.1), std::cos(i * 2.3), std::sin(i * 0.7 + 1)});
                 check.that("0 <= u, v <= 1", u >= 0 && u <= 1 && v >= 0 && v <= 1);
             }
         }},
        {"LatLong", "CanBeUndone", slide, Kind::property,
         [](Check& check, const Subject& s) {
             for (int i = 0; i < 50; ++i)
             {
                 const V D = glm::normalize(V(std::sin(i * 1.1), std::cos(i * 2.3), std::sin(i * 0.7 + 1)));
                 const auto [u, v] = s.latLong(D);
                 constexpr double PI = SkyFormulas<double>::PI;
                 const double longitude = (u - 0.5) * 2 * PI, latitude = v * PI;
                 const V back(std::sin(latitude) * std::sin(longitude), std::cos(latitude),
                              -std::sin(latitude) * std::cos(longitude));
                 check.near("the direction of (u, v)", D, back, s.ulps(64));
             }
         }},
        {"Tree", "EndsInTheSkyWithItsColour", "Ray Tree", Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto ball =
                 Build().sky(V(3)).material({.name = "m", .color = V(0.5), .mirror = 1}).sphere(V(0), 1).scene;
             const auto tree = s.tree(ball, {0, 0, 3}, {0, 0, -1});
             check.equal("nodes", std::size_t(2), tree.nodes.size());
             if (tree.nodes.size() != 2) return;
             check.equal("end of the second", std::string("miss"), std::string(name(tree.nodes[1].end)));
             check.near("radiance of the second", V(3), tree.nodes[1].radiance, 0);
             check.near("its contribution", V(1.5), tree.nodes[1].contribution, s.ulps(4));
             check.near("contribution of the mirror itself", V(0), tree.nodes[0].contribution, 0);
         }},
        {"Picture", "OfTheBowlingBallIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/04_hdr_sky/scenes/bowling_ball.toml", "04_bowling_ball.exr");
         }},
        {"Picture", "UnderAProbeIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/04_hdr_sky/scenes/probe.toml", "04_probe.exr");
         }},
    };
}

} // namespace rt::cases
