#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "common/files/markup.h"
#include "report.h"
#include "units.h"

namespace rt::lesson10
{

namespace
{

// Okabe and Ito's colours, which differ for all eyes.
const std::map<std::string, const char*> knobColors{
    {"baseline", "#000000"},        {"scalar type", "#0072b2"}, {"sphere formula", "#d55e00"},
    {"self-hit policy", "#cc79a7"}, {"Fresnel", "#009e73"},     {"depth", "#e69f00"},
    {"cutoff", "#56b4e9"},          {"samples", "#999999"},     {"mixture", "#6a3d9a"}};

struct Point2
{
    double x, y;
};

} // namespace

std::string svg(const SceneStudy& study, bool many)
{
    constexpr double left = 62, right = 470, top = 44, bottom = 330, sameBits = 22;
    std::vector<const Row*> rows;
    for (const auto& row : study.rows)
        if (many || row.setting.spp == 1) rows.push_back(&row);
    const auto accuracy = [&](const Row& row) { return many ? row.manyErrors.psnr : row.errors.psnr; };

    double fastest = infinity<double>, slowest = 0, worst = infinity<double>, best = 0;
    for (const auto* row : rows)
    {
        fastest = std::min(fastest, row->nsPerPixel());
        slowest = std::max(slowest, row->nsPerPixel());
        worst = std::min(worst, accuracy(*row));
        if (std::isfinite(accuracy(*row))) best = std::max(best, accuracy(*row));
    }
    fastest *= 0.93;
    slowest *= 1.07;
    const double step = best - worst > 60 ? 20 : best - worst > 20 ? 10 : 5;
    worst = std::floor(worst / step) * step;
    best = std::max(worst + step, std::ceil(best / step) * step);
    const auto place = [&](double ns, double dB) {
        return Point2{left + (right - left) * std::log(ns / fastest) / std::log(slowest / fastest),
                      std::isinf(dB) ? sameBits : bottom - (bottom - top) * (dB - worst) / (best - worst)};
    };

    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 860 384\" width=\"860\" height=\"384\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"860\" height=\"384\" fill=\"#ffffff\"/>\n"
        "<text x=\"{}\" y=\"376\" text-anchor=\"middle\">ns a pixel, CPU time of one thread (logarithmic)</text>\n"
        "<text transform=\"translate(14 {}) rotate(-90)\" text-anchor=\"middle\">PSNR, dB{}</text>\n",
        (left + right) / 2, (top + bottom) / 2, many ? fmt::format(", against {} samples", study.manySamples) : "");
    for (double dB = worst; dB <= best; dB += step)
    {
        const double y = place(1, dB).y;
        text += fmt::format(
            "<path d=\"M{} {:.1f}H{}\" stroke=\"#dddddd\"/><text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
            left, y, right, left - 6, y + 4, dB);
    }
    if (std::any_of(rows.begin(), rows.end(), [&](const Row* row) { return std::isinf(accuracy(*row)); }))
        text +=
            fmt::format("<path d=\"M{} {}H{}\" stroke=\"#dddddd\" stroke-dasharray=\"4 3\"/><text x=\"{}\" y=\"{}\" "
                        "text-anchor=\"end\">same bits</text>\n",
                        left, sameBits, right, left - 2, sameBits + 4);
    // 1, 2 and 5 times powers of ten; more of them where the range is short.
    const bool fine = slowest / fastest < 4;
    for (double decade = 1; decade < slowest; decade *= 10)
        for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0})
        {
            const double ns = decade * factor;
            if (ns < fastest || ns > slowest || (!fine && factor != 1 && factor != 2 && factor != 5)) continue;
            const double x = place(ns, best).x;
            text += fmt::format("<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#eeeeee\"/><text x=\"{0:.1f}\" y=\"{3}\" "
                                "text-anchor=\"middle\">{4:.0f}</text>\n",
                                x, top, bottom, bottom + 18, ns);
        }

    std::vector<const Row*> front;
    for (const auto* row : rows)
        if (many ? row->manyFront : row->front) front.push_back(row);
    std::sort(front.begin(), front.end(), [](const Row* a, const Row* b) { return a->cpuSeconds < b->cpuSeconds; });
    std::string stairs;
    for (const auto* row : front)
    {
        const auto [x, y] = place(row->nsPerPixel(), accuracy(*row));
        stairs += stairs.empty() ? fmt::format("M{:.1f} {:.1f}", x, y) : fmt::format("H{:.1f}V{:.1f}", x, y);
    }
    text += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#000000\" stroke-width=\"1.2\"/>\n", stairs);

    std::map<std::string, bool> shown;
    for (const auto* row : rows)
    {
        const auto [x, y] = place(row->nsPerPixel(), accuracy(*row));
        const bool chosen = many ? row->manyFront : row->front;
        shown[row->knob] = true;
        text += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" fill-opacity=\"{}\"><title>{}: "
                            "{:.0f} ns a pixel, "
                            "{}</title></circle>\n",
                            x, y, chosen ? 5 : 3.5, knobColors.at(row->knob), chosen ? 1 : 0.55,
                            escapedMarkup(describe(row->setting)), row->nsPerPixel(), decibelText(accuracy(*row)));
    }
    for (std::size_t i = 0; i < front.size(); ++i)
    {
        const auto [x, y] = place(front[i]->nsPerPixel(), accuracy(*front[i]));
        text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" text-anchor=\"end\">{}</text>\n", x - 6,
                            y - 4, i + 1);
        text += fmt::format("<text x=\"490\" y=\"{}\">{}. {} <tspan fill=\"#666666\">{:.0f} ns, {}</tspan></text>\n",
                            34 + 17 * i, i + 1, escapedMarkup(describe(front[i]->setting)), front[i]->nsPerPixel(),
                            decibelText(accuracy(*front[i])));
    }
    double y = 34 + 17 * double(front.size()) + 22;
    double x = 490;
    for (const auto& [knob, color] : knobColors)
    {
        if (!shown.count(knob)) continue;
        text +=
            fmt::format("<circle cx=\"{0}\" cy=\"{1}\" r=\"4\" fill=\"{2}\"/><text x=\"{3}\" y=\"{4}\">{5}</text>\n",
                        x + 4, y - 4, color, x + 14, y, knob);
        x = x < 700 ? x + 120 : 490;
        if (x == 490) y += 17;
    }
    return text + "</svg>\n";
}

} // namespace rt::lesson10
