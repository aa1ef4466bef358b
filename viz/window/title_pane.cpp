#include "viz/window/title_pane.h"

#include <filesystem>

#include <fmt/format.h>

#include "common/base/image.h"
#include "viz/state/node_text.h"
#include "viz/window/strip_pane.h"

namespace rt::viz
{

bool TitlePane::update(unsigned changes)
{
    return changes & (changedTree | changedOptions);
}

void TitlePane::paint(Canvas& canvas)
{
    const auto& scene = controller.scene();
    const auto& tree = controller.tree();
    const double second = controller.canCompare() ? area.height * 28.0 / 74 : 0; // height of the line below
    const double middle = second + (area.height - second) / 2, gap = canvas.px(26), pad = canvas.px(16);
    if (second > 0) paintComparison(canvas, second);
    canvas.fill({0, 0, double(area.width), canvas.hair()}, color::line);

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
    // With more than one sample neither tree nor numbers are those of the pixel in the picture.
    const bool isPart = controller.pixel() && controller.samples() > 1;
    facts.push_back({isPart ? fmt::format("centre ray's radiance, 1 of {} samples", controller.samples()) : "radiance",
                     shortText(radiance), true});
    // What stands in for rays beyond the cap may be rays too.
    const int deepest = controller.deepest(), cap = controller.maxDepth();
    facts.push_back({"depth", fmt::format("{}{}{}", deepest, deepest > cap ? ", MAXDEPTH " : " of ", cap)});
    facts.push_back({"real", shorten(tree.real, 12)});

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
    const auto lesson = shorten(controller.source().title, 40);
    const double chipWidth = canvas.textWidth(lesson, chip) + canvas.px(20), chipHeight = canvas.px(24);
    canvas.roundedBox({pad, middle - chipHeight / 2, chipWidth, chipHeight}, chipHeight / 2, color::accent);
    canvas.text(pad + canvas.px(10), middle, lesson, chip);

    const auto text = scene.title.empty() ? std::filesystem::path(scene.file).stem().string() : scene.title;
    const double start = pad + chipWidth + canvas.px(14);
    canvas.textWithin(start, middle, x - start, text, title);
}

/// The first difference to the other tree, in one line.
void TitlePane::paintComparison(Canvas& canvas, double height)
{
    const double pad = canvas.px(16), y = height * 0.56;
    const TextLook plain{Font::sans, 13, color::textDim};
    const Rgba other = colorOf(RayRole::other);
    canvas.fill({0, canvas.hair(), double(area.width), height}, mix(color::panel, other, 0.08));
    double x = pad;
    const auto name = shorten(controller.other().title, 48);
    const auto* comparison = controller.comparison();
    if (!comparison)
    {
        canvas.textWithin(x, y, area.width - 2 * pad, "the comparison with " + name + " is off: c turns it on", plain);
        return;
    }
    x += canvas.text(x, y, "compared with ", plain);
    x += canvas.textWithin(x, y, area.width - x - pad, name, {Font::bold, 13, other}) + canvas.px(14);
    if (!comparison->first)
    {
        canvas.textWithin(x, y, area.width - x - pad,
                          fmt::format("no difference above {:g}, relatively", comparison->tolerance.relative), plain);
        return;
    }
    // The way to it is a key away, if there is room to say so.
    const double button = canvas.px(130);
    double end = area.width - pad;
    if (area.width > canvas.px(1000))
    {
        end -= button;
        canvas.text(drawKey(canvas, end + canvas.px(20), y, "d", 11.5) + canvas.px(6), y, "go there", plain);
    }
    const auto said = describe(*comparison->first);
    canvas.textWithin(x, y, end - x, "first difference: " + said.substr(0, said.find('\n')),
                      {Font::sans, 13, color::text});
}

} // namespace rt::viz
