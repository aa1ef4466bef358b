// Lesson 07: when a ray is not followed, and what stands in for it; glass and shadow rays. True in lesson 08 too.

#include "tests/cases/cases.h"

namespace rt::cases
{

namespace
{

SceneDescription ballUnderSky(AtCap policy, int maxDepth)
{
    auto build = Build().sky(V(1)).depth(maxDepth).material({.name = "glass", .ior = 1.5}).sphere(V(0), 1);
    build.scene.trace.atCap = policy;
    return build.scene;
}

/// Facing mirrors of colour 1/2, and a sky that they hide.
SceneDescription corridor(double cutoff, int maxDepth = 64)
{
    auto build = Build().depth(maxDepth).material({.name = "m", .color = V(0.5), .mirror = 1});
    build.plane({0, 0, -1}, {0, 0, 1}).plane({0, 0, 1}, {0, 0, -1}).light({0, 0, 0.5}, 0.25);
    build.scene.trace.cutoff = cutoff;
    return build.scene;
}

} // namespace

std::vector<Case> capCases()
{
    constexpr auto slide = "Cap recursion";
    return {
        {"Policy", "BlackLosesWhatIsNotFollowed", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             check.near("a glass ball under a white sky, MAXDEPTH 1: all but Fr is lost", V(0.04),
                        s.color(ballUnderSky(AtCap::black, 1), {0, 0, 5}, {0, 0, -1}), s.ulps(64));
         }},
        {"Policy", "SkyStandsInForWhatIsNotFollowed", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             for (const int depth : {0, 1, 2, 5})
                 check.near(fmt::format("nothing is lost at MAXDEPTH {}", depth), V(1),
                            s.color(ballUnderSky(AtCap::sky, depth), {0, 0.4, 5}, {0, 0, -1}), s.ulps(64));
         }},
        {"Policy", "DirectLooksOneRayFurther", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build =
                 Build().floor().light({0, 2, 0}, 4).depth(0).material({.name = "m", .color = V(0.5), .mirror = 1});
             build.plane({0, 3, 0}, {0, -1, 0}).sky(V(7));
             build.scene.trace.atCap = AtCap::direct;
             check.near("the floor in a mirror at MAXDEPTH 0", V(0.5), s.color(build.scene, {-5, 1, 0}, {1, 1, 0}),
                        s.ulps(256));
             const auto tree = s.tree(build.scene, {-5, 1, 0}, {1, 1, 0});
             check.equal("nodes: the last is of depth MAXDEPTH + 1", std::size_t(2), tree.nodes.size());
             if (tree.nodes.size() == 2)
                 check.equal("its end", std::string("cap"), std::string(name(tree.nodes[1].end)));
             check.near("the sky, if it meets nothing", V(3.5),
                        s.color(
                            [&] {
                                auto open = build.scene;
                                open.planes.erase(open.planes.begin());
                                return open;
                            }(),
                            {-5, 1, 0}, {1, 1, 0}),
                        s.ulps(64));
         }},
        {"Policy", "IsNamedInTheTree", "Ray Tree", Kind::treeShape,
         [](Check& check, const Subject& s) {
             const auto tree = s.tree(ballUnderSky(AtCap::sky, 1), {0, 0.4, 5}, {0, 0, -1});
             check.equal("nodes", std::size_t(3), tree.nodes.size());
             check.equal("rays that were not followed", std::size_t(2), tree.capped.size());
             for (const auto& capped : tree.capped) check.near("what stands in", V(1), capped.radiance, 0);
             if (!tree.nodes.empty())
                 check.equal("end of the last node", std::string("cap"), std::string(name(tree.nodes.back().end)));
         }},
        {"Cutoff", "OffFollowsEveryRayToTheCap", slide, Kind::treeShape,
         [](Check& check, const Subject& s) {
             check.equal("nodes", std::size_t(21), s.tree(corridor(0, 20), {0.1, 0, 0}, {0, 0, 1}).nodes.size());
         }},
        {"Cutoff", "EndsARayThatCannotAddEnough", slide, Kind::treeShape,
         [](Check& check, const Subject& s) {
             // The lamp of 0.25 is 0.5 from a mirror: nothing returns more than 1. 2^-n < 0.01 first at n = 7.
             const auto tree = s.tree(corridor(0.01), {0.1, 0, 0}, {0, 0, 1});
             check.equal("nodes: depths 0 to 6", std::size_t(7), tree.nodes.size());
             if (!tree.nodes.empty())
                 check.equal("end of the last ray: one that is too weak calls rec.cutoff(ray)", std::string("cutoff"),
                             std::string(name(tree.nodes.back().end)));
             check.equal("why the next ray was not followed", std::string("cutoff"),
                         tree.capped.empty() ? "none" : std::string(name(tree.capped[0].reason)));
         }},
        {"Cutoff", "RespectsABrightSky", "Reflecting a HDR Sky", Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build =
                 Build().sky(V(100)).material({.name = "bowling", .color = V(0.01), .mirror = 1}).sphere(V(0), 1);
             build.scene.trace.cutoff = 0.5;
             check.near("a hundredth of a sky of 100, with a cutoff of 0.5", V(1),
                        s.color(build.scene, {0, 0, 3}, {0, 0, -1}), s.ulps(64));
             build.scene.trace.cutoff = 1.5;
             check.near("with a cutoff of 1.5", V(0), s.color(build.scene, {0, 0, 3}, {0, 0, -1}), 0);
         }},
        {"Cutoff", "RespectsABrightLamp", slide, Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build()
                              .floor()
                              .light({0, 2, 0}, 400)
                              .material({.name = "dark", .color = V(0.01), .mirror = 1})
                              .plane({0, 3, 0}, {0, -1, 0});
             build.scene.trace.cutoff = 0.5;
             check.near("a hundredth of a floor lit to 100", V(1), s.color(build.scene, {-5, 1, 0}, {1, 1, 0}),
                        s.ulps(256));
         }},
        {"Cutoff", "ChangesAPixelByNoMoreThanItAllows", slide, Kind::property,
         [](Check& check, const Subject& s) {
             auto scene = smallScene("lessons/06_fresnel/scenes/half_and_glass.toml");
             const Image all = s.picture(scene);
             scene.trace.cutoff = 0.004;
             const Image most = s.picture(scene);
             double worst = 0;
             for (std::size_t i = 0; i < all.pixels.size(); ++i)
                 worst = std::max(worst, largestChannel(V(abs(all.pixels[i] - most.pixels[i]))));
             check.that(fmt::format("{:.3g} is at most ten rays of 0.004", worst), worst <= 0.04);
             check.that("it changes something", worst > 0);
         }},
        {"Tint", "LetsLightThroughGlassTwiceColoured", "IsVisible", Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build()
                              .floor()
                              .light({0, 4, 0}, 16)
                              .material({.name = "glass", .color = {1, 0.5, 0.25}, .ior = 1.5})
                              .sphere({0, 2, 0}, 0.5);
             build.scene.trace.shadowThroughGlass = ShadowThroughGlass::tint;
             check.near("below a glass ball", V(1, 0.25, 0.0625), s.color(build.scene, {0.5, 0.5, 0}, {-1, -1, 0}),
                        s.ulps(256));
             build.material({.name = "solid"}).sphere({0, 3, 0}, 0.2);
             check.near("with a solid ball above it", V(0), s.color(build.scene, {0.5, 0.5, 0}, {-1, -1, 0}), 0);
             build.scene.trace.shadowThroughGlass = ShadowThroughGlass::block;
             build.scene.spheres.pop_back();
             check.near("blocked, if the scene says so", V(0), s.color(build.scene, {0.5, 0.5, 0}, {-1, -1, 0}), 0);
         }},
        {"Tint", "StopsAtTheLamp", "IsVisible", Kind::knownValue,
         [](Check& check, const Subject& s) {
             auto build = Build()
                              .floor()
                              .light({0, 2, 0}, 4)
                              .material({.name = "glass", .color = V(0.5), .ior = 1.5})
                              .sphere({0, 2, 0}, 0.5);
             build.scene.trace.shadowThroughGlass = ShadowThroughGlass::tint;
             check.near("a lamp in the middle of a glass ball", V(0.5),
                        s.color(build.scene, {0.5, 0.5, 0}, {-1, -1, 0}), s.ulps(256));
         }},
        {"Picture", "OfAGlassBallInAMirrorBoxIsAsStored", slide, Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/07_recursion_caps/scenes/mirror_box.toml", "07_mirror_box.exr");
         }},
        {"Picture", "OfGlassShadowsIsAsStored", "IsVisible", Kind::picture,
         [](Check& check, const Subject& s) {
             checkGolden(check, s, "lessons/07_recursion_caps/scenes/glass_shadow.toml", "07_glass_shadow.exr");
         }},
    };
}

} // namespace rt::cases
