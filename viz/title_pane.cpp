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

    // The facts of the pixel stand at the right, the last ones only if there is room. The rest of the line is the title's.
    struct Fact
    {
        std::string name, value;
        bool withSwatch = false;
    };
    const Vec3<double> radiance = tree.nodes.empty() ? Vec3<double>(0) : tree.nodes[0].radiance;
    std::vector<Fact> facts;
    if (const auto pixel = controller.pixel())
        facts.push_back({"pixel", fmt::format("{}, {}", (*pixel)[0], (*pixel)[1])});
    else
        facts.push_back({"one given ray", ""});
    facts.push_back({"radiance", shortText(radiance), true});
    facts.push_back({"depth", fmt::format("{} of {}", controller.deepest(), controller.maxDepth())});
    facts.push_back({"real", name(controller.precision())});

    const TextLook label{Font::sans, 13, color::textFaint}, value{Font::sans, 14, color::text};
    const double swatch = canvas.px(16), between = canvas.px(7);
    const auto widthOf = [&](const Fact& fact) {
        return canvas.textWidth(fact.name, label) + between + canvas.textWidth(fact.value, value) +
               (fact.withSwatch ? swatch + between : 0) + gap;
    };
    double wanted = pad - gap;
    for (const auto& fact : facts) wanted += widthOf(fact);
    while (!facts.empty() && wanted > 0.68 * area.width)
    {
        wanted -= widthOf(facts.back());
        facts.pop_back();
    }
    const double x = area.width - wanted - gap;
    double at = area.width - wanted;
    for (const auto& fact : facts)
    {
        const double start = at;
        at += canvas.text(at, middle, fact.name, label) + between;
        at += canvas.text(at, middle, fact.value, value) + between;
        if (fact.withSwatch)
            canvas.roundedBox({at, middle - swatch / 2, swatch, swatch}, canvas.px(3),
                              {toSrgb8(radiance.x), toSrgb8(radiance.y), toSrgb8(radiance.z)});
        at = start + widthOf(fact);
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
