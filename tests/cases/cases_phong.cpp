// Lesson 08: part diffuse, part glossy.

#include "tests/cases/cases.h"

namespace rt::cases
{

std::vector<Case> phongCases()
{
    constexpr auto glossySlide = "Glossy Material";
    constexpr auto slide = "Phong Shading";
    return {
        {"Phong", "IsOneInTheMiddleOfTheHighlight", glossySlide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const double exponent : {1.0, 10.0, 1000.0, 1048576.0})
             {
                 check.near("straight above", 1, s.phong({0, 1, 0}, {0, 1, 0}, {0, 1, 0}, 1, exponent), s.ulps(8));
                 check.near("light and eye on opposite sides, both at 45 degrees", 1,
                            s.phong({1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, 1, exponent), s.ulps(8) * exponent);
             }
         }},
        {"Phong", "FallsAsThePowerOfTheCosine", glossySlide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             // N and L straight up: R is straight up, and V.R is the cosine of V's angle.
             for (const double exponent : {1.0, 2.0, 5.0, 20.0, 50.0})
                 for (const double cosine : {0.99, 0.8, 0.6, 0.1})
                     check.near(fmt::format("V.R = {}, alpha = {}", cosine, exponent), std::pow(cosine, exponent),
                                s.phong({0, 1, 0}, {0, 1, 0}, {std::sqrt(1 - cosine * cosine), cosine, 0}, 1, exponent),
                                s.ulps(16) * exponent);
         }},
        {"Phong", "IsZeroAwayFromTheHighlight", glossySlide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("V.R < 0", 0, s.phong({1, 0.2, 0}, {0, 1, 0}, {1, 0.1, 0}, 1, 2), 0);
             check.near("the eye next to a slanting lamp, alpha = 1: V.R = 0", 0,
                        s.phong({1, 1, 0}, {0, 1, 0}, {1, 1, 0}, 1, 1), s.ulps(8));
         }},
        {"Phong", "IsDarkIfTheLampIsBehindTheSurface", glossySlide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("no highlight on the back", 0, s.phong({1, -1, 0}, {0, 1, 0}, {-1, -1, 0}, 1, 1), 0);
             check.near("nor diffuse light", 0, s.phong({0.2, -1, 0}, {0, 1, 0}, {0, 1, 0}, 0.5, 3), 0);
             check.near("lamp straight below, eye straight above", 0, s.phong({0, -1, 0}, {0, 1, 0}, {0, 1, 0}, 1, 2),
                        0);
         }},
        {"Phong", "BlendsDiffuseAndGlossy", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const double f : {0.0, 0.25, 0.5, 1.0})
                 check.near(fmt::format("f = {}: N.L = 0.8, V.R = 1", f), (1 - f) * 0.8 + f,
                            s.phong({3, 4, 0}, {0, 1, 0}, {-3, 4, 0}, f, 8), s.ulps(64));
         }},
        {"Phong", "WithoutGlossIsDiffuse", slide, Kind::property,
         [](Check& check, const Subject& s) {
             for (int i = 0; i < 30; ++i)
             {
                 const V L = glm::normalize(V(std::sin(i), 0.1 + std::abs(std::cos(i * 1.3)), std::cos(i * 0.4)));
                 check.near("N.L from every side", L.y, s.phong(L, {0, 1, 0}, {std::cos(i), 1, std::sin(i)}, 0, 50),
                            s.ulps(16));
             }
         }},
        {"Phong", "StaysTheSameIfEyeAndLampChangePlaces", glossySlide, Kind::property,
         [](Check& check, const Subject& s) {
             for (int i = 0; i < 30; ++i)
             {
                 const V L(std::sin(i), 1.1, std::cos(i * 0.4)), W(std::cos(i * 1.7), 1.3, std::sin(i * 0.9));
                 check.near("V.R = L.(V mirrored)", s.phong(L, {0, 1, 0}, W, 1, 7), s.phong(W, {0, 1, 0}, L, 1, 7),
                            s.ulps(256));
             }
         }},
        {"Glossy", "SurfaceShowsTheLampWithFalloffShadowAndColour", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build()
                              .material({.name = "g", .color = {0.5, 1, 0.25}, .glossy = 1, .exponent = 4})
                              .floor()
                              .light({2, 2, 0}, {8, 16, 32});
             check.near("the highlight at 45 degrees, dist² = 8", V(0.5, 2, 1),
                        s.color(build.scene, {-2, 2, 0}, {1, -1, 0}), s.ulps(256));
             build.material({.name = "blocker"}).sphere({1, 1, 0}, 0.3);
             check.near("the same in the shadow", V(0), s.color(build.scene, {-2, 2, 0}, {1, -1, 0}), 0);
         }},
        {"Glossy", "SurfaceDoesNotShowOtherObjects", slide, Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto scene = Build()
                                    .material({.name = "g", .glossy = 0.5, .exponent = 9})
                                    .floor()
                                    .light({2, 2, 0}, 8)
                                    .sphere({3, 3, 0}, 0.5)
                                    .scene;
             const auto tree = s.tree(scene, {-2, 2, 0}, {1, -1, 0});
             check.equal("nodes", std::size_t(1), tree.nodes.size());
             check.equal("shadow rays", std::size_t(1), tree.shadows.size());
         }},
        {"Glossy", "LooksBackAlongTheArrivingRay", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             // The highlight is seen in a mirror: V is the way back to the mirror, not to the camera.
             auto build = Build().material({.name = "g", .glossy = 1, .exponent = 64}).floor().light({3, 3, 0}, 18);
             build.material({.name = "m", .mirror = 1}).plane({0, 5, 0}, {0, -1, 0});
             check.near("camera at (-8, 3, 0), mirror at height 5", V(1), s.color(build.scene, {-7, 3, 0}, {1, 1, 0}),
                        s.ulps(4096));
         }},
        {"Picture", "OfPhongExponentsIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/08_phong/scenes/exponents.toml", "08_exponents.exr");
         }},
        {"Picture", "OfEverythingIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/08_phong/scenes/everything.toml", "08_everything.exr");
         }},
    };
}

} // namespace rt::cases
