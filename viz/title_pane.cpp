#include "viz/title_pane.h"

#include <filesystem>

#include <fmt/format.h>

#include "common/image.h"
#include "viz/node_text.h"

namespace rt::viz
{

bool TitlePane::update(unsigned changes)
{
    return changes & (changedTree | changedPicture);
}

void TitlePane::paint(Canvas& canvas)
{
    const auto& scene = controller.scene();
    const auto& tree = controller.tree();
    const double middle = area.height / 2.0, gap = canvas.px(26), pad = canvas.px(16);
    canvas.fill({0, 0, double(area.width), 1}, color::line);

    // From the right: the facts of the pixel. What is left of the line belongs to the title.
    struct Fact
    {
        std::string name, value;
    };
    std::vector<Fact> facts;
    const Vec3<double> radiance = tree.nodes.empty() ? Vec3<double>(0) : tree.nodes[0].radiance;
    if (const auto pixel = controller.pixel())
        facts.push_back({"pixel", fmt::format("{}, {}", (*pixel)[0], (*pixel)[1])});
    else
        facts.push_back({"one given ray", ""});
    facts.push_back({"radiance", shortText(radiance)});
    facts.push_back({"depth", fmt::format("{} of {}", controller.deepest(), controller.maxDepth())});
    facts.push_back({"real", name(controller.precision())});

    const TextLook label{Font::sans, 13, color::textFaint}, value{Font::sans, 14, color::text};
    const double swatch = canvas.px(16);
    double x = area.width - pad;
    for (auto fact = facts.rbegin(); fact != facts.rend(); ++fact)
    {
        const bool isRadiance = fact->name == "radiance";
        const double names = canvas.textWidth(fact->name, label), values = canvas.textWidth(fact->value, value);
        const double start = x - names - canvas.px(7) - values - (isRadiance ? swatch + canvas.px(8) : 0);
        if (start < 0.3 * area.width) continue;
        canvas.text(start, middle, fact->name, label);
        canvas.text(start + names + canvas.px(7), middle, fact->value, value);
        if (isRadiance)
            canvas.roundedBox({x - swatch, middle - swatch / 2, swatch, swatch}, canvas.px(3),
                              {toSrgb8(radiance.x), toSrgb8(radiance.y), toSrgb8(radiance.z)});
        x = start - gap;
    }

    const TextLook chip{Font::bold, 12.5, color::dark}, title{Font::bold, 16, color::text};
    const auto lesson = controller.lesson().number
                            ? fmt::format("{:02}  {}", controller.lesson().number, controller.lesson().title)
                            : std::string(controller.lesson().title);
    const double chipWidth = canvas.textWidth(lesson, chip) + canvas.px(20), chipHeight = canvas.px(24);
    canvas.roundedBox({pad, middle - chipHeight / 2, chipWidth, chipHeight}, chipHeight / 2, color::accent);
    canvas.text(pad + canvas.px(10), middle, lesson, chip);

    auto text = scene.title.empty() ? std::filesystem::path(scene.file).stem().string() : scene.title;
    const double start = pad + chipWidth + canvas.px(14);
    for (auto columns = characters(text); columns > 4 && start + canvas.textWidth(text, title) > x; --columns)
        text = shorten(text, columns - 1);
    if (start + canvas.textWidth(text, title) <= x) canvas.text(start, middle, text, title);
}

} // namespace rt::viz
