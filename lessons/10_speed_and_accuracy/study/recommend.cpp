#include "recommend.h"

#include <algorithm>

#include <fmt/format.h>

#include "units.h"
#include "workers.h"

namespace rt::lesson10
{

namespace
{

/// A candidate, and what the sampled rows said about it.
struct Measured
{
    Setting setting;
    std::unique_ptr<Subject> subject;
    Image rows;
    double seconds = infinity<double>; ///< for the whole picture, predicted
    double decibels = 0;               ///< of the rows
    bool verified = false;             ///< `decibels` is of the whole picture
    bool tried = false;
};

Image everyRow(const Image& image, int stride)
{
    Image rows(image.width, (image.height + stride - 1) / stride);
    for (int y = 0; y < rows.height; ++y)
        for (int x = 0; x < rows.width; ++x) rows.at(x, y) = image.at(x, y * stride);
    return rows;
}

/// The most accurate within the time, or the fastest that is accurate enough, of those that were not tried. If none is, the
/// nearest to it; null if all were tried.
Measured* best(std::vector<Measured>& all, const Wish& wish)
{
    // Times are predicted to a few percent: less is asked for than what is allowed.
    const double seconds = 0.9 * wish.seconds.value_or(infinity<double>), decibels = wish.decibels.value_or(0);
    Measured* chosen = nullptr;
    const auto fits = [&](const Measured& m) { return m.seconds <= seconds && m.decibels >= decibels; };
    const auto better = [&](const Measured& a, const Measured& b) {
        if (fits(a) != fits(b)) return fits(a);
        if (!fits(a) && (a.seconds <= seconds) != (b.seconds <= seconds)) return a.seconds <= seconds;
        const bool byTime = wish.decibels && (fits(a) || a.decibels >= decibels) && (fits(b) || b.decibels >= decibels);
        if (byTime || (!(a.seconds <= seconds) && !wish.decibels)) return a.seconds < b.seconds;
        return a.decibels != b.decibels ? a.decibels > b.decibels : a.seconds < b.seconds;
    };
    for (auto& m : all)
        if (!m.tried && (!chosen || better(m, *chosen))) chosen = &m;
    return chosen;
}

} // namespace

std::optional<Recommendation> recommend(const SceneDescription& scene, const Wish& wish,
                                        const std::function<void(const std::string&)>& say,
                                        const std::atomic<bool>& stop)
{
    Recommendation result;
    const int width = scene.camera.width, height = scene.camera.height;
    // About 5000 pixels of whole rows, spread over the picture.
    const int rows = std::clamp(5000 / width, 4, height);
    result.stride = std::max(1, height / rows);

    result.reference = referenceSetting(scene, 500);
    const int deepest = std::max(8, result.reference.depth);
    if (wish.many) result.reference = {.depth = std::min(16, result.reference.depth), .spp = wish.manySamples};
    say(fmt::format("the reference: {}, depth {}, cutoff {}, {} sample{} a pixel", name(result.reference.scalar),
                    result.reference.depth, result.reference.cutoff, result.reference.spp,
                    result.reference.spp > 1 ? "s" : ""));
    const Image reference = prepare(scene, result.reference)->render({.progress = {}, .stop = &stop});
    if (stop) return std::nullopt;
    const Image referenceRows = everyRow(reference, result.stride);

    std::vector<Measured> all;
    for (const auto& setting : candidates(scene, wish.many ? 64 : 1))
        if (setting.depth <= deepest && affordable(scene, setting, 200))
            all.push_back({.setting = setting, .subject = prepare(scene, setting), .rows = {}});
    result.measured = int(all.size());
    const double pixelsARow = double(height) / double((height + result.stride - 1) / result.stride);
    for (int round = 0; round < 4; ++round)
        for (auto& m : all)
        {
            if (stop) return std::nullopt;
            // From the second round on only those that may still be chosen are worth another look.
            if (round > 0 && wish.seconds && m.seconds > 2 * *wish.seconds) continue;
            if (round > 0 && wish.decibels && m.decibels < *wish.decibels) continue;
            Pass pass = m.subject->timedPass(result.stride, stop);
            m.seconds = std::min(m.seconds, pass.cpuSeconds * pixelsARow);
            if (round == 0) m.decibels = errorsAgainst(pass.image, referenceRows).psnr;
        }
    say(fmt::format("{} settings measured on every {}th row, of each the fastest of up to 4 interleaved runs",
                    result.measured, result.stride));

    const double limit = wish.seconds.value_or(infinity<double>);
    for (int attempt = 0; attempt < 4 && !result.kept(); ++attempt)
    {
        // Rare pixels decide about accuracy, and rows miss them: whoever is to be chosen is rendered as a whole first.
        Measured* chosen = best(all, wish);
        while (chosen && !chosen->verified && !stop)
        {
            chosen->decibels = errorsAgainst(chosen->subject->render({.progress = {}, .stop = &stop}), reference).psnr;
            chosen->verified = true;
            chosen = best(all, wish);
        }
        if (stop) return std::nullopt;
        if (!chosen) break;
        chosen->tried = true;
        Tried tried{chosen->setting, chosen->seconds, chosen->decibels, infinity<double>, 0, false};
        say(fmt::format("{}: {} and {} expected", describe(tried.setting), timeText(tried.predictedSeconds),
                        decibelText(tried.predictedDecibels)));
        int run = 0;
        do // a first run that was disturbed has a second chance
        {
            Pass pass = chosen->subject->timedPass(1, stop);
            if (stop) return std::nullopt;
            tried.seconds = std::min(tried.seconds, pass.cpuSeconds);
            result.image = std::move(pass.image);
        } while (++run < 2 && tried.seconds > limit);
        tried.decibels = errorsAgainst(result.image, reference).psnr;
        tried.kept = tried.seconds <= limit && tried.decibels >= wish.decibels.value_or(0);
        say(fmt::format("  rendered, {}x{} pixels: {} and {}: the promise is {}", width, height,
                        timeText(tried.seconds), decibelText(tried.decibels), tried.kept ? "kept" : "not kept"));
        result.tried.push_back(tried);
    }
    return result;
}

} // namespace rt::lesson10
