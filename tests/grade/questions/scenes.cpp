// Scenes of one feature each. The lesson's ray trees say which pixels show it, so there is one truth about that too.
#include "tests/grade/questions/question.h"

namespace rt::grade
{

namespace
{

template <class Test>
bool anyNode(const RayTree& tree, const Test& test)
{
    return std::any_of(tree.nodes.begin(), tree.nodes.end(), test);
}

/// A floor, three balls with these materials in the view of the eye, two lamps.
Build stage(Random& random, const std::vector<Material<double>>& balls)
{
    auto build = Build().material({.name = "floor", .color = random.color()}).floor();
    double x = -1.7;
    for (const auto& material : balls)
    {
        const double radius = random.in(0.7, 0.9);
        build.material(material);
        build.scene.materials.back().name +=
            fmt::format(" {}", build.scene.materials.size()); // files need distinct names
        build.sphere({x + random.in(-0.1, 0.1), radius + 0.01, random.in(-0.5, 0.5)}, radius);
        x += 1.7;
    }
    build.light({random.in(-4, -2), random.in(4, 6), random.in(2, 4)}, random.in(20, 40));
    build.light({random.in(2, 4), random.in(4, 6), random.in(1, 3)}, random.in(20, 40));
    build.scene.camera.eye = {random.in(-1, 1), random.in(1.5, 2.5), random.in(5.5, 6.5)};
    build.scene.camera.target = {0, 0.7, 0};
    return build.depth(5);
}

Material<double> diffuse(Random& random, const std::string& name)
{
    return {.name = name, .color = random.color()};
}
Material<double> mirror(Random& random, double share = 1)
{
    return {.name = "mirror", .color = random.color(), .mirror = share};
}
Material<double> glass(Random& random)
{
    return {.name = "glass", .color = V(random.in(0.8, 1)), .ior = random.in(1.3, 1.7)};
}

SceneDescription diffuseBalls(Random& random)
{
    return stage(random, {diffuse(random, "a"), diffuse(random, "b"), diffuse(random, "c")}).scene;
}
bool isLit(const RayTree& tree)
{
    return anyNode(tree, [](const auto& node) { return node.hit.has_value(); });
}
/// By something else than itself: the dark side of a ball is dark without a shadow ray.
bool isInAShadow(const RayTree& tree)
{
    return std::any_of(tree.shadows.begin(), tree.shadows.end(), [&](const auto& shadow) {
        const auto& hit = tree.nodes[std::size_t(shadow.node)].hit;
        return shadow.blocker && hit && shadow.blocker->primitive != hit->primitive;
    });
}

SceneDescription mirrorBalls(Random& random)
{
    return stage(random, {mirror(random), diffuse(random, "b"), mirror(random)}).scene;
}
SceneDescription halfMirrors(Random& random)
{
    return stage(random,
                 {mirror(random, random.in(0.3, 0.7)), diffuse(random, "b"), mirror(random, random.in(0.3, 0.7))})
        .scene;
}
bool showsAMirror(const RayTree& tree)
{
    return anyNode(tree, [](const auto& node) { return node.kind == RayKind::reflected; });
}

void addSky(Build& build, Random& random)
{
    build.sky(random.in(0.3, 0.8) * random.color());
    build.scene.sky.zenith = random.color();
}

SceneDescription underTheSky(Random& random)
{
    auto build = stage(random, {mirror(random), diffuse(random, "b"), mirror(random, 0.5)});
    addSky(build, random);
    build.scene.sky.sun =
        Sun{.direction = random.direction() + V(0, 1.5, 0), .color = 20.0 * random.color(), .size = 20};
    return build.scene;
}
bool showsTheSky(const RayTree& tree)
{
    return anyNode(tree,
                   [](const auto& node) { return node.end == End::miss && largestChannel(node.contribution) > 0.01; });
}

SceneDescription glassBalls(Random& random, FresnelModel model)
{
    auto build = stage(random, {glass(random), mirror(random, 0.5), glass(random)});
    addSky(build, random);
    build.fresnel(model);
    return build.scene;
}
SceneDescription bubbles(Random& random)
{
    const double outside = random.in(1.3, 1.6);
    const Material<double> bubble{.name = "bubble", .color = V(random.in(0.8, 1)), .iorOutside = outside};
    auto build = stage(random, {bubble, diffuse(random, "b"), bubble});
    build.scene.materials[1].ior = build.scene.materials[3].ior = 1;
    addSky(build, random);
    return build.fresnel(FresnelModel::none).scene;
}
bool showsGlass(const RayTree& tree)
{
    return anyNode(tree, [](const auto& node) { return node.n1.has_value(); });
}
bool isRefracted(const RayTree& tree)
{
    return anyNode(tree, [](const auto& node) { return node.kind == RayKind::transmitted; });
}
bool isTotallyReflected(const RayTree& tree)
{
    return anyNode(tree, [](const auto& node) { return node.tir; });
}

/// Partial mirrors and glass, cut off early.
SceneDescription shallow(Random& random, AtCap policy)
{
    auto build =
        stage(random, {mirror(random, random.in(0.4, 0.8)), glass(random), mirror(random, random.in(0.4, 0.8))});
    addSky(build, random);
    build.scene.materials[0].mirror = random.in(0.3, 0.5);
    build.scene.trace.atCap = policy;
    return build.depth(random.whole(1, 2)).scene;
}
bool isCapped(const RayTree& tree)
{
    return !tree.capped.empty() || anyNode(tree, [](const auto& node) { return node.end == End::cap; });
}

SceneDescription glossyBalls(Random& random)
{
    const auto glossy = [&](const char* name) {
        return Material<double>{
            .name = name, .color = random.color(), .glossy = random.in(0.3, 0.8), .exponent = random.in(3, 40)};
    };
    auto build = stage(random, {glossy("glossy a"), mirror(random, 0.5), glossy("glossy c")});
    addSky(build, random);
    return build.scene;
}
bool isGlossy(const RayTree& tree)
{
    return anyNode(tree, [](const auto& node) { return node.hit && node.hit->material.starts_with("glossy"); });
}

} // namespace

std::vector<SceneCriterion> sceneCriteria(int lesson)
{
    switch (lesson)
    {
    case 1:
        return {{"01-direct", "picture: lit surfaces", diffuseBalls, isLit},
                {"01-visible", "picture: shadows", diffuseBalls, isInAShadow}};
    case 2:
        return {{"02-mirror", "picture: mirrors", mirrorBalls, showsAMirror}};
    case 3:
        return {{"03-blend", "picture: partial mirrors", halfMirrors, showsAMirror}};
    case 4:
        return {{"04-miss", "picture: the sky", underTheSky, showsTheSky}};
    case 5:
        return {{"05-glass", "picture: refraction", [](Random& r) { return glassBalls(r, FresnelModel::none); },
                 isRefracted},
                {"05-refract", "picture: total internal reflection", bubbles, isTotallyReflected}};
    case 6:
        return {
            {"06-split", "picture: glass", [](Random& r) { return glassBalls(r, FresnelModel::exact); }, showsGlass},
            {"06-schlick", "picture: glass after Schlick",
             [](Random& r) { return glassBalls(r, FresnelModel::schlick); }, showsGlass}};
    case 7:
        return {{"07-cap", "picture: the cap", [](Random& r) { return shallow(r, AtCap::black); }, isCapped},
                {"07-policy", "picture: what stands in",
                 [](Random& r) { return shallow(r, r.coin() ? AtCap::sky : AtCap::direct); }, isCapped}};
    case 8:
        return {{"08-phong", "picture: glossy balls", glossyBalls, isGlossy}};
    default:
        return {};
    }
}

} // namespace rt::grade
