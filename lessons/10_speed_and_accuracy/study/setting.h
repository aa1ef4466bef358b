// The knobs of the study: what trades speed for accuracy.
#pragma once

#include <string>
#include <vector>

#include "common/scene/scene_description.h"

namespace rt::lesson10
{

enum class Scalar
{
    floatOnly, ///< float throughout, the sphere too
    floating,  ///< float with the sphere in double: the course's --real float
    doubled,
    longDouble
};

enum class SphereFormula
{
    naive,
    qForm,
    haines
};

enum class LeavingPolicy
{
    anyPositive,
    fixedTMin,
    normalOffset,
    relativeOffset,
    exclusion
};

enum class GlassModel
{
    exact,
    schlick,
    schlickWrongAngle,
    none
};

/// The defaults are the study's baseline.
struct Setting
{
    Scalar scalar = Scalar::doubled;
    SphereFormula sphere = SphereFormula::haines;
    LeavingPolicy leaving = LeavingPolicy::exclusion;
    GlassModel glass = GlassModel::exact;
    int depth = 8;
    double cutoff = 1e-3;
    int spp = 1;

    bool operator==(const Setting&) const = default;
};

/// As the tables say it: "float, sphere in double", "t > 0", ...
const char* name(Scalar scalar);
const char* name(SphereFormula sphere);
const char* name(LeavingPolicy leaving);
const char* name(GlassModel glass);

/// What differs from the baseline, "float; depth 4; cutoff 0.01", or "baseline".
std::string describe(const Setting& setting);

/// The setting as options of the course's programs, "--real double --depth 4", and lines of the scene file, as far as they
/// have them; for settings without exhibits.
std::string asOptions(const Setting& setting);

/// One of the exhibits is in it: a choice that no program but this lesson's offers.
bool isExhibit(const Setting& setting);

/// A setting and the knob by which it differs from the baseline: one row of the study.
struct KnobSetting
{
    std::string knob;
    Setting setting;
};

/// Each knob alone, the poor formulas in double and in float, and a few mixtures that are worth recommending. Knobs that the
/// scene gives no use for (Fresnel without glass, leaving policies with triangles, ...) are left out.
std::vector<KnobSetting> knobsAlone(const SceneDescription& scene, int mostSamples);

/// The settings among which `trade --budget` and `--accuracy` choose: no exhibits.
std::vector<Setting> candidates(const SceneDescription& scene, int mostSamples);

/// The scene with the setting's depth, cutoff and Fresnel model.
SceneDescription withSetting(SceneDescription scene, const Setting& setting);

} // namespace rt::lesson10
