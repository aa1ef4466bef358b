#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/files/base64.h"
#include "common/files/markup.h"
#include "common/files/picture_file.h"
#include "pareto.h"
#include "report.h"
#include "units.h"

namespace rt::lesson10
{

namespace
{

/// |a - b| times `gain`: what the eye would overlook.
Image difference(const Image& a, const Image& b, double gain)
{
    Image out(a.width, a.height);
    for (std::size_t i = 0; i < out.pixels.size(); ++i)
        out.pixels[i] = isFinite(a.pixels[i]) ? gain * abs(a.pixels[i] - b.pixels[i]) : magenta;
    return out;
}

std::string figure(const Image& image, const std::string& caption)
{
    return fmt::format("<figure><img src=\"{}\" width=\"{}\" alt=\"\"><figcaption>{}</figcaption></figure>\n",
                       dataAddress(image), std::max(224, image.width), caption);
}

std::string counts(const Row& row)
{
    std::string text;
    const auto add = [&](int pixels, const char* what) {
        if (pixels > 0) text += fmt::format(", {} pixels {}", pixels, what);
    };
    add(row.rays.acnePixels, "with acne");
    add(row.rays.leakPixels, "with leaks");
    add(row.rays.wrongFirst, "see the wrong thing");
    add(row.errors.nonFinite, "are not finite");
    return text;
}

/// The rows that something else beats in both, the most wrong first, with the fastest that beats it.
std::string dominatedFigures(const SceneStudy& study)
{
    std::vector<const Row*> worse;
    for (const auto& row : study.rows)
        if (row.setting.spp == 1 && !row.front && row.errors.psnr < 80) worse.push_back(&row);
    std::sort(worse.begin(), worse.end(), [](const Row* a, const Row* b) { return a->errors.psnr < b->errors.psnr; });
    std::string text;
    int shown = 0;
    for (const auto* row : worse)
    {
        const Row* better = nullptr;
        for (const auto& other : study.rows)
            if (other.setting.spp == 1 && other.front &&
                dominates({other.cpuSeconds, other.errors.psnr}, {row->cpuSeconds, row->errors.psnr}) &&
                (!better || other.cpuSeconds < better->cpuSeconds))
                better = &other;
        if (!better || ++shown > 6) continue;
        text +=
            "<div class=\"pair\">" +
            figure(row->image, fmt::format("<b>{}</b>: {:.0f} ns a pixel, {}{}", escapedMarkup(describe(row->setting)),
                                           row->nsPerPixel(), decibelText(row->errors.psnr), counts(*row))) +
            figure(difference(row->image, study.reference.image, 4),
                   fmt::format("its error, 4 times; beaten by <b>{}</b>: {:.0f} ns, {}",
                               escapedMarkup(describe(better->setting)), better->nsPerPixel(),
                               decibelText(better->errors.psnr))) +
            "</div>\n";
    }
    return text.empty() ? "<p>None is both dominated and below 80 dB.</p>\n" : text;
}

std::string table(const SceneStudy& study)
{
    std::string text =
        "<table><tr><th>knob<th>setting<th>ns a pixel<th>rays a pixel<th>ns a ray<th>PSNR<th>largest error"
        "<th>&gt; 1/255<th>wrong first hit<th>wrong tree<th>acne<th>leaks<th>against samples<th>front</tr>\n";
    for (const auto& row : study.rows)
    {
        const bool same = row.setting.spp == 1;
        text +=
            fmt::format("<tr{}><td>{}<td "
                        "class=\"l\">{}<td>{:.0f}<td>{:.2f}<td>{:.1f}<td>{}<td>{}<td>{}<td>{}<td>{}<td>{}<td>{}<td>{:."
                        "1f} dB<td>{}</tr>\n",
                        row.front ? " class=\"front\"" : "", row.knob, escapedMarkup(describe(row.setting)),
                        row.nsPerPixel(), row.rays.perPixel, row.nsPerRay(), same ? decibelText(row.errors.psnr) : "",
                        same ? fmt::format("{:.2g}", row.errors.maxAbsolute) : "",
                        same ? fmt::format("{}", row.errors.visible) : "", row.rays.wrongFirst, row.rays.wrongShape,
                        row.rays.acnePixels, row.rays.leakPixels, row.manyErrors.psnr, row.front ? "yes" : "");
    }
    return text + "</table>\n";
}

std::string modelling(const Report& report)
{
    if (report.modelled.empty()) return "";
    std::string text = "<h2>Model only what a scene requires</h2>\n<p>The smallest lesson that suffices, and what the "
                       "same picture costs "
                       "with a later one: CPU time as a ratio, stack in bytes a level.</p>\n"
                       "<table><tr><th>scene<th>lesson<th>ms<th>ratio<th>bits<th>stack</tr>\n";
    for (const auto& scene : report.modelled)
        for (const auto& lesson : scene.lessons)
            text += fmt::format("<tr><td class=\"l\">{}<td>{:02}<td>{:.2f}<td>{:.3f}<td>{}<td>{}</tr>\n", scene.scene,
                                lesson.lesson, lesson.cpuSeconds * 1e3, lesson.ratio,
                                lesson.sameBits ? "same" : "DIFFERENT",
                                lesson.bytesALevel ? fmt::format("{}", lesson.bytesALevel) : "");
    return text + "</table>\n";
}

} // namespace

std::string dataAddress(const Image& image)
{
    return "data:image/png;base64," + base64(pngBytes(image));
}

std::string html(const Report& report)
{
    const auto& [compiler, flags, cpu] = report.machine;
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>raytree: speed and "
        "accuracy</title>\n<style>\n"
        "body {{ font: 15px/1.45 sans-serif; max-width: 1180px; margin: 2em auto; padding: 0 1em; color: #222; }}\n"
        "table {{ border-collapse: collapse; font-size: 13px; }} td, th {{ padding: 2px 8px; text-align: right; "
        "border-bottom: 1px solid #ddd; }}\n"
        "td.l {{ text-align: left; }} tr.front td {{ background: #eef6ee; }} figure {{ display: inline-block; margin: "
        "0 8px 12px 0; width: 320px; vertical-align: top; }}\n"
        "figure img {{ image-rendering: pixelated; max-width: 100%; }} figcaption {{ font-size: 13px; }} .pair {{ "
        "display: inline-block; margin-right: 1em; }}\n"
        "</style></head><body>\n<h1>What an approximation costs and buys</h1>\n"
        "<p>{}. {}, flags {}. Times are CPU time of one thread, the minimum of interleaved runs{}. "
        "PSNR is of linear values, white is 1; the reference has the same samples and is computed in long double. "
        "A setting is on the front if no other is both as fast and as accurate.</p>\n",
        escapedMarkup(cpu), escapedMarkup(compiler), escapedMarkup(flags),
        report.quick ? "; a quick study: small pictures, few runs" : "");
    if (report.studies.size() > 1)
    {
        const auto all = overAll(report.studies);
        text += "<h2>All scenes as one</h2>\n<p>The geometric mean of the times, and the worst PSNR: a setting must "
                "hold everywhere.</p>\n" +
                svg(all, false) + svg(all, true);
    }
    for (const auto& study : report.studies)
    {
        text += fmt::format("<h2>{}</h2>\n<p>{}x{} pixels; reference: long double, depth {}, cutoff {}.</p>\n",
                            escapedMarkup(study.name), study.scene.camera.width, study.scene.camera.height,
                            study.reference.setting.depth, study.reference.setting.cutoff);
        text += figure(study.reference.image, "the reference") +
                figure(study.many,
                       fmt::format("{} samples a pixel (double, depth at most 16, cutoff 0.001)", study.manySamples));
        text += "<h3>Against the same samples: what arithmetic and policies cost</h3>\n" + svg(study, false);
        text += fmt::format("<h3>Against {} samples: what one sees</h3>\n", study.manySamples) + svg(study, true);
        text += "<h3>Dominated: something else is faster and more accurate</h3>\n" + dominatedFigures(study);
        text += "<details><summary>All settings</summary>\n" + table(study) + "</details>\n";
    }
    return text + modelling(report) + "</body></html>\n";
}

} // namespace rt::lesson10
