#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report.h"
#include "units.h"

namespace rt::lesson10
{

namespace
{

std::string front(const SceneStudy& study, bool many)
{
    std::vector<const Row*> rows;
    for (const auto& row : study.rows)
        if (many ? row.manyFront : row.front) rows.push_back(&row);
    std::sort(rows.begin(), rows.end(), [](const Row* a, const Row* b) { return a->cpuSeconds < b->cpuSeconds; });
    std::string text = "| setting | ns a pixel | rays a pixel | PSNR |\n| --- | ---: | ---: | ---: |\n";
    for (const auto* row : rows)
        text += fmt::format("| {} | {:.0f} | {:.2f} | {} |\n", describe(row->setting), row->nsPerPixel(),
                            row->rays.perPixel, decibelText(many ? row->manyErrors.psnr : row->errors.psnr));
    return text;
}

/// The rows of a knob, in the order of the study, the baseline first.
std::string knob(const SceneStudy& study, const std::string& name)
{
    std::string text = "| setting | ns a pixel | of the baseline | rays a pixel | ns a ray | PSNR | largest error | "
                       "pixels off by 1/255 |\n"
                       "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const auto& row : study.rows)
        if (row.knob == name || row.knob == "baseline")
            text +=
                fmt::format("| {} | {:.0f} | {:.2f} | {:.2f} | {:.1f} | {} | {:.2g} | {} |\n", describe(row.setting),
                            row.nsPerPixel(), row.cpuSeconds / study.rows[0].cpuSeconds, row.rays.perPixel,
                            row.nsPerRay(), decibelText(row.errors.psnr), row.errors.maxAbsolute, row.errors.visible);
    return text;
}

/// Acne, leaks, wrong hits of the exhibits in all scenes.
std::string faults(const Report& report)
{
    std::vector<std::string> settings;
    for (const auto& study : report.studies)
        for (const auto& row : study.rows)
            if (isExhibit(row.setting) &&
                std::find(settings.begin(), settings.end(), describe(row.setting)) == settings.end())
                settings.push_back(describe(row.setting));
    std::string text = "| setting |", rule = "| --- |";
    for (const auto& study : report.studies)
    {
        text += fmt::format(" {} |", study.name);
        rule += " --- |";
    }
    text += "\n" + rule + "\n";
    for (const auto& setting : settings)
    {
        text += fmt::format("| {} |", setting);
        for (const auto& study : report.studies)
        {
            const auto row = std::find_if(study.rows.begin(), study.rows.end(),
                                          [&](const Row& r) { return describe(r.setting) == setting; });
            if (row == study.rows.end())
            {
                text += " |";
                continue;
            }
            const double pixels = double(row->pixels) / 100;
            text += fmt::format(" {}; {:.1f} / {:.1f} / {:.1f} |", decibelText(row->errors.psnr),
                                row->rays.acnePixels / pixels, row->rays.leakPixels / pixels,
                                row->rays.wrongFirst / pixels);
        }
        text += "\n";
    }
    return text;
}

std::string modelling(const Report& report)
{
    std::string text = "| scene | smallest lesson | same bits in 08 | time of 08 | worst step between | stack a level: "
                       "smallest, 08 |\n"
                       "| --- | --- | --- | --- | --- | --- |\n";
    for (const auto& scene : report.modelled)
    {
        if (scene.lessons.size() < 2) continue;
        const auto &first = scene.lessons.front(), &last = scene.lessons.back();
        std::string step;
        double most = 0;
        for (std::size_t i = 1; i < scene.lessons.size(); ++i)
        {
            const double ratio = scene.lessons[i].cpuSeconds / scene.lessons[i - 1].cpuSeconds;
            if (ratio <= most) continue;
            most = ratio;
            step = fmt::format("{:02} to {:02}: {:.2f}", scene.lessons[i - 1].lesson, scene.lessons[i].lesson, ratio);
        }
        const auto bytes = [](const Modelled& lesson) {
            return lesson.bytesALevel ? fmt::format("{} B", lesson.bytesALevel) : std::string("no recursion");
        };
        text += fmt::format("| `{}` | {:02} | {} | {:.2f} | {} | {}, {} |\n", scene.scene, first.lesson,
                            last.sameBits ? "yes" : "NO", last.ratio, step, bytes(first), bytes(last));
    }
    return text;
}

const SceneStudy* find(const Report& report, const std::string& name)
{
    for (const auto& study : report.studies)
        if (study.name == name) return &study;
    return nullptr;
}

} // namespace

std::string markdown(const Report& report)
{
    std::string text;
    const auto& [compiler, flags, cpu] = report.machine;
    if (!report.studies.empty())
    {
        const auto& first = report.studies.front();
        text += fmt::format("Measured on: {}; {}; flags `{}`. Pictures of {}x{} pixels, one thread, CPU time, minimum "
                            "of up to {} interleaved "
                            "runs{}.\n\n",
                            cpu, compiler, flags, first.scene.camera.width, first.scene.camera.height,
                            first.rows[0].rounds, report.quick ? "; a quick study" : "");
    }
    if (report.studies.size() > 1)
        text += "All scenes as one: the geometric mean of the times, the worst PSNR. The front:\n\n" +
                front(overAll(report.studies), false) + "\n";
    if (const auto* classic = find(report, "classic"))
    {
        text +=
            fmt::format("The classic scene, against the same samples (reference: long double, depth {}, cutoff {}). "
                        "The front:\n\n",
                        classic->reference.setting.depth, classic->reference.setting.cutoff) +
            front(*classic, false);
        text +=
            fmt::format("\nThe front against {} samples a pixel:\n\n", classic->manySamples) + front(*classic, true);
        for (const char* name : {"scalar type", "Fresnel", "depth", "cutoff"})
            text += fmt::format("\nKnob: {}.\n\n", name) + knob(*classic, name);
    }
    if (!report.studies.empty())
        text += "\nThe exhibits on all scenes: PSNR; pixels in percent with acne / leaks / a wrong first hit.\n\n" +
                faults(report);
    if (!report.modelled.empty())
        text += "\nModel only what a scene requires: lesson 08 against the smallest lesson that suffices.\n\n" +
                modelling(report);
    return text;
}

} // namespace rt::lesson10
