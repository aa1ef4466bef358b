#include "viz/window/canvas.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <vtkBrush.h>
#include <vtkPen.h>
#include <vtkStdString.h>

#include "viz/state/node_text.h"

namespace rt::viz
{

namespace
{

bool isPlain(const std::string& text)
{
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

} // namespace

void Canvas::apply(const TextLook& look, int otherFont)
{
    useFont(property, look.font, otherFont);
    property->SetFontSize(std::max(6, int(std::lround(px(look.size)))));
    property->SetColor(look.color.r / 255.0, look.color.g / 255.0, look.color.b / 255.0);
    property->SetOpacity(look.color.a / 255.0);
    property->SetJustificationToLeft();
    property->SetVerticalJustificationToCentered();
    context->ApplyTextProp(property);
}

double Canvas::text(double x, double y, const std::string& text, const TextLook& look)
{
    if (text.empty()) return 0;
    const auto runs = isPlain(text) ? std::vector<FontRun>{{-1, text}} : fontRuns(text, look.font);
    for (const auto& run : runs)
    {
        apply(look, run.other);
        context->DrawString(float(std::round(x)), float(std::round(y)), vtkStdString(run.text));
        if (runs.size() > 1) x += runWidth(run, look);
    }
    return textWidth(text, look);
}

double Canvas::runWidth(const FontRun& run, const TextLook& look)
{
    apply(look, run.other);
    float bounds[4] = {0, 0, 0, 0};
    context->ComputeStringBounds(vtkStdString(run.text), bounds);
    return double(bounds[2]);
}

double Canvas::textWidth(const std::string& text, const TextLook& look)
{
    if (text.empty()) return 0;
    // Panes measure the same few texts at each drawing.
    static std::map<std::tuple<Font, double, std::string>, double> known;
    if (known.size() > 20000) known.clear();
    const auto [entry, isNew] = known.try_emplace({look.font, px(look.size), text}, 0);
    if (isNew)
    {
        if (isPlain(text))
            entry->second = runWidth({-1, text}, look);
        else
            for (const auto& run : fontRuns(text, look.font)) entry->second += runWidth(run, look);
    }
    return entry->second;
}

double Canvas::textWithin(double x, double y, double width, const std::string& text, const TextLook& look)
{
    if (textWidth(text, look) <= width) return this->text(x, y, text, look);
    std::size_t fits = 0, tooMany = characters(text);
    while (tooMany > fits + 1)
    {
        const auto middle = (fits + tooMany) / 2;
        (textWidth(shorten(text, middle), look) <= width ? fits : tooMany) = middle;
    }
    return fits < 2 ? 0 : this->text(x, y, shorten(text, fits), look);
}

void Canvas::brush(const Rgba& color)
{
    context->GetBrush()->SetTexture(nullptr);
    context->GetBrush()->SetColor(color.r, color.g, color.b, color.a);
}

void Canvas::fill(const Box& box, const Rgba& color)
{
    context->GetPen()->SetLineType(vtkPen::NO_PEN);
    brush(color);
    context->DrawRect(float(box.x), float(box.y), float(box.width), float(box.height));
}

void Canvas::polygon(const std::vector<vec2>& corners, const Rgba& color)
{
    std::vector<float> points;
    for (const auto& corner : corners)
    {
        points.push_back(float(corner[0]));
        points.push_back(float(corner[1]));
    }
    context->GetPen()->SetLineType(vtkPen::NO_PEN);
    brush(color);
    context->DrawPolygon(points.data(), int(corners.size()));
}

void Canvas::roundedBox(const Box& box, double radius, const Rgba& color)
{
    radius = std::min({radius, box.width / 2, box.height / 2});
    const auto outline = [&](double grow) {
        constexpr int steps = 6;
        constexpr double quarter = std::numbers::pi / 2;
        std::vector<vec2> corners;
        for (int corner = 0; corner < 4; ++corner)
        {
            const double cx = corner == 0 || corner == 3 ? box.x + box.width - radius : box.x + radius;
            const double cy = corner < 2 ? box.y + box.height - radius : box.y + radius;
            for (int i = 0; i <= steps; ++i)
            {
                const double angle = quarter * (corner + double(i) / steps);
                corners.push_back({cx + (radius + grow) * std::cos(angle), cy + (radius + grow) * std::sin(angle)});
            }
        }
        return corners;
    };
    // The context draws without antialiasing: a fainter rim softens the corners.
    polygon(outline(0.45), color.withAlpha(0.45 * color.a / 255.0));
    polygon(outline(-0.25), color);
}

void Canvas::frame(const Box& box, double width, const Rgba& color)
{
    fill({box.x, box.y, box.width, width}, color);
    fill({box.x, box.y + box.height - width, box.width, width}, color);
    fill({box.x, box.y + width, width, box.height - 2 * width}, color);
    fill({box.x + box.width - width, box.y + width, width, box.height - 2 * width}, color);
}

void Canvas::line(const vec2& from, const vec2& to, double width, const Rgba& color)
{
    const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
    if (!(length > 0)) return;
    const double nx = -dy / length, ny = dx / length;
    const auto strip = [&](double half, const Rgba& c) {
        polygon({{from[0] + half * nx, from[1] + half * ny},
                 {to[0] + half * nx, to[1] + half * ny},
                 {to[0] - half * nx, to[1] - half * ny},
                 {from[0] - half * nx, from[1] - half * ny}},
                c);
    };
    if (dx != 0 && dy != 0) strip(width / 2 + 0.5, color.withAlpha(0.4 * color.a / 255.0));
    strip(width / 2, color);
}

void Canvas::disc(const vec2& centre, double radius, const Rgba& color)
{
    roundedBox({centre[0] - radius, centre[1] - radius, 2 * radius, 2 * radius}, radius, color);
}

void Canvas::image(double x, double y, vtkImageData* pixels)
{
    context->GetPen()->SetLineType(vtkPen::NO_PEN);
    context->DrawImage(float(x), float(y), pixels);
}

} // namespace rt::viz
