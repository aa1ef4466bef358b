// Lesson 03: part mirror, part diffuse. True in every later lesson too.

#include "tests/cases/cases.h"

namespace rt::cases
{

namespace
{

/// A white floor with a lamp of 4 at height 2, and above it a ceiling of the share s. The ray from (-5, 1, 0) along (1, 1, 0)
/// meets the ceiling at (-3, 3, 0), where the lamp alone brings `ceilingDirect`; its reflection sees the floor at 1.
SceneDescription ceiling(double s, const V& color = V(1))
{
    return Build()
        .floor()
        .light({0, 2, 0}, 4)
        .material({.name = "ceiling", .color = color, .mirror = s})
        .plane({0, 3, 0}, {0, -1, 0})
        .scene;
}

const double ceilingDirect = 4 / std::sqrt(10.0) / 10;

} // namespace

std::vector<Case> partialCases()
{
    constexpr auto slide = "Partially Reflective Surfaces";
    return {
        {"Partial", "AddsSOfTheMirrorAndTheRestOfTheDirectLight", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
                 check.near(fmt::format("a ceiling that reflects {}", share),
                            V(share * 1 + (1 - share) * ceilingDirect), s.color(ceiling(share), {-5, 1, 0}, {1, 1, 0}),
                            s.ulps(256));
         }},
        {"Partial", "TintsBothPartsByTheColour", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             const V color(1, 0.5, 0.25);
             check.near("half mirror of color (1, 0.5, 0.25)", color * (0.5 + 0.5 * ceilingDirect),
                        s.color(ceiling(0.5, color), {-5, 1, 0}, {1, 1, 0}), s.ulps(256));
         }},
        {"Partial", "IsAStraightLineInS", slide, Kind::property,
         [](Check& check, const Subject& s) {
             const auto at = [&](double share) { return s.color(ceiling(share), {-5, 1, 0}, {1, 1, 0}).x; };
             for (int i = 1; i < 10; ++i)
                 check.near("between share 0 and share 1", at(0) + (at(1) - at(0)) * i / 10, at(i / 10.0), s.ulps(256));
         }},
        {"Partial", "NeverExceedsTheBrighterPart", slide, Kind::property,
         [](Check& check, const Subject& s) {
             for (const double share : {0.1, 0.5, 0.9})
             {
                 const double color = s.color(ceiling(share), {-5, 1, 0}, {1, 1, 0}).x;
                 check.that("the blend lies between its parts", color > ceilingDirect && color < 1);
             }
         }},
        {"Partial", "FollowsTheReflectedRayAndCastsShadowRays", "Ray Tree", Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto tree = s.tree(ceiling(0.25), {-5, 1, 0}, {1, 1, 0});
             check.equal("nodes", std::size_t(2), tree.nodes.size());
             check.equal("shadow rays", std::size_t(2), tree.shadows.size());
             if (tree.nodes.size() != 2) return;
             check.near("share of the reflected ray", 0.25, tree.nodes[1].weight, s.ulps(4));
             check.near("what the ceiling itself adds", V(0.75 * ceilingDirect), tree.nodes[0].contribution,
                        s.ulps(256));
             check.near("what the floor adds", V(0.25), tree.nodes[1].contribution, s.ulps(256));
         }},
        {"Partial", "AsksOnlyForWhatCounts", "Ray Tree", Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto mirror = s.tree(ceiling(1), {-5, 1, 0}, {1, 1, 0});
             check.equal("nodes at share 1: itself and the floor in it", std::size_t(2), mirror.nodes.size());
             check.equal("shadow rays at share 1: those of the floor", std::size_t(1), mirror.shadows.size());
             const auto diffuse = s.tree(ceiling(0), {-5, 1, 0}, {1, 1, 0});
             check.equal("nodes at share 0: it sends no reflected ray", std::size_t(1), diffuse.nodes.size());
             check.equal("shadow rays at share 0: its own", std::size_t(1), diffuse.shadows.size());
         }},
        {"Picture", "OfHalfSpecularSpheresIsAsStored", "Spheres: 50% specular", Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/03_partial_reflection/scenes/half_specular.toml", "03_half_specular.exr");
         }},
        {"Picture", "OfARowOfSharesIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/03_partial_reflection/scenes/shares.toml", "03_shares.exr");
         }},
    };
}

} // namespace rt::cases
