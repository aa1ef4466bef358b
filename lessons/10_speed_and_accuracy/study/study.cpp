#include "study.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <thread>

#include "pareto.h"
#include "workers.h"

namespace rt::lesson10
{

Plan Plan::quickOne()
{
    return {.quick = true,
            .width = 112,
            .height = 84,
            .rounds = 5,
            .mostSamples = 16,
            .manySamples = 64,
            .secondsAScene = 3};
}

std::vector<std::string> studyScenes()
{
    std::vector<std::string> files;
    for (const char* name : {"classic", "planet", "far_camera", "tiny", "thin_shell", "four_mirrors", "index_matched"})
        files.push_back(std::string("lessons/10_speed_and_accuracy/scenes/") + name + ".toml");
    return files;
}

SceneDescription resized(SceneDescription scene, int width, int height)
{
    auto& camera = scene.camera;
    if (camera.pixelX >= 0) camera.pixelX = int(std::int64_t(camera.pixelX) * width / camera.width);
    if (camera.pixelY >= 0) camera.pixelY = int(std::int64_t(camera.pixelY) * height / camera.height);
    camera.width = width;
    camera.height = height;
    return scene;
}

bool affordable(const SceneDescription& scene, const Setting& setting, int mostRays)
{
    // On a coarse picture, in double, without samples: the trees are the same but for a few pixels.
    const std::atomic<bool> go = false;
    Setting coarse = setting;
    coarse.spp = 1;
    if (coarse.scalar == Scalar::longDouble) coarse.scalar = Scalar::doubled;
    return prepare(resized(scene, 32, 24), coarse)->inspect(1, false, 32 * 24 * std::int64_t(mostRays), go).has_value();
}

Setting referenceSetting(const SceneDescription& scene, int mostRays)
{
    Setting setting{.scalar = Scalar::longDouble, .depth = 64, .cutoff = 0};
    for (const double cutoff : {0.0, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5})
    {
        setting.cutoff = cutoff;
        if (affordable(scene, setting, mostRays)) return setting;
    }
    while (setting.depth > 1 && !affordable(scene, setting, mostRays)) setting.depth /= 2;
    return setting;
}

void markFronts(std::vector<Row>& rows)
{
    // What no table shows is no gain: less than a tenth of a dB.
    const auto rounded = [](double decibels) { return std::round(decibels * 10) / 10; };
    std::vector<Cost> same, many;
    for (auto& row : rows)
    {
        row.front = row.manyFront = false;
        // With more samples the picture is another one: not comparable with the reference of one.
        same.push_back({row.cpuSeconds,
                        row.setting.spp == 1 ? rounded(row.errors.psnr) : std::numeric_limits<double>::quiet_NaN()});
        many.push_back({row.cpuSeconds, rounded(row.manyErrors.psnr)});
    }
    for (const auto i : paretoFront(same)) rows[i].front = true;
    for (const auto i : paretoFront(many)) rows[i].manyFront = true;
}

SceneStudy overAll(const std::vector<SceneStudy>& studies)
{
    SceneStudy all{.scene = {}, .name = "all"};
    all.manySamples = studies.empty() ? 0 : studies[0].manySamples;
    const auto find = [](const SceneStudy& one, const Setting& setting) {
        return std::find_if(one.rows.begin(), one.rows.end(), [&](const Row& r) { return r.setting == setting; });
    };
    const auto add = [&](const Row& like) {
        Row row{.knob = like.knob, .setting = like.setting};
        row.errors.psnr = row.manyErrors.psnr = infinity<double>;
        double logarithms = 0, rays = 0;
        for (const auto& one : studies)
        {
            const auto own = find(one, like.setting);
            const Row& its = own == one.rows.end() ? one.rows[0] : *own;
            logarithms += std::log(its.nsPerPixel());
            rays += std::log(its.rays.perPixel);
            row.errors.psnr = std::min(row.errors.psnr, its.errors.psnr);
            row.manyErrors.psnr = std::min(row.manyErrors.psnr, its.manyErrors.psnr);
        }
        const double scenes = double(studies.size());
        row.pixels = 1;
        row.cpuSeconds = std::exp(logarithms / scenes) * 1e-9;
        row.rays.perPixel = std::exp(rays / scenes);
        all.rows.push_back(row);
    };
    for (const auto& one : studies)
        for (const auto& row : one.rows)
            if (find(all, row.setting) == all.rows.end()) add(row);
    markFronts(all.rows);
    return all;
}

std::optional<SceneStudy> study(const SceneDescription& scene, const Plan& plan, const Progress& progress,
                                const std::atomic<bool>& stop)
{
    using Clock = std::chrono::steady_clock;
    SceneStudy result{.scene = resized(scene, plan.width, plan.height),
                      .name = std::filesystem::path(scene.file).stem().string(),
                      .manySamples = plan.manySamples};
    const auto& measured = result.scene;
    const auto report = [&](double share) {
        if (progress) progress(share);
    };
    result.reference.setting = referenceSetting(measured, plan.quick ? 300 : 1000);
    const auto best = prepare(measured, result.reference.setting);
    const RenderOptions all{.progress = {}, .stop = &stop};
    result.reference.image = best->render(all);
    result.reference.facts = *best->inspect(1, false, std::numeric_limits<std::int64_t>::max(), stop);
    // Beside the aliasing of one sample, rounding and depths beyond 16 are nothing: double will do.
    const Setting many{.depth = std::min(16, result.reference.setting.depth), .spp = plan.manySamples};
    result.many = prepare(measured, many)->render(all);
    if (stop) return std::nullopt;
    report(0.3);

    std::vector<std::unique_ptr<Subject>> subjects;
    for (auto& [knob, setting] : knobsAlone(measured, plan.mostSamples))
    {
        // What is deeper than the reference cannot be judged by it; what has hundreds of rays a pixel nobody wants to wait for.
        const bool judged = setting.depth <= std::max(8, result.reference.setting.depth);
        if (!result.rows.empty() && !(judged && affordable(measured, setting, 200))) continue;
        subjects.push_back(prepare(measured, setting));
        result.rows.push_back({.knob = knob, .setting = setting, .cpuSeconds = infinity<double>});
    }
    // All settings in turn, again and again, so that what disturbs the machine disturbs all of them alike.
    const auto start = Clock::now();
    const auto spent = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    for (int round = 0; round < plan.rounds && (round < 2 || spent() < plan.secondsAScene); ++round)
    {
        for (std::size_t i = 0; i < subjects.size() && !stop; ++i)
        {
            auto& row = result.rows[i];
            if (round >= 2 && row.setting.spp >= 8) continue; // a long pass averages by itself
            Pass pass = subjects[i]->timedPass(1, stop);
            row.cpuSeconds = std::min(row.cpuSeconds, pass.cpuSeconds);
            row.image = std::move(pass.image);
            row.pixels = row.image.pixels.size();
            ++row.rounds;
        }
        report(0.3 + 0.5 * (round + 1) / plan.rounds);
    }
    if (stop) return std::nullopt;

    inParallel(subjects.size(), [&](std::size_t i) {
        auto& row = result.rows[i];
        const auto facts = subjects[i]->inspect(1, true, std::numeric_limits<std::int64_t>::max(), stop);
        if (stop) return;
        row.rays = raysAgainst(*facts, result.reference.facts);
        row.errors = errorsAgainst(row.image, result.reference.image);
        row.manyErrors = errorsAgainst(row.image, result.many);
    });
    if (stop) return std::nullopt;
    markFronts(result.rows);
    report(1);
    return result;
}

} // namespace rt::lesson10
