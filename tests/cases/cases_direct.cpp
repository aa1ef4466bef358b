// Lesson 01: intersections, and the light that arrives straight from the lamps. True in every later lesson too.

#include "tests/cases/cases.h"

namespace rt::cases
{

std::vector<Case> directCases()
{
    constexpr auto pseudocode = "Whitted-style Ray Tracing, Pseudocode";
    return {
        {"Sphere", "IsMetAtTheNearSide", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("t from (0, 0, 5) along -z to the unit sphere", 4, s.toSphere({0, 0, 5}, {0, 0, -1}, V(0), 1),
                        s.ulps(64));
             check.near("t from (3, 4, 9) along -z to a sphere of radius 2 at (3, 4, 1)", 6,
                        s.toSphere({3, 4, 9}, {0, 0, -1}, {3, 4, 1}, 2), s.ulps(64));
             check.near("t from (0, 0.6, 5) along -z to the unit sphere", 4.2,
                        s.toSphere({0, 0.6, 5}, {0, 0, -1}, V(0), 1), s.ulps(64));
         }},
        {"Sphere", "IsMetAtTheFarSideFromInside", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("t from the centre", 1, s.toSphere({0, 0, 0}, {0, 1, 0}, V(0), 1), s.ulps(64));
             check.near("t from (0.5, 0, 0) along +x", 0.5, s.toSphere({0.5, 0, 0}, {1, 0, 0}, V(0), 1), s.ulps(64));
             check.near("t from (0.5, 0, 0) along -x", 1.5, s.toSphere({0.5, 0, 0}, {-1, 0, 0}, V(0), 1), s.ulps(64));
         }},
        {"Sphere", "IsMissedBesideAndBehind", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("t beside the sphere (-1 stands for std::nullopt)", -1,
                        s.toSphere({0, 1.01, 5}, {0, 0, -1}, V(0), 1), 0);
             check.near("t with the sphere behind the ray (-1 stands for std::nullopt)", -1,
                        s.toSphere({0, 0, 5}, {0, 0, 1}, V(0), 1), 0);
         }},
        {"Sphere", "PutsThePointOnTheSphere", pseudocode, Kind::property,
         [](Check& check, const Subject& s) {
             for (int i = 0; i < 50; ++i)
             {
                 const V origin(std::sin(i * 1.7) * 6, std::cos(i * 2.3) * 6, 7 + i % 5),
                     target(std::sin(i * 3.1) * 0.5, std::cos(i * 0.7) * 0.5, 0);
                 const double t = s.toSphere(origin, target - origin, V(0), 1);
                 check.near("distance of O + tD from the centre", 1,
                            glm::length(origin + t * glm::normalize(target - origin)), s.ulps(256));
             }
         }},
        {"Plane", "IsMetFromBothSides", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("t straight down from height 3", 3, s.toPlane({1, 3, 2}, {0, -1, 0}, V(0), {0, 1, 0}),
                        s.ulps(64));
             check.near("t from below", 3, s.toPlane({1, -3, 2}, {0, 1, 0}, V(0), {0, 1, 0}), s.ulps(64));
             check.near("t at 60 degrees from height 2", 4,
                        s.toPlane({0, 2, 0}, {std::sqrt(3.0), -1, 0}, {5, 0, 5}, {0, 1, 0}), s.ulps(64));
         }},
        {"Plane", "IsMissedBehindAndAlongIt", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("t with the plane behind (-1 stands for std::nullopt)", -1,
                        s.toPlane({0, 3, 0}, {0, 1, 0}, V(0), {0, 1, 0}), 0);
             check.near("t along the plane (-1 stands for std::nullopt)", -1,
                        s.toPlane({0, 3, 0}, {1, 0, 0}, V(0), {0, 1, 0}), 0);
             check.near("t within the plane (-1 stands for std::nullopt)", -1,
                        s.toPlane({0, 0, 0}, {1, 0, 0}, V(0), {0, 1, 0}), 0);
         }},
        {"Trace", "ReturnsBlackWhereNothingIs", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = Build().floor().light({0, 2, 0}, 8).scene;
             check.near("color of a ray into the void", V(0), s.color(scene, {0, 1, 0}, {0, 1, 0}), 0);
         }},
        {"Trace", "SeesTheNearestObject", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build().material({.name = "red", .color = {1, 0, 0}}).sphere({0, 0, -4}, 1);
             build.material({.name = "green", .color = {0, 1, 0}}).sphere({0, 0, -8}, 1).light({0, 0, 0}, 9);
             check.near("color of the nearer sphere, 3 from the light", V(1, 0, 0),
                        s.color(build.scene, V(0), {0, 0, -1}), s.ulps(64));
             const auto tree = s.tree(build.scene, V(0), {0, 0, -1});
             check.equal("primitive", std::string("sphere0"),
                         tree.nodes.at(0).hit ? tree.nodes[0].hit->primitive : "nothing");
         }},
        {"Trace", "MultipliesByTheColourOfTheMaterial", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = Build()
                                    .material({.name = "m", .color = {0.5, 0.25, 0.125}})
                                    .floor()
                                    .light({0, 2, 0}, {8, 16, 32})
                                    .scene;
             check.near("(0.5, 0.25, 0.125) * (8, 16, 32) / 2²", V(1), s.color(scene, {1, 1, 0}, {-1, -1, 0}),
                        s.ulps(64));
         }},
        {"Trace", "SeesTheCheckerOfThePlane", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build().floor().light({0, 1000, 0}, 1e6);
             build.scene.planes[0].hasChecker = true;
             build.scene.planes[0].checkerColor = V(0.5);
             build.scene.planes[0].checkerSize = 2;
             for (const auto& [x, z, expected] : {std::array{0.5, 0.5, 1.0},
                                                  {2.5, 0.5, 0.5},
                                                  {0.5, -0.5, 0.5},
                                                  {-0.5, -0.5, 1.0},
                                                  {2.5, 3.9, 1.0},
                                                  {4.1, 3.9, 0.5}})
                 check.near(fmt::format("color at ({}, 0, {})", x, z), V(expected),
                            s.color(build.scene, {x, 1, z}, {0, -1, 0}), 1e-4);
         }},
        {"Direct", "IsColorOverDistanceSquaredBelowTheLight", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const double height : {0.5, 1.0, 2.0, 10.0})
             {
                 const auto scene = Build().floor().light({0, height, 0}, {4, 2, 1}).scene;
                 check.near(fmt::format("floor {} below the light", height), V(4, 2, 1) / (height * height),
                            s.color(scene, {0.1, 0.1, 0}, {-1, -1, 0}), s.ulps(64));
             }
         }},
        {"Direct", "FallsWithTheCosineOfTheAngle", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = Build().floor().light({3, 4, 0}, 25).scene;
             check.near("N.L = 4/5 at distance 5: 25 * 0.8 / 25", V(0.8), s.color(scene, {-1, 1, 0}, {1, -1, 0}),
                        s.ulps(64));
         }},
        {"Direct", "AddsAllLights", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = Build()
                                    .floor()
                                    .light({0, 1, 0}, {1, 0, 0})
                                    .light({0, 2, 0}, {0, 4, 0})
                                    .light({0, 4, 0}, {0, 0, 16})
                                    .scene;
             check.near("three lights, each bringing 1 in its channel", V(1),
                        s.color(scene, {0.5, 0.5, 0}, {-1, -1, 0}), s.ulps(64));
         }},
        {"Direct", "IsNeverNegativeBehindTheSurface", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build().floor().light({0, -2, 0}, 8);
             check.near("floor lit from below, seen from above", V(0), s.color(build.scene, {0, 1, 0}, {0, -1, 0}), 0);
             build.light({0, 2, 0}, 4);
             check.near("the same with a light above", V(1), s.color(build.scene, {0.5, 0.5, 0}, {-1, -1, 0}),
                        s.ulps(64));
         }},
        {"Direct", "LightsTheSideThatIsSeen", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto below = Build().floor().light({0, -2, 0}, 8).scene;
             check.near("floor lit and seen from below", V(2), s.color(below, {0.5, -0.5, 0}, {-1, 1, 0}), s.ulps(64));
             const auto triangle =
                 Build().triangle({-1, 0, -1}, {1, 0, -1}, {0, 0, 1}).light({0, 2, 0}, 8).light({0, -4, 0}, 16).scene;
             check.near("triangle from above", V(2), s.color(triangle, {0.1, 0.1, 0}, {-1, -1, 0}), s.ulps(64));
             check.near("triangle from below", V(1), s.color(triangle, {0.1, -0.1, 0}, {-1, 1, 0}), s.ulps(64));
             const auto inside = Build().sphere({0, 0, 0}, 2).light({0, 0, 0}, 8).scene;
             check.near("a sphere's inside, lit from its centre", V(2), s.color(inside, {0.5, 0, 0}, {0, 1, 0.3}),
                        s.ulps(256));
         }},
        {"Direct", "SkipsALightOnThePoint", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = Build().floor().light({0, 0, 0}, 8).light({0, 2, 0}, 4).scene;
             check.near("a light in the very point that is lit", V(1), s.color(scene, {0, 1, 0}, {0, -1, 0}),
                        s.ulps(64));
         }},
        {"Direct", "FallsWithTheSquareOfTheDistance", pseudocode, Kind::property,
         [](Check& check, const Subject& s) {
             const auto at = [&](double height) {
                 return s.color(Build().floor().light({0, height, 0}, 1).scene, {0.1, 0.1, 0}, {-1, -1, 0}).x;
             };
             for (const double height : {0.25, 1.0, 3.0})
                 check.near("a quarter at twice the distance", at(height) / 4, at(2 * height), s.ulps(64));
         }},
        {"Direct", "GrowsWithTheLight", pseudocode, Kind::property,
         [](Check& check, const Subject& s) {
             const auto at = [&](double brightness) {
                 return s.color(Build().floor().light({1, 2, 3}, brightness).scene, {0.1, 0.1, 0}, {-1, -1, 0}).x;
             };
             check.near("twice the light, twice the colour", 2 * at(5), at(10), s.ulps(64));
         }},
        {"Visible", "NotThroughAnObject", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto ball = Build().floor().sphere({0, 2, 0}, 0.5).light({0, 4, 0}, 16).scene;
             check.near("in the shadow of a ball", V(0), s.color(ball, {0.5, 0.5, 0}, {-1, -1, 0}), 0);
             check.near("beside the shadow", V(16.0 * 4 / std::pow(25, 1.5)), s.color(ball, {3.5, 0.5, 0}, {-1, -1, 0}),
                        s.ulps(256));
             const auto wall = Build().floor().plane({0, 2, 0}, {0, -1, 0}).light({0, 4, 0}, 16).scene;
             check.near("under a second plane", V(0), s.color(wall, {0.5, 0.5, 0}, {-1, -1, 0}), 0);
             const auto tile = Build().floor().triangle({-1, 2, -1}, {1, 2, -1}, {0, 2, 1}).light({0, 4, 0}, 16).scene;
             check.near("under a triangle", V(0), s.color(tile, {0.5, 0.5, 0}, {-1, -1, 0}), 0);
         }},
        {"Visible", "PastAnObjectBehindTheLight", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto ball = Build().floor().sphere({0, 4, 0}, 1).light({0, 2, 0}, 4).scene;
             check.near("the ball is above the light", V(1), s.color(ball, {0.5, 0.5, 0}, {-1, -1, 0}), s.ulps(64));
             const auto ceiling = Build().floor().plane({0, 2.5, 0}, {0, -1, 0}).light({0, 2, 0}, 4).scene;
             check.near("a ceiling just above the light", V(1), s.color(ceiling, {0.5, 0.5, 0}, {-1, -1, 0}),
                        s.ulps(64));
         }},
        {"Visible", "NotBlockedByWhatIsBehindThePoint", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = Build().floor().sphere({0, -2, 0}, 1).light({0, 2, 0}, 4).scene;
             check.near("a ball below the floor", V(1), s.color(scene, {0.5, 0.5, 0}, {-1, -1, 0}), s.ulps(64));
         }},
        {"Visible", "NotFromTheDarkSideOfASphere", pseudocode, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = Build().sphere({0, 0, 0}, 1).light({0, 0, -5}, 16).scene;
             check.near("the side away from the light", V(0), s.color(scene, {0, 0, 3}, {0, 0, -1}), 0);
             check.near("the side towards it, 4 away", V(1), s.color(scene, {0, 0, -3}, {0, 0, 1}), s.ulps(64));
         }},
        {"Tree", "HasOneNodeAndAShadowRayForEachLight", "Ray Tree", Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto scene = Build().floor().sphere({0, 2, 0}, 0.5).light({0, 4, 0}, 16).light({3, 4, 0}, 25).scene;
             const auto tree = s.tree(scene, {-1, 1, 0}, {1, -1, 0});
             check.equal("nodes", std::size_t(1), tree.nodes.size());
             check.equal("shadow rays", std::size_t(2), tree.shadows.size());
             if (tree.nodes.empty() || tree.shadows.size() != 2) return;
             check.equal("end", std::string("absorbed"), std::string(name(tree.nodes[0].end)));
             check.equal("light 0 visible", false, tree.shadows[0].visible);
             check.equal("blocker of light 0", std::string("sphere0"),
                         tree.shadows[0].blocker ? tree.shadows[0].blocker->primitive : "nothing");
             check.equal("light 1 visible", true, tree.shadows[1].visible);
             check.equal("light of the second shadow ray", 1, tree.shadows[1].light);
             check.near("distance to light 1", 5, tree.shadows[1].distance, s.ulps(64));
             check.near("direction to light 1", V(0.6, 0.8, 0), tree.shadows[1].direction, s.ulps(64));
         }},
        {"Tree", "EndsWhereNothingIsHit", "Ray Tree", Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto tree = s.tree(Build().floor().light({0, 4, 0}, 16).scene, {0, 1, 0}, {0, 1, 0});
             check.equal("nodes", std::size_t(1), tree.nodes.size());
             check.equal("shadow rays", std::size_t(0), tree.shadows.size());
             if (!tree.nodes.empty()) check.equal("end", std::string("miss"), std::string(name(tree.nodes[0].end)));
         }},
        {"Picture", "OfDiffuseSpheresIsAsStored", pseudocode, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/01_direct_illumination/scenes/diffuse_spheres.toml",
                         "01_diffuse_spheres.exr");
         }},
        {"Picture", "OfLightFromBehindIsAsStored", pseudocode, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/01_direct_illumination/scenes/behind.toml", "01_behind.exr");
         }},
    };
}

} // namespace rt::cases
