// Lesson 05: Snell's law, the transmitted vector, total internal reflection. True in every later lesson too: the scenes say
// fresnel = "none" where a reflected share would show.

#include "tests/cases/cases.h"

namespace rt::cases
{

namespace
{

/// Arrives on the plane y = 0 from above at `angle` radians from the normal (0, 1, 0).
V arriving(double angle)
{
    return {std::sin(angle), -std::cos(angle), 0};
}

Build glass(double ior = 1.5, double outside = 1, const V& color = V(1))
{
    return Build()
        .fresnel(FresnelModel::none)
        .material({.name = "glass", .color = color, .ior = ior, .iorOutside = outside});
}

/// The node's data that the cases look at; an absent node is a failure, not a crash.
const RayTree::Node* nodeAt(Check& check, const RayTree& tree, std::size_t id)
{
    check.that(fmt::format("there is a node {}", id), id < tree.nodes.size());
    return id < tree.nodes.size() ? &tree.nodes[id] : nullptr;
}

} // namespace

std::vector<Case> refractionCases()
{
    constexpr auto slide = "Dielectrics";
    return {
        {"K", "IsTheSquareOfCosine2", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("k at normal incidence", 1, s.cosSquared2(1, 1, 1.5), s.ulps(8));
             check.near("k at 45 degrees, 1 -> 1.5: 1 - 0.5/2.25", 1 - 0.5 / 2.25,
                        s.cosSquared2(std::sqrt(0.5), 1, 1.5), s.ulps(8));
             check.near("k at 60 degrees, 1 -> 2: 1 - 0.75/4", 1 - 0.75 / 4, s.cosSquared2(0.5, 1, 2), s.ulps(8));
             check.near("k at 60 degrees, 1.5 -> 1: 1 - 2.25 * 0.75", 1 - 2.25 * 0.75, s.cosSquared2(0.5, 1.5, 1),
                        s.ulps(8));
         }},
        {"Refract", "GoesStraightOnAtNormalIncidence", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const auto& [n1, n2] : {std::pair{1.0, 1.5}, {1.5, 1.0}, {1.3, 2.4}})
             {
                 const auto T = s.refract({0, -1, 0}, {0, 1, 0}, n1, n2);
                 check.that("there is a transmitted ray", T.has_value());
                 if (T) check.near("T", V(0, -1, 0), *T, s.ulps(8));
             }
         }},
        {"Refract", "BendsAsSnellSays", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto T = s.refract(arriving(45 * degree), {0, 1, 0}, 1, 1.5);
             check.that("there is a transmitted ray", T.has_value());
             if (T) check.near("into glass at 45 degrees: sin2 = sin1 / 1.5", std::sqrt(0.5) / 1.5, T->x, s.ulps(16));
             const auto out = s.refract(arriving(30 * degree), {0, 1, 0}, 1.5, 1);
             check.that("there is a transmitted ray out of the glass", out.has_value());
             if (out) check.near("out of glass at 30 degrees", V(0.75, -std::sqrt(1 - 0.5625), 0), *out, s.ulps(16));
         }},
        {"Refract", "IsEmptyBeyondTheCriticalAngle", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.that("41.8 degrees, 1.5 -> 1: transmitted",
                        s.refract(arriving(41.8 * degree), {0, 1, 0}, 1.5, 1).has_value());
             for (const double angle : {41.82, 45.0, 60.0, 89.0})
                 check.that(fmt::format("{} degrees, 1.5 -> 1: nothing is transmitted", angle),
                            !s.refract(arriving(angle * degree), {0, 1, 0}, 1.5, 1).has_value());
             check.that("89 degrees, 1 -> 1.5: transmitted",
                        s.refract(arriving(89 * degree), {0, 1, 0}, 1, 1.5).has_value());
         }},
        {"Refract", "KeepsSnellsLawAtEveryAngle", slide, Kind::property,
         [](Check& check, const Subject& s) {
             for (int angle = 1; angle < 90; angle += 4)
                 for (const auto& [n1, n2] : {std::pair{1.0, 1.5}, {1.0, 1.333}, {1.333, 1.5}, {1.5, 1.0}, {2.4, 1.0}})
                 {
                     const double sin2 = n1 / n2 * std::sin(angle * degree);
                     if (std::abs(sin2 - 1) < 1e-3) continue; // the critical angle itself: rounding decides
                     const auto T = s.refract(arriving(angle * degree), {0, 1, 0}, n1, n2);
                     const auto what = fmt::format("{} degrees, {} -> {}", angle, n1, n2);
                     check.equal(what + ": transmitted", sin2 < 1, T.has_value());
                     if (!T) continue;
                     check.near(what + ": sin2", sin2, T->x, s.ulps(64));
                     check.near(what + ": length of T", 1, glm::length(*T), s.ulps(256));
                     check.that(what + ": T goes on to the other side", T->y < 0);
                     check.near(what + ": T stays in the plane of D and N", 0, T->z, s.ulps(8));
                 }
         }},
        {"Refract", "ReturnsTheWayItCame", slide, Kind::property,
         [](Check& check, const Subject& s) {
             for (int angle = 0; angle < 85; angle += 5)
             {
                 const V D = arriving(angle * degree);
                 const auto T = s.refract(D, {0, 1, 0}, 1, 1.5);
                 const auto back = T ? s.refract(-*T, {0, -1, 0}, 1.5, 1) : std::nullopt;
                 check.that("both ways are open", back.has_value());
                 if (back) check.near("the reversed ray leaves along -D", -D, *back, s.ulps(256));
             }
         }},
        {"Refract", "ChangesNothingBetweenEqualMedia", slide, Kind::property,
         [](Check& check, const Subject& s) {
             for (int angle = 0; angle < 90; angle += 7)
             {
                 const auto T = s.refract(arriving(angle * degree), {0, 1, 0}, 1.5, 1.5);
                 check.that("transmitted", T.has_value());
                 if (T) check.near("T is D", arriving(angle * degree), *T, s.ulps(64));
             }
         }},
        {"Glass", "ShowsWhatIsBehindThroughTheMiddleOfABall", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build().fresnel(FresnelModel::none).material({.name = "wall", .color = {1, 0.5, 0.25}});
             build.plane({0, 0, -5}, {0, 0, 1})
                 .light({0.5, 0, -3}, 4)
                 .material({.name = "glass", .ior = 1.5})
                 .sphere(V(0), 1);
             build.scene.lights[0].position = {0, 0, -3};
             check.near("the wall 2 from the lamp", V(1, 0.5, 0.25), s.color(build.scene, {0, 0, 5}, {0, 0, -1}),
                        s.ulps(256));
         }},
        {"Glass", "TintsAtEachSurface", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = glass(1.5, 1, {1, 0.5, 0.25}).sphere(V(0), 1).sky(V(1)).scene;
             check.near("two surfaces of color (1, 0.5, 0.25)", V(1, 0.25, 0.0625),
                        s.color(scene, {0, 0, 5}, {0, 0, -1}), s.ulps(64));
         }},
        {"Glass", "BlocksShadowRays", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build =
                 Build().floor().light({0, 4, 0}, 16).material({.name = "glass", .ior = 1.5}).sphere({0, 2, 0}, 0.5);
             check.near("the floor below a glass ball", V(0), s.color(build.scene, {0.5, 0.5, 0}, {-1, -1, 0}), 0);
         }},
        {"Glass", "TurnsARayByTwiceTheBendOfOneSurface", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const auto scene = glass().sphere(V(0), 1).scene;
             for (const double height : {0.1, 0.5, 0.8, 0.95})
             {
                 const auto tree = s.tree(scene, {0, height, 5}, {0, 0, -1});
                 const auto* out = nodeAt(check, tree, 2);
                 if (!out) continue;
                 const double turned = 2 * (std::asin(height) - std::asin(height / 1.5)); // towards the axis
                 check.near(fmt::format("direction behind the ball, entered {} above its axis", height),
                            V(0, -std::sin(turned), -std::cos(turned)), out->direction, s.ulps(512));
             }
         }},
        {"Glass", "LeavesASlabInTheDirectionItEntered", slide, Kind::property,
         [](Check& check, const Subject& s) {
             auto build = glass();
             const auto scene = build.plane({0, 0, 0}, {0, 1, 0}).plane({0, -1, 0}, {0, -1, 0}).scene;
             for (const double angle : {0.0, 20.0, 50.0, 80.0})
             {
                 const auto tree = s.tree(scene, {0, 1, 0}, arriving(angle * degree));
                 if (const auto* out = nodeAt(check, tree, 2))
                     check.near("direction behind the slab", arriving(angle * degree), out->direction, s.ulps(256));
             }
         }},
        {"Glass", "OfTheSameIndexIsInvisible", slide, Kind::property,
         [](Check& check, const Subject& s) {
             const auto scene = glass(1.25, 1.25).sphere(V(0), 1).scene;
             for (const double height : {0.0, 0.5, 0.99})
             {
                 const auto tree = s.tree(scene, {0, height, 5}, {0, 0, -1});
                 if (const auto* out = nodeAt(check, tree, 2))
                     check.near("the ray goes straight on", V(0, 0, -1), out->direction, s.ulps(64));
             }
         }},
        {"Glass", "KnowsTheMediaOnBothSides", "Ray Tree", Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto tree = s.tree(glass(1.5, 1.25).sphere(V(0), 1).scene, {0, 0.3, 5}, {0, 0, -1});
             check.equal("nodes: in, out, away", std::size_t(3), tree.nodes.size());
             if (tree.nodes.size() != 3) return;
             check.equal("kind of the second", std::string("transmitted"), std::string(name(tree.nodes[1].kind)));
             check.equal("kind of the third", std::string("transmitted"), std::string(name(tree.nodes[2].kind)));
             check.near("n1 on the way in", 1.25, tree.nodes[0].n1.value_or(0), 0);
             check.near("n2 on the way in", 1.5, tree.nodes[0].n2.value_or(0), 0);
             check.near("n1 on the way out", 1.5, tree.nodes[1].n1.value_or(0), 0);
             check.near("n2 on the way out", 1.25, tree.nodes[1].n2.value_or(0), 0);
             check.that("the second meets the ball from inside", tree.nodes[1].hit && tree.nodes[1].hit->inside);
         }},
        {"Glass", "ReflectsAllAtABubbleBeyondTheCriticalAngle", slide, Kind::treeShape,
         [](Check& check, const Subject& s) {
             auto build = glass(1.0, 1.5); // a bubble; the camera is in the glass
             const auto scene = build.sphere(V(0), 1).scene;
             const auto total = s.tree(scene, {0, 0.8, 5}, {0, 0, -1}); // sin1 = 0.8 > 1/1.5
             check.equal("nodes", std::size_t(2), total.nodes.size());
             if (total.nodes.size() != 2) return;
             check.that("node 0 is total internal reflection", total.nodes[0].tir);
             check.equal("kind", std::string("reflected"), std::string(name(total.nodes[1].kind)));
             check.near("direction", V(0, 2 * 0.8 * 0.6, -1 + 2 * 0.6 * 0.6), total.nodes[1].direction, s.ulps(64));
             const auto open = s.tree(scene, {0, 0.6, 5}, {0, 0, -1}); // sin1 = 0.6 < 1/1.5
             check.equal("nodes below the critical angle", std::size_t(3), open.nodes.size());
             if (!open.nodes.empty()) check.that("node 0 is not", !open.nodes[0].tir);
         }},
        {"Glass", "LetsACameraInsideLookOut", slide, Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto tree = s.tree(glass().sphere(V(0), 1).scene, {0, 0.5, 0}, {0, 0, -1});
             check.equal("nodes", std::size_t(2), tree.nodes.size());
             if (tree.nodes.size() != 2) return;
             check.near("n1", 1.5, tree.nodes[0].n1.value_or(0), 0);
             const double turned = std::asin(0.75) - std::asin(0.5); // sin2 = 1.5 * 0.5
             check.near("direction outside", V(0, -std::sin(turned), -std::cos(turned)), tree.nodes[1].direction,
                        s.ulps(64));
         }},
        {"Picture", "OfAGlassBallIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/05_refraction/scenes/glass_ball.toml", "05_glass_ball.exr");
         }},
        {"Picture", "OfABubbleIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/05_refraction/scenes/bubble.toml", "05_bubble.exr");
         }},
        {"Picture", "OfASlabIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/05_refraction/scenes/slab.toml", "05_slab.exr");
         }},
    };
}

} // namespace rt::cases
