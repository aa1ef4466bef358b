// The study: settings, measured.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "metrics.h"
#include "setting.h"

namespace rt::lesson10
{

/// How much is measured.
struct Plan
{
    bool quick = false;
    int width = 320, height = 240;
    int rounds = 9;            ///< of interleaved timings; of each setting the minimum counts
    int mostSamples = 64;      ///< the last of the samples knob
    int manySamples = 1024;    ///< of the reference for samples
    double secondsAScene = 60; ///< timing ends early after this, but not before the second round

    static Plan quickOne();
};

struct Row
{
    std::string knob;
    Setting setting;
    double cpuSeconds = 0; ///< the minimum of all rounds
    int rounds = 0;
    Errors errors{};     ///< against the reference with the same samples
    Errors manyErrors{}; ///< against the reference with many samples
    Rays rays{};
    Image image{};
    std::size_t pixels = 0;
    bool front = false, manyFront = false; ///< on the Pareto front of time and PSNR, of either kind

    double nsPerPixel() const
    {
        return cpuSeconds * 1e9 / double(pixels);
    }
    double nsPerRay() const
    {
        return nsPerPixel() / rays.perPixel;
    }
};

/// The best that we can do: long double, cutoff 0, exact Fresnel, depth 64; see referenceSetting for trees that grow too large.
struct Reference
{
    Setting setting;
    Image image{}; ///< with the samples of the setting that is judged: 1
    std::vector<PixelFacts> facts;
};

struct SceneStudy
{
    SceneDescription scene; ///< as it was measured
    std::string name;       ///< "classic"
    Reference reference{};
    Image many{}; ///< with manySamples samples a pixel
    int manySamples = 0;
    std::vector<Row> rows{}; ///< the first is the baseline
};

/// Time units that progress is reported in; `share` in [0, 1].
using Progress = std::function<void(double share)>;

/// The scenes of this lesson, as files relative to the project.
std::vector<std::string> studyScenes();

/// Do the trees of the setting have at most `mostRays` rays a pixel on average, shadow rays not counted?
bool affordable(const SceneDescription& scene, const Setting& setting, int mostRays);

/// Long double, cutoff 0, depth 64; where that is not affordable, the smallest cutoff from 1e-9 to 1e-5 that is, and where none
/// is, the greatest depth.
Setting referenceSetting(const SceneDescription& scene, int mostRays);

/// Measures one scene. Empty if it was stopped.
std::optional<SceneStudy> study(const SceneDescription& scene, const Plan& plan, const Progress& progress,
                                const std::atomic<bool>& stop);

/// Marks the rows that no other dominates; accuracies that differ by less than 0.1 dB count as equal.
void markFronts(std::vector<Row>& rows);

/// All scenes as one: of each setting the geometric mean of the times and the worst PSNR. A scene that has no use for a
/// setting counts with its baseline.
SceneStudy overAll(const std::vector<SceneStudy>& studies);

/// The scene with its picture scaled to another size.
SceneDescription resized(SceneDescription scene, int width, int height);

} // namespace rt::lesson10
