// Lesson 02: the reflected vector and the mirror. True in every later lesson too.

#include "tests/cases/cases.h"

namespace rt::cases
{

namespace
{

/// Directions and normals all around, never parallel to each other.
template <class Visit>
void forDirections(Visit&& visit)
{
    for (int i = 0; i < 60; ++i)
        visit(glm::normalize(V(std::sin(i * 1.3), std::cos(i * 2.1), std::sin(i * 0.7 + 1))),
              glm::normalize(V(std::cos(i * 1.9), std::sin(i * 1.1 + 2), std::cos(i * 0.3))));
}

/// Two mirrors that face each other at z = -1 and z = 1, and nothing else but a light.
SceneDescription facingMirrors(int maxDepth, const V& color = V(1))
{
    return Build()
        .material({.name = "mirror", .color = color, .mirror = 1})
        .plane({0, 0, -1}, {0, 0, 1})
        .plane({0, 0, 1}, {0, 0, -1})
        .light({0, 0, 0}, 1)
        .depth(maxDepth)
        .scene;
}

} // namespace

std::vector<Case> mirrorCases()
{
    constexpr auto vector = "Reflected Vector";
    constexpr auto transport = "Light Transport";
    return {
        {"Reflect", "MirrorsAtTheFloor", vector, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("R of D = unit(1, -1, 0), N = (0, 1, 0)", V(std::sqrt(0.5), std::sqrt(0.5), 0),
                        s.reflect({1, -1, 0}, {0, 1, 0}), s.ulps(8));
             check.near("R of D = (0.6, 0, -0.8), N = (0, 0, 1)", V(0.6, 0, 0.8), s.reflect({0.6, 0, -0.8}, {0, 0, 1}),
                        s.ulps(8));
             check.near("R of D = (0, 0, -1), N = unit(1, 0, 1)", V(1, 0, 0), s.reflect({0, 0, -1}, {1, 0, 1}),
                        s.ulps(8));
         }},
        {"Reflect", "ReturnsWhereItCameFromAtNormalIncidence", vector, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("R of D = -N", V(0, 0.6, 0.8), s.reflect({0, -0.6, -0.8}, {0, 0.6, 0.8}), s.ulps(8));
         }},
        {"Reflect", "GoesStraightOnAtGrazingIncidence", vector, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("R of D at right angles to N", V(1, 0, 0), s.reflect({1, 0, 0}, {0, 1, 0}), s.ulps(8));
         }},
        {"Reflect", "KeepsTheAngleToTheNormal", vector, Kind::property,
         [](Check& check, const Subject& s) {
             forDirections(
                 [&](const V& D, const V& N) { check.near("N.R", -dot(N, D), dot(N, s.reflect(D, N)), s.ulps(16)); });
         }},
        {"Reflect", "KeepsTheLength", vector, Kind::property,
         [](Check& check, const Subject& s) {
             forDirections(
                 [&](const V& D, const V& N) { check.near("|R|", 1, glm::length(s.reflect(D, N)), s.ulps(16)); });
         }},
        {"Reflect", "StaysInThePlaneOfDAndN", vector, Kind::property,
         [](Check& check, const Subject& s) {
             forDirections([&](const V& D, const V& N) {
                 check.near("R.(D x N)", 0, dot(s.reflect(D, N), cross(D, N)), s.ulps(16));
             });
         }},
        {"Reflect", "TwiceIsTheSameDirectionAgain", vector, Kind::property,
         [](Check& check, const Subject& s) {
             forDirections(
                 [&](const V& D, const V& N) { check.near("R of R", D, s.reflect(s.reflect(D, N), N), s.ulps(32)); });
         }},
        {"Reflect", "DoesNotCareWhichWayTheNormalPoints", vector, Kind::property,
         [](Check& check, const Subject& s) {
             forDirections([&](const V& D, const V& N) {
                 check.near("R with -N", s.reflect(D, N), s.reflect(D, -N), s.ulps(16));
             });
         }},
        {"Mirror", "ShowsWhatTheReflectedRaySees", transport, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build().material({.name = "floor", .color = {1, 0.5, 0.25}}).floor().light({0, 2, 0}, 4);
             build.material({.name = "mirror", .mirror = 1}).plane({0, 3, 0}, {0, -1, 0});
             check.near("the floor 2 below the light, seen in the ceiling", V(1, 0.5, 0.25),
                        s.color(build.scene, {-5, 1, 0}, {1, 1, 0}), s.ulps(256));
             const auto ball = Build()
                                   .material({.name = "wall", .color = {0.5, 1, 1}})
                                   .plane({0, 0, 9}, {0, 0, -1})
                                   .light({0, 0, 7}, 4)
                                   .material({.name = "mirror", .mirror = 1})
                                   .sphere({0, 0, 0}, 1)
                                   .scene;
             check.near("the wall behind, seen in the middle of a ball", V(0.5, 1, 1),
                        s.color(ball, {0, 0, 5}, {0, 0, -1}), s.ulps(256));
         }},
        {"Mirror", "AbsorbsButKnowsNoAngle", transport, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build()
                              .floor()
                              .light({0, 2, 0}, 4)
                              .material({.name = "mirror", .color = {0.5, 0.25, 0.125}, .mirror = 1})
                              .plane({0, 3, 0}, {0, -1, 0});
             check.near("white seen in a mirror of color (0.5, 0.25, 0.125) at 45 degrees", V(0.5, 0.25, 0.125),
                        s.color(build.scene, {-5, 1, 0}, {1, 1, 0}), s.ulps(256));
             check.near("the same at a steeper angle", V(0.5, 0.25, 0.125),
                        s.color(build.scene, {-2.5, 1, 0}, {0.5, 1, 0}), s.ulps(256));
         }},
        {"Mirror", "NeedsNoLightOfItsOwn", transport, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build()
                              .floor()
                              .light({0, 2, 0}, 4)
                              .material({.name = "mirror", .mirror = 1})
                              .plane({0, 3, 0}, {0, -1, 0});
             build.sphere({-2.8, 1.8, 0}, 0.1).material({.name = "diffuse"});
             check.near("a mirror in the shadow shows the same", V(1), s.color(build.scene, {-5, 1, 0}, {1, 1, 0}),
                        s.ulps(256));
         }},
        {"Mirror", "MultipliesTheColoursOfAllBounces", transport, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto corner = Build()
                               .material({.name = "wall", .color = {1, 1, 0.5}})
                               .plane({0, 0, 9}, {0, 0, -1})
                               .light({0.25, 0, 7}, 4);
             corner.material({.name = "a", .color = {0.5, 1, 1}, .mirror = 1})
                 .plane({0, 0, 0}, {1, 0, 1})
                 .material({.name = "b", .color = {1, 0.25, 1}, .mirror = 1})
                 .plane({0, 0, 0}, {-1, 0, 1});
             check.near("a wall seen in two mirrors at a right angle", V(0.5, 0.25, 0.5),
                        s.color(corner.scene, {-0.25, 0, 8}, {0, 0, -1}), s.ulps(512));
         }},
        {"Mirror", "SendsARayBackFromACornerOfThree", vector, Kind::property,
         [](Check& check, const Subject& s) {
             const auto scene = Build()
                                    .material({.name = "m", .mirror = 1})
                                    .plane(V(0), {1, 0, 0})
                                    .plane(V(0), {0, 1, 0})
                                    .plane(V(0), {0, 0, 1})
                                    .scene;
             for (int i = 0; i < 20; ++i)
             {
                 const V D = -glm::normalize(V(1.1 + std::sin(i), 1.2 + std::cos(i * 2), 1.3 + std::sin(i * 3)));
                 const auto tree = s.tree(scene, {5, 6, 7}, D);
                 check.equal("nodes", std::size_t(4), tree.nodes.size());
                 if (!tree.nodes.empty())
                     check.near("direction of the last ray", -D, tree.nodes.back().direction, s.ulps(64));
             }
         }},
        {"Mirror", "AtAPlaceTheCameraRayHitsCastsNoShadowRay", transport, Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto scene = Build()
                                    .floor()
                                    .light({0, 2, 0}, 4)
                                    .material({.name = "mirror", .mirror = 1})
                                    .plane({0, 3, 0}, {0, -1, 0})
                                    .scene;
             const auto tree = s.tree(scene, {-5, 1, 0}, {1, 1, 0});
             check.equal("nodes", std::size_t(2), tree.nodes.size());
             check.equal("shadow rays", std::size_t(1), tree.shadows.size());
             if (tree.nodes.size() != 2 || tree.shadows.size() != 1) return;
             check.equal("kind of the second", std::string("reflected"), std::string(name(tree.nodes[1].kind)));
             check.equal("depth of the second", 1, tree.nodes[1].depth);
             check.equal("parent of the second", 0, tree.nodes[1].parent);
             check.equal("node of the shadow ray", 1, tree.shadows[0].node);
             check.near("origin of the second", V(-3, 3, 0), tree.nodes[1].origin, s.ulps(64));
             check.near("direction of the second", V(std::sqrt(0.5), -std::sqrt(0.5), 0), tree.nodes[1].direction,
                        s.ulps(64));
         }},
        {"Cap", "TracesRaysOfDepthMaxdepthAndNoDeeper", "Cap recursion", Kind::treeShape,
         [](Check& check, const Subject& s) {
             for (const int depth : {0, 1, 2, 7, 20})
             {
                 const auto tree = s.tree(facingMirrors(depth), {0.5, 0, 0}, {0.01, 0, 1});
                 check.equal(fmt::format("nodes at MAXDEPTH {}", depth), std::size_t(depth) + 1, tree.nodes.size());
                 if (tree.nodes.empty()) continue;
                 check.equal("depth of the last", depth, tree.nodes.back().depth);
                 check.equal("end of the last", std::string("cap"), std::string(name(tree.nodes.back().end)));
                 check.near("color", V(0), tree.nodes[0].radiance, 0);
             }
         }},
        {"Picture", "OfPureSpecularSpheresIsAsStored", "Spheres: pure specular", Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/02_mirrors/scenes/pure_specular.toml", "02_pure_specular.exr");
         }},
        {"Picture", "OfFacingMirrorsIsAsStored", "Cap recursion", Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/02_mirrors/scenes/facing_mirrors.toml", "02_facing_mirrors.exr");
         }},
    };
}

} // namespace rt::cases
