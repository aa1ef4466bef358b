// Lesson 06: how much is reflected, and two rays at every boundary. True in every later lesson too.

#include "tests/cases/cases.h"

namespace rt::cases
{

namespace
{

/// Oracle values of the Fresnel equations for unpolarised light, from the closed form in 30 digits.
struct Oracle
{
    double degrees, n1, n2, Fr;
};
constexpr Oracle exact[] = {
    {0, 1, 1.5, 0.04},
    {30, 1, 1.5, 0.04152262597582154},
    {45, 1, 1.5, 0.05023991101223594},
    {60, 1, 1.5, 0.08918671280221278},
    {75, 1, 1.5, 0.2530605629903197},
    {85, 1, 1.5, 0.6127996452648274},
    {89, 1, 1.5, 0.9041849497801891},
    {0, 1.5, 1, 0.04},
    {30, 1.5, 1, 0.05519016729537592},
    {40, 1.5, 1, 0.2452912042869103},
};

/// A glass ball alone under a white sky: the furnace.
SceneDescription furnace(int maxDepth)
{
    return Build().sky(V(1)).depth(maxDepth).material({.name = "glass", .ior = 1.5}).sphere(V(0), 1).scene;
}

double weightOf(const RayTree& tree, RayKind kind)
{
    for (const auto& node : tree.nodes)
        if (node.parent == 0 && node.kind == kind) return node.weight;
    return -1;
}

} // namespace

std::vector<Case> fresnelCases()
{
    constexpr auto slide = "Dielectrics: Fresnel equations";
    constexpr auto schlickSlide = "Dielectrics: Schlick's approximation";
    constexpr auto energy = "Dielectrics: law of conservation of energy";
    return {
        {"Fresnel", "HasTheValuesOfTheEquations", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const auto& [degrees, n1, n2, Fr] : exact)
                 check.near(fmt::format("Fr at {} degrees, {} -> {}", degrees, n1, n2), Fr,
                            s.fresnel(std::cos(degrees * degree), n1, n2), std::max(1e-12, s.ulps(64)));
         }},
        {"Fresnel", "IsOneBeyondTheCriticalAngle", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const double angle : {41.82, 50.0, 89.0, 90.0})
                 check.near(fmt::format("Fr at {} degrees, 1.5 -> 1", angle), 1,
                            s.fresnel(std::cos(angle * degree), 1.5, 1), 0);
             const double nearly = s.fresnel(std::cos(41.8 * degree), 1.5, 1);
             check.that("at 41.8 degrees almost all, but not all, is reflected", nearly > 0.85 && nearly < 0.95);
         }},
        {"Fresnel", "IsOneAlongTheSurface", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("Fr at 90 degrees, 1 -> 1.5", 1, s.fresnel(0, 1, 1.5), s.ulps(8));
             check.near("Fr at 90 degrees, 1.5 -> 1", 1, s.fresnel(0, 1.5, 1), s.ulps(8));
         }},
        {"Fresnel", "IsZeroBetweenEqualMedia", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const double cos1 : {1.0, 0.5, 0.1, 0.0})
                 check.near(fmt::format("Fr for cos1 = {}, 1.5 -> 1.5: no boundary, so exactly 0", cos1), 0,
                            s.fresnel(cos1, 1.5, 1.5), 0);
         }},
        {"Fresnel", "AtBrewstersAngleIsHalfOfTheOtherPolarisation", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             // tan1 = n2/n1: rp = 0, and rs = (n1² - n2²)/(n1² + n2²).
             for (const auto& [n1, n2] : {std::pair{1.0, 1.5}, {1.0, 1.333}, {1.5, 1.0}})
             {
                 const double rs = (n1 * n1 - n2 * n2) / (n1 * n1 + n2 * n2);
                 check.near(fmt::format("Fr at Brewster's angle, {} -> {}", n1, n2), rs * rs / 2,
                            s.fresnel(n1 / std::sqrt(n1 * n1 + n2 * n2), n1, n2), s.ulps(32));
             }
         }},
        {"Fresnel", "IsTheSameFromBothSides", slide, Kind::property,
         [](Check& check, const Subject& s) {
             for (int angle = 0; angle < 90; angle += 3)
             {
                 const double cos1 = std::cos(angle * degree), cos2 = std::sqrt(s.cosSquared2(cos1, 1, 1.5));
                 check.near(fmt::format("{} degrees outside, and its angle inside", angle), s.fresnel(cos1, 1, 1.5),
                            s.fresnel(cos2, 1.5, 1), s.ulps(512));
             }
         }},
        {"Fresnel", "LiesBetweenZeroAndOneAndGrowsPastBrewster", slide, Kind::property,
         [](Check& check, const Subject& s) {
             double before = s.fresnel(std::cos(57 * degree), 1, 1.5);
             for (int angle = 58; angle <= 90; ++angle)
             {
                 const double Fr = s.fresnel(std::cos(angle * degree), 1, 1.5);
                 check.that(fmt::format("Fr at {} degrees exceeds that at {}", angle, angle - 1),
                            Fr > before && Fr <= 1.000001);
                 before = Fr;
             }
         }},
        {"Schlick", "HasTheValuesOfTheFormula", schlickSlide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const double degrees : {0.0, 30.0, 45.0, 60.0, 75.0, 85.0, 89.0})
                 check.near(fmt::format("Fr at {} degrees, 1 -> 1.5", degrees),
                            0.04 + 0.96 * std::pow(1 - std::cos(degrees * degree), 5),
                            s.schlick(std::cos(degrees * degree), 1, 1.5), s.ulps(64));
         }},
        {"Schlick", "TakesTheLargerAngleOnTheWayOut", schlickSlide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("Fr at 40 degrees, 1.5 -> 1",
                        0.04 + 0.96 * std::pow(1 - std::sqrt(1 - std::pow(1.5 * std::sin(40 * degree), 2)), 5),
                        s.schlick(std::cos(40 * degree), 1.5, 1), s.ulps(512));
             check.near("about 0.2456 there", 0.2456, s.schlick(std::cos(40 * degree), 1.5, 1), 1e-4);
             check.near("R0 straight on", 0.04, s.schlick(1, 1.5, 1), s.ulps(8));
         }},
        {"Schlick", "IsOneBeyondTheCriticalAngleAndZeroBetweenEqualMedia", schlickSlide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("Fr at 45 degrees, 1.5 -> 1", 1, s.schlick(std::cos(45 * degree), 1.5, 1), 0);
             check.near("Fr at 60 degrees, 1.5 -> 1.5: no boundary, so exactly 0", 0, s.schlick(0.5, 1.5, 1.5), 0);
             check.near("Fr along the surface, 1.5 -> 1.5: no boundary, so exactly 0", 0, s.schlick(0, 1.5, 1.5), 0);
         }},
        {"Schlick", "StaysWithin36ThousandthsOfTheEquationsForGlass", schlickSlide, Kind::property,
         [](Check& check, const Subject& s) {
             // What the equations give, as numbers: a right schlick does not lose points for a wrong fresnel.
             constexpr std::pair<double, double> exact[] = {
                 {0, 0.04},      {15, 0.040081}, {30, 0.041523}, {45, 0.05024},  {60, 0.089187},
                 {70, 0.171043}, {75, 0.253061}, {80, 0.387704}, {84, 0.557814}, {85, 0.6128},
                 {86, 0.674053}, {88, 0.818735}, {90, 1}};
             double worst = 0;
             for (const auto& [angle, Fr] : exact)
                 worst = std::max(worst, std::abs(s.schlick(std::cos(angle * degree), 1, 1.5) - Fr));
             check.near("the largest difference from the equations, at 85 degrees", 0.0357, worst, 1e-4);
         }},
        {"Split", "SendsFrAlongRAndTheRestAlongT", energy, Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto tree = s.tree(furnace(1), {0, std::sin(60 * degree), 5}, {0, 0, -1});
             check.equal("nodes", std::size_t(3), tree.nodes.size());
             const double Fr = weightOf(tree, RayKind::reflected), Ft = weightOf(tree, RayKind::transmitted);
             // Whatever it is, right or wrong: that is asked of fresnel.
             const double expected = s.fresnel(std::cos(60 * degree), 1, 1.5);
             check.near("share of the reflected ray at 60 degrees: what your fresnel returns", expected, Fr,
                        s.ulps(512));
             check.near("share of the transmitted ray: the rest", 1 - expected, Ft, s.ulps(512));
             if (!tree.nodes.empty()) check.near("Fr of the node", Fr, tree.nodes[0].fresnel.value_or(-1), 0);
         }},
        {"Split", "LosesAndMakesNoEnergy", energy, Kind::knownValue,
         [](Check& check, const Subject& s) {
             // At cap d all but (1 - Fr) Fr^(d-1) of the light has left the ball.
             for (const double angle : {0.0, 60.0, 80.0})
                 for (const int depth : {1, 2, 3, 8})
                 {
                     const double F = s.fresnel(std::cos(angle * degree), 1, 1.5);
                     check.near(fmt::format("furnace at {} degrees, MAXDEPTH {}", angle, depth),
                                V(1 - (1 - F) * std::pow(F, depth - 1)),
                                s.color(furnace(depth), {0, std::sin(angle * degree), 5}, {0, 0, -1}), s.ulps(2048));
                 }
         }},
        {"Split", "HasTwoChildrenAtEachBoundary", "Ray Tree", Kind::treeShape,
         [](Check& check, const Subject& s) {
             for (const int depth : {0, 1, 2, 5})
                 check.equal(fmt::format("nodes of a ball at MAXDEPTH {}", depth), std::size_t(1 + 2 * depth),
                             s.tree(furnace(depth), {0, 0.5, 5}, {0, 0, -1}).nodes.size());
         }},
        {"Split", "ReflectsAllAtTotalInternalReflection", energy, Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto bubble =
                 Build().sky(V(2)).material({.name = "bubble", .ior = 1, .iorOutside = 1.5}).sphere(V(0), 1).scene;
             const auto tree = s.tree(bubble, {0, 0.8, 5}, {0, 0, -1});
             check.equal("nodes", std::size_t(2), tree.nodes.size());
             check.near("share of the reflected ray", 1, weightOf(tree, RayKind::reflected), 0);
             if (tree.nodes.empty()) return;
             check.that("total internal reflection", tree.nodes[0].tir);
             check.near("color", V(2), tree.nodes[0].radiance, s.ulps(8));
         }},
        {"Split", "TakesTheModelThatTheSceneNames", slide, Kind::treeShape,
         [](Check& check, const Subject& s) {
             auto scene = furnace(1);
             const double cos1 = std::cos(60 * degree);
             const auto share = [&](FresnelModel model) {
                 scene.trace.fresnel = model;
                 return weightOf(s.tree(scene, {0, std::sin(60 * degree), 5}, {0, 0, -1}), RayKind::reflected);
             };
             check.near("share of the reflected ray, fresnel = exact: what your fresnel returns",
                        s.fresnel(cos1, 1, 1.5), share(FresnelModel::exact), s.ulps(512));
             check.near("share of the reflected ray, fresnel = schlick: what your schlick returns",
                        s.schlick(cos1, 1, 1.5), share(FresnelModel::schlick), s.ulps(512));
             check.near("fresnel = none: no reflected ray is sent (-1: none; else its share)", -1,
                        share(FresnelModel::none), 0);
         }},
        {"Split", "ShowsTheLampLitFloorInTheGlass", energy, Kind::knownValue,
         [](Check& check, const Subject& s) {
             // Straight down onto a pool of glass: 0.04 of the ceiling, 0.96 of the floor of the pool; both are lit to 1.
             auto build = Build().material({.name = "ceiling", .color = {1, 0, 0}}).plane({0, 3, 0}, {0, -1, 0});
             build.material({.name = "bottom", .color = {0, 1, 0}})
                 .plane({0, -1, 0}, {0, 1, 0})
                 .light({0, 1, 0}, 4)
                 .light({0, -0.5, 0}, 0.25);
             build.material({.name = "glass", .ior = 1.5}).plane({0, 0, 0}, {0, 1, 0});
             check.near("0.04 red, 0.96 green", V(0.04, 0.96, 0), s.color(build.scene, {0, 2, 0}, {0, -1, 0}),
                        s.ulps(256));
         }},
        {"Picture", "OfHalfMirrorAndGlassIsAsStored", "Spheres: one 50% specular, one glass sphere", Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/06_fresnel/scenes/half_and_glass.toml", "06_half_and_glass.exr");
         }},
        {"Picture", "OfWaterIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/06_fresnel/scenes/water.toml", "06_water.exr");
         }},
    };
}

} // namespace rt::cases
