// Lesson 06: how much is reflected, exact and after Schlick, and both rays.
#include "tests/grade/questions/media.h"
#include "tests/grade/questions/question.h"

namespace rt::grade
{

namespace
{

enum class Model
{
    exact,
    schlick
};

Question askShare(Model model, double cos1, double n1, double n2)
{
    const auto ask = [=](const Candidate& candidate) {
        const auto& which = model == Model::exact ? candidate.tracer.fresnel : candidate.tracer.schlick;
        return Answer{{which(cos1, n1, n2)}, {}};
    };
    return {fmt::format("{} for cos1 = {:.6g}, n1 = {:.6g}, n2 = {:.6g}", model == Model::exact ? "Fr" : "Schlick's Fr",
                        cos1, n1, n2),
            Shape::number,
            forValues,
            ask,
            {}};
}

/// The denser medium's index, as a multiple of the other's, at least.
constexpr double leastRatio = 1.2;

template <Model model>
Question into(Random& random, int)
{
    const auto m = media(random, leastRatio);
    return askShare(model, random.in(0.1, 0.98), m.thin, m.dense);
}
template <Model model>
Question outOf(Random& random, int)
{
    const auto m = media(random, leastRatio);
    return askShare(model, cosineFor(random.in(0.5, 0.95), m.dense, m.thin), m.dense, m.thin);
}
template <Model model>
Question aroundCritical(Random& random, int index)
{
    const auto m = media(random, leastRatio);
    const double sin2 = index % 2 ? random.in(0.8, 0.96) : random.in(1.04, std::max(1.05, 0.99 * m.dense / m.thin));
    return askShare(model, cosineFor(sin2, m.dense, m.thin), m.dense, m.thin);
}
template <Model model>
Question grazing(Random& random, int)
{
    const auto m = media(random, leastRatio);
    return askShare(model, random.in(0.01, 0.1), m.thin, m.dense);
}
/// Every fourth along the surface of equal media, where the equations are 0/0.
template <Model model>
Question equalMedia(Random& random, int index)
{
    const double n = random.in(1, 2);
    if (index % 4 == 0) return askShare(model, 0, n, n);
    if (index % 4 == 1) return askShare(model, random.in(0.05, 0.4), n, n);
    return askShare(model, random.in(0.1, 0.4), n, n * random.in(1.1, 1.2));
}
Question aroundBrewster(Random& random, int index)
{
    const auto m = media(random, leastRatio);
    const double n1 = index % 2 ? m.thin : m.dense, n2 = index % 2 ? m.dense : m.thin;
    const double angle = std::atan(n2 / n1) + random.in(-0.02, 0.02);
    return askShare(Model::exact, std::cos(angle), n1, n2);
}

struct Ball
{
    Build build;
    V eye, D;
};

Ball ball(Random& random, double inside, double outside, double aside, int depth, const V& color = V(1))
{
    Ball b;
    b.build.sky(random.color()).depth(depth);
    b.build.scene.sky.zenith = 2.0 * random.color();
    b.build.material({.name = "glass", .color = color, .ior = inside, .iorOutside = outside});
    const V center = random.vector(-2, 2), towards = random.direction();
    const double radius = random.in(0.5, 2);
    b.build.sphere(center, radius);
    b.eye = center - random.in(2, 4) * radius * towards + aside * radius * random.across(towards);
    b.D = towards;
    return b;
}

Question shares(Random& random, int)
{
    const auto m = media(random, leastRatio);
    const auto b = ball(random, m.dense, m.thin, random.in(0.3, 0.9), 1);
    return askTree("a glass ball, max_depth 1", b.build.scene, b.eye, b.D);
}

Question deeper(Random& random, int index)
{
    const auto m = media(random, leastRatio);
    const auto b = ball(random, m.dense, m.thin, random.in(0.3, 0.85), index % 4, V(random.in(0.7, 1)));
    return askTree(fmt::format("a glass ball, max_depth {}", index % 4), b.build.scene, b.eye, b.D);
}

/// All that comes in goes out: under a white sky a ball of clear glass is all but invisible.
Question furnace(Random& random, int)
{
    const auto m = media(random, leastRatio);
    auto b = ball(random, m.dense, m.thin, random.in(0.2, 0.92), random.whole(2, 5));
    b.build.scene.sky.color = V(1);
    b.build.scene.sky.zenith.reset();
    return askColor("a glass ball under a white sky", b.build.scene, b.eye, b.D);
}

Question colours(Random& random, int)
{
    const auto m = media(random, leastRatio);
    const auto b = ball(random, m.dense, m.thin, random.in(0.2, 0.85), 3, random.color());
    return askColor("a coloured glass ball", b.build.scene, b.eye, b.D);
}

Question bubble(Random& random, int index)
{
    const auto m = media(random, leastRatio);
    const double aside =
        m.thin / m.dense * (index % 2 ? random.in(0.5, 0.95) : random.in(1.05, 0.97 * m.dense / m.thin));
    const auto b = ball(random, m.thin, m.dense, aside, 2);
    return askTree("a bubble in glass, max_depth 2", b.build.scene, b.eye, b.D);
}

Question modelOfTheScene(Random& random, int index)
{
    const auto m = media(random, leastRatio);
    auto b = ball(random, m.dense, m.thin, random.in(0.85, 0.95), 1);
    const FresnelModel model = index % 3 == 0   ? FresnelModel::none
                               : index % 3 == 1 ? FresnelModel::schlick
                                                : FresnelModel::exact;
    b.build.fresnel(model);
    return askTree(fmt::format("a glass ball, fresnel = \"{}\"", fresnelWords[std::size_t(model)]), b.build.scene,
                   b.eye, b.D);
}

} // namespace

std::vector<Criterion> fresnelCriteria()
{
    return {
        {"06-split", "the two shares", shares},
        {"06-split", "the tree branches to the cap", deeper},
        {"06-split", "no energy is lost", furnace},
        {"06-split", "colours", colours},
        {"06-split", "total internal reflection and not", bubble},
        {"06-split", "the model that the scene names", modelOfTheScene},
        {"06-fresnel", "into the denser medium", into<Model::exact>},
        {"06-fresnel", "out of the denser medium", outOf<Model::exact>},
        {"06-fresnel", "around the critical angle", aroundCritical<Model::exact>},
        {"06-fresnel", "around Brewster's angle", aroundBrewster},
        {"06-fresnel", "grazing", grazing<Model::exact>},
        {"06-fresnel", "equal and similar media", equalMedia<Model::exact>},
        {"06-schlick", "into the denser medium", into<Model::schlick>},
        {"06-schlick", "out of the denser medium", outOf<Model::schlick>},
        {"06-schlick", "around the critical angle", aroundCritical<Model::schlick>},
        {"06-schlick", "grazing", grazing<Model::schlick>},
        {"06-schlick", "equal and similar media", equalMedia<Model::schlick>},
    };
}

} // namespace rt::grade
