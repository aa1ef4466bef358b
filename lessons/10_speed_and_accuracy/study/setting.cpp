#include "setting.h"

#include <algorithm>

#include <fmt/format.h>

namespace rt::lesson10
{

namespace
{

bool has(const SceneDescription& scene, bool (*property)(const Material<double>&))
{
    return std::any_of(scene.materials.begin(), scene.materials.end(), property);
}

bool hasGlass(const SceneDescription& scene)
{
    return has(scene, [](const Material<double>& mat) { return mat.isDielectric(); });
}

/// Do rays spawn others at all?
bool branches(const SceneDescription& scene)
{
    return has(scene, [](const Material<double>& mat) { return mat.isDielectric() || mat.mirror > 0; });
}

/// The models that the scene leaves open: glass that transmits everything by its file stays so.
std::vector<GlassModel> glassModels(const SceneDescription& scene)
{
    if (!hasGlass(scene) || scene.trace.fresnel == FresnelModel::none) return {GlassModel::exact};
    return {GlassModel::exact, GlassModel::schlick, GlassModel::schlickWrongAngle, GlassModel::none};
}

} // namespace

const char* name(Scalar scalar)
{
    constexpr const char* names[] = {"float", "float, sphere in double", "double", "long double"};
    return names[int(scalar)];
}

const char* name(SphereFormula sphere)
{
    constexpr const char* names[] = {"naive b² - 4ac", "q-form", "Haines"};
    return names[int(sphere)];
}

const char* name(LeavingPolicy leaving)
{
    constexpr const char* names[] = {"t > 0", "t > 1e-4", "offset 1e-4", "relative offset 1e-4", "exclusion"};
    return names[int(leaving)];
}

const char* name(GlassModel glass)
{
    constexpr const char* names[] = {"exact Fresnel", "Schlick", "Schlick, wrong angle", "no Fresnel"};
    return names[int(glass)];
}

std::string describe(const Setting& setting)
{
    const Setting baseline;
    std::string text;
    const auto add = [&](bool differs, const std::string& what) {
        if (differs) text += (text.empty() ? "" : "; ") + what;
    };
    add(setting.scalar != baseline.scalar, name(setting.scalar));
    add(setting.sphere != baseline.sphere, name(setting.sphere));
    add(setting.leaving != baseline.leaving, name(setting.leaving));
    add(setting.glass != baseline.glass, name(setting.glass));
    add(setting.depth != baseline.depth, fmt::format("depth {}", setting.depth));
    add(setting.cutoff != baseline.cutoff, fmt::format("cutoff {}", setting.cutoff));
    add(setting.spp != baseline.spp, fmt::format("{} samples", setting.spp));
    return text.empty() ? "baseline" : text;
}

std::string asOptions(const Setting& setting)
{
    constexpr const char* reals[] = {"float", "float", "double", "long-double"};
    std::string text =
        fmt::format("--real {} --depth {} --spp {}", reals[int(setting.scalar)], setting.depth, setting.spp);
    if (setting.glass != GlassModel::exact)
        text += fmt::format(" --fresnel {}", setting.glass == GlassModel::none ? "none" : "schlick");
    return text + fmt::format(", and cutoff = {} in the scene's [trace]", setting.cutoff);
}

bool isExhibit(const Setting& setting)
{
    return setting.scalar == Scalar::floatOnly || setting.sphere != SphereFormula::haines ||
           setting.leaving != LeavingPolicy::exclusion || setting.glass == GlassModel::schlickWrongAngle;
}

std::vector<KnobSetting> knobsAlone(const SceneDescription& scene, int mostSamples)
{
    std::vector<KnobSetting> all{{"baseline", {}}};
    const auto add = [&](const char* knob, const Setting& setting) {
        const auto same = [&](const KnobSetting& other) { return other.setting == setting; };
        if (std::none_of(all.begin(), all.end(), same)) all.push_back({knob, setting});
    };
    for (const auto scalar : {Scalar::floatOnly, Scalar::floating, Scalar::doubled, Scalar::longDouble})
        add("scalar type", {.scalar = scalar});
    if (!scene.spheres.empty())
        for (const auto scalar : {Scalar::floatOnly, Scalar::doubled})
            for (const auto sphere : {SphereFormula::naive, SphereFormula::qForm})
                add("sphere formula", {.scalar = scalar, .sphere = sphere});
    // The exhibits know spheres and planes: a hit on a triangle has no t_min.
    if (scene.triangles.empty() && scene.meshes.empty())
        for (const auto scalar : {Scalar::floating, Scalar::doubled})
            for (const auto leaving : {LeavingPolicy::anyPositive, LeavingPolicy::fixedTMin,
                                       LeavingPolicy::normalOffset, LeavingPolicy::relativeOffset})
                add("self-hit policy", {.scalar = scalar, .leaving = leaving});
    for (const auto glass : glassModels(scene)) add("Fresnel", {.glass = glass});
    if (branches(scene))
    {
        for (const int depth : {1, 2, 3, 4, 6, 16, 32, 64}) add("depth", {.depth = depth});
        for (const double cutoff : {0.0, 1e-4, 0.004, 1e-2}) add("cutoff", {.cutoff = cutoff});
        for (const int depth : {2, 4, 6}) add("mixture", {.scalar = Scalar::floating, .depth = depth, .cutoff = 1e-2});
        add("mixture", {.depth = 64, .cutoff = 1e-4});
        add("mixture", {.depth = 16, .cutoff = 0});
    }
    for (int spp = 2; spp <= mostSamples; spp *= 2) add("samples", {.spp = spp});
    return all;
}

std::vector<Setting> candidates(const SceneDescription& scene, int mostSamples)
{
    std::vector<Setting> all;
    std::vector<int> depths{0};
    std::vector<double> cutoffs{0};
    if (branches(scene))
    {
        depths = {0, 1, 2, 3, 4, 6, 8, 16, 32, 64};
        cutoffs = {0, 1e-4, 1e-3, 1e-2};
    }
    for (const auto scalar : {Scalar::floating, Scalar::doubled})
        for (const auto glass : glassModels(scene))
            for (const int depth : depths)
                for (const double cutoff : cutoffs)
                    for (int spp = 1; spp <= mostSamples; spp *= 2)
                    {
                        const bool sampled = spp > 1; // beside aliasing nothing else shows: fewer choices there
                        if (sampled &&
                            (scalar != Scalar::doubled || cutoff != cutoffs.back() || glass != GlassModel::exact))
                            continue;
                        if (glass == GlassModel::schlickWrongAngle || glass == GlassModel::schlick) continue;
                        all.push_back({.scalar = scalar, .glass = glass, .depth = depth, .cutoff = cutoff, .spp = spp});
                    }
    return all;
}

SceneDescription withSetting(SceneDescription scene, const Setting& setting)
{
    scene.trace.maxDepth = setting.depth;
    scene.trace.cutoff = setting.cutoff;
    if (setting.glass == GlassModel::none) scene.trace.fresnel = FresnelModel::none;
    if (setting.glass == GlassModel::schlick) scene.trace.fresnel = FresnelModel::schlick;
    if (setting.glass == GlassModel::exact && scene.trace.fresnel == FresnelModel::schlick)
        scene.trace.fresnel = FresnelModel::exact;
    return scene;
}

} // namespace rt::lesson10
