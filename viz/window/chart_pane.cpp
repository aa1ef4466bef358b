#include "viz/window/chart_pane.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// Bars are drawn by hand: vtkChartXY would bring axes and a legend in another look, and a second way to place things.

namespace rt::viz
{

namespace
{

constexpr double titleHeight = 34;

Rgba weightColor()
{
    return mix(color::panel, color::textDim, 0.75);
}

/// Shorter if need be: ".97" for "0.97".
std::string number(double value, bool isShort)
{
    if (value == 0 || value == 1) return value == 0 ? "0" : "1";
    if (std::abs(value) < 0.005) return isShort ? "≈0" : "<0.01";
    if (std::abs(value) >= 1000) return fmt::format("{:.0e}", value);
    if (std::abs(value) >= 10) return fmt::format("{:.0f}", value);
    if (std::abs(value) >= 0.995) return fmt::format("{:.{}f}", value, isShort ? 1 : 2);
    auto text = fmt::format("{:.2f}", value);
    if (isShort && text[0] == '0') text.erase(0, 1);
    return text;
}

std::string percent(double share, bool isShort)
{
    if (share != 0 && std::abs(share) < 0.005) return isShort ? "<1" : "<1 %";
    return fmt::format("{:.0f}{}", 100 * share, isShort ? "" : " %");
}

} // namespace

bool ChartPane::update(unsigned changes)
{
    return changes & (changedTree | changedNode | changedStep | changedOptions);
}

void ChartPane::paint(Canvas& canvas)
{
    const auto energy = energyPerDepth(
        controller.tree(), [&](int id) { return controller.isReached(id) && controller.isShown(id); },
        [&](int id) { return controller.hasReturned(id); });
    paintBars(canvas, energy);
    paintTitle(canvas, energy);
    paintEdges(canvas);
}

void ChartPane::paintTitle(Canvas& canvas, const Energy& energy)
{
    const double y = area.height - canvas.px(titleHeight) / 2, pad = canvas.px(16), swatch = canvas.px(10);
    const TextLook look{Font::sans, 12, color::textDim};

    auto said = shareText(energy);
    int shown = energy.broken;
    for (const auto& level : energy.depths) shown += level.rays;
    const bool isAll = std::size_t(shown) == controller.tree().nodes.size();
    if (!said.empty() && !(isAll && controller.isComplete())) said += controller.isComplete() ? " (shown)" : " so far";
    if (energy.broken > 0) said = fmt::format("{} not a number", energy.broken);
    const TextLook strong{Font::sans, 12, energy.broken > 0 ? color::warning : color::text};
    const double wide = canvas.textWidth(said, strong);
    const TextLook heading{Font::bold, 13, color::text};
    const std::string title = "Energy per depth";
    const bool fits = pad + canvas.textWidth(title, heading) + wide + canvas.px(160) < area.width;
    double x = pad + canvas.text(pad, y, fits ? title : "Energy", heading) + canvas.px(10);
    if (x + wide > area.width - canvas.px(10)) return;
    canvas.text(area.width - canvas.px(14) - wide, y, said, strong);

    const double end = area.width - canvas.px(20) - wide;
    const std::pair<const char*, Rgba> keys[] = {{"weight", weightColor()}, {"light, %", color::accent}};
    for (const auto& [text, ink] : keys)
    {
        if (x + swatch + canvas.px(5) + canvas.textWidth(text, look) > end) return;
        canvas.roundedBox({x, y - swatch / 2, swatch, swatch}, canvas.px(2), ink);
        x += swatch + canvas.px(5);
        x += canvas.text(x, y, text, look) + canvas.px(10);
    }
}

void ChartPane::paintBars(Canvas& canvas, const Energy& energy)
{
    const double pad = canvas.px(16), base = canvas.px(24);
    const double high = area.height - canvas.px(titleHeight) - base - canvas.px(16);
    if (energy.depths.empty())
    {
        canvas.text(pad, (area.height - canvas.px(titleHeight)) / 2,
                    energy.broken > 0 ? "No ray has finite numbers." : "Nothing has been followed yet.",
                    {Font::sans, 12, color::textDim});
        return;
    }
    const double width = area.width - 2 * pad;
    const auto most = std::size_t(std::max(2.0, width / canvas.px(38)));
    const auto groups = grouped(energy, most);
    const bool isGrouped = groups.size() < energy.depths.size();
    const double whole = luminance(energy.gathered());
    double heaviest = 1; // coloured surfaces may amplify
    for (const auto& group : groups) heaviest = std::max(heaviest, largestChannel(group.weight));

    const double step = std::min(width / double(groups.size()), canvas.px(110)),
                 bar = std::min(step * 0.36, canvas.px(34));
    const double gap = canvas.px(1);
    TextLook figures{Font::sans, 10.5, color::textDim};
    // As short as the widest pair needs; what is still too wide stands one above the other.
    const auto weightOf = [](const auto& group) { return largestChannel(group.weight); };
    const auto shareOf = [&](const auto& group) { return whole > 0 ? luminance(group.gathered) / whole : 0; };
    const bool isShort = std::any_of(groups.begin(), groups.end(), [&](const auto& group) {
        return std::max({canvas.textWidth(number(weightOf(group), false), figures),
                         canvas.textWidth(percent(shareOf(group), false), figures), canvas.textWidth("0.97", figures),
                         canvas.textWidth("97 %", figures)}) +
                   2 * gap >
               step / 2;
    });
    if (isShort) figures.size = 10;
    const auto* selected = controller.node();
    // One of its numbers may be negative, or not a number: no bar then.
    const auto length = [&](double share) {
        return share > 0 ? std::max(canvas.px(1), high * std::min(share, 1.0)) : 0;
    };
    canvas.fill({pad, base - canvas.hair(), width, canvas.hair()}, color::line);
    for (std::size_t i = 0; i < groups.size(); ++i)
    {
        const auto& group = groups[i];
        const bool isTail = isGrouped && i + 1 == groups.size();
        const bool isChosen = selected && (selected->depth == group.depth || (isTail && selected->depth > group.depth));
        const double left = pad + step * double(i), middle = left + step / 2;
        if (isChosen)
            canvas.roundedBox({left + canvas.px(1), canvas.px(4), step - canvas.px(2), high + base + canvas.px(10)},
                              canvas.px(5), color::panelRaised);

        const double share = shareOf(group), lines = canvas.px(12);
        const double weight = length(weightOf(group) / heaviest), light = length(share);
        canvas.fill({std::round(middle - bar - gap), base, std::round(bar), weight}, weightColor());
        canvas.fill({std::round(middle + gap), base, std::round(bar), light}, color::accent);
        const auto weightText = number(weightOf(group), isShort), lightText = percent(share, isShort);
        const double weightWide = canvas.textWidth(weightText, figures),
                     lightWide = canvas.textWidth(lightText, figures);
        const double x1 = std::max(middle - gap - (bar + weightWide) / 2, left);
        const double x2 = std::min(middle + gap + (bar - lightWide) / 2, left + step - lightWide);
        double y1 = base + weight + canvas.px(8), y2 = base + light + canvas.px(8);
        if (x1 + weightWide + gap > x2)
        {
            // Neither over the other, nor over the other's bar.
            auto& upper = weight < light ? y2 : y1;
            auto& lower = weight < light ? y1 : y2;
            if (upper - lower < lines) upper = lower + lines;
        }
        canvas.text(x1, y1, weightText, figures);
        canvas.text(x2, y2, lightText, figures);

        const auto depth = fmt::format("{}{}", isTail ? "≥ " : "", group.depth);
        const TextLook look{isChosen ? Font::bold : Font::sans, 11.5, isChosen ? color::text : color::textDim};
        std::string label = step > canvas.px(100)
                                ? fmt::format("depth {}: {} {}", depth, group.rays, group.rays == 1 ? "ray" : "rays")
                            : step > canvas.px(66) ? "depth " + depth
                                                   : depth;
        if (canvas.textWidth(label, look) > step) label = depth;
        canvas.text(middle - canvas.textWidth(label, look) / 2, base / 2 + canvas.px(1), label, look);
    }
}

} // namespace rt::viz
