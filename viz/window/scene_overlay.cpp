#include "viz/window/scene_overlay.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "viz/drawing/lamps.h"
#include "viz/window/scene_labels.h"

namespace rt::viz
{

namespace
{

/// An arrow of the legend as it looks in space, from x on; returns where it ends.
double drawSample(Canvas& canvas, double x, double y, RayRole role)
{
    const Rgba color = colorOf(role);
    const bool thin = !isRay(role);
    const double width = canvas.px(36), stroke = canvas.px(thin ? 1.6 : 3.4), head = canvas.px(thin ? 8 : 9);
    const double tip = x + width, half = canvas.px(thin ? 3 : 4.6);
    const auto cone = [&](double end) {
        canvas.polygon({{end, y}, {end - head, y + half}, {end - head, y - half}}, color);
    };
    if (role == RayRole::blocked)
    {
        const double cross = x + width * 0.52, arm = canvas.px(4);
        canvas.fill({x, y - stroke / 2, width * 0.52, stroke}, color);
        canvas.line({cross - arm, y - arm}, {cross + arm, y + arm}, canvas.px(1.8), color);
        canvas.line({cross - arm, y + arm}, {cross + arm, y - arm}, canvas.px(1.8), color);
        for (double dash = cross + canvas.px(6); dash + canvas.px(3) < tip; dash += canvas.px(6))
            canvas.fill({dash, y - stroke / 2, canvas.px(3.4), stroke}, color);
        return tip;
    }
    if (role == RayRole::other)
    {
        for (double dash = x; dash < tip; dash += canvas.px(8))
            canvas.fill({dash, y - stroke / 2, canvas.px(5), stroke}, color);
        return tip;
    }
    double end = tip;
    cone(end);
    end -= head;
    if (role == RayRole::reflected)
    {
        cone(end);
        end -= head;
    }
    if (role == RayRole::transmitted) canvas.fill({end - canvas.px(5), y - half, canvas.px(2.4), 2 * half}, color);
    canvas.fill({x, y - stroke / 2, end - x, stroke}, color);
    return tip;
}

bool has(const FeatureSet& models, Feature feature)
{
    return std::find(models.begin(), models.end(), feature) != models.end();
}

/// The kinds that this lesson has taught. Returns what it covers.
Box drawLegend(Canvas& canvas, const OverlayInput& input)
{
    struct Entry
    {
        RayRole role;
        const char* text;
    };
    const auto& models = input.controller.source().models;
    std::vector<Entry> entries{{RayRole::camera, "camera ray"}};
    if (has(models, Feature::mirror) || has(models, Feature::fresnel))
        entries.push_back({RayRole::reflected, "reflected"});
    if (has(models, Feature::refraction)) entries.push_back({RayRole::transmitted, "transmitted"});
    entries.push_back({RayRole::reaches, "shadow ray"});
    entries.push_back({RayRole::blocked, "blocked"});
    if (input.controller.comparison()) entries.push_back({RayRole::other, "other tree"});
    if (input.controller.showsNormals()) entries.push_back({RayRole::normal, "normal"});

    const TextLook look{Font::sans, 12.5, color::textDim};
    const double left = canvas.px(14), pad = canvas.px(14), gap = canvas.px(20), row = canvas.px(25);
    const auto widthOf = [&](const Entry& entry) {
        return canvas.px(36 + 8) + canvas.textWidth(entry.text, look) + gap;
    };
    // In rows: a narrow pane has more of them.
    struct Place
    {
        double x;
        int row;
    };
    std::vector<Place> places;
    double x = 0, widest = 0;
    int rows = 1;
    for (const auto& entry : entries)
    {
        if (x > 0 && left + 2 * pad + x + widthOf(entry) > input.width)
        {
            x = 0;
            ++rows;
        }
        places.push_back({x, rows - 1});
        x += widthOf(entry);
        widest = std::max(widest, x - gap);
    }
    const Box box{left, canvas.px(14), widest + 2 * pad, rows * row + canvas.px(5)};
    canvas.roundedBox(box, canvas.px(8), color::dark.withAlpha(0.72));
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
        const double y = box.y + box.height - canvas.px(2.5) - (places[i].row + 0.5) * row;
        const double end = drawSample(canvas, left + pad + places[i].x, y, entries[i].role);
        canvas.text(end + canvas.px(8), y, entries[i].text, look);
    }
    return box;
}

/// x, y and z of the scene as they are turned now. Returns what they cover.
Box drawAxes(Canvas& canvas, const OverlayInput& input)
{
    const double size = canvas.px(26), cx = input.width - canvas.px(54), cy = input.height - canvas.px(54);
    const vec3 towards = unit(input.view.position - input.view.focal);
    const vec3 right = unit(cross(input.view.up, towards)), up = cross(towards, right);
    struct Axis
    {
        vec3 direction;
        const char* name;
        Rgba color;
    };
    const bool isDark = input.controller.look() == Look::dark;
    std::vector<Axis> axes{{{1, 0, 0}, "x", isDark ? Rgba{240, 128, 128} : Rgba{176, 32, 40}},
                           {{0, 1, 0}, "y", isDark ? Rgba{144, 214, 144} : Rgba{24, 110, 40}},
                           {{0, 0, 1}, "z", isDark ? Rgba{130, 170, 255} : Rgba{28, 72, 190}}};
    std::sort(axes.begin(), axes.end(),
              [&](const Axis& a, const Axis& b) { return dot(a.direction, towards) < dot(b.direction, towards); });
    canvas.disc({cx, cy}, canvas.px(43), color::dark.withAlpha(0.5));
    for (const auto& axis : axes)
    {
        const double x = dot(axis.direction, right), y = dot(axis.direction, up);
        canvas.line({cx, cy}, {cx + size * x, cy + size * y}, canvas.px(2), axis.color);
        const TextLook look{Font::bold, 11.5, axis.color};
        const double far = size + canvas.px(9);
        canvas.text(cx + far * x - canvas.textWidth(axis.name, look) / 2, cy + far * y, axis.name, look);
    }
    return {cx - canvas.px(42), cy - canvas.px(42), canvas.px(84), canvas.px(84)};
}

} // namespace

void paintSceneOverlay(Canvas& canvas, const OverlayInput& input)
{
    input.labels.legend = drawLegend(canvas, input);
    std::vector<Box> taken{input.labels.legend, drawAxes(canvas, input)};
    // What is left out, at the upper left.
    double y = input.height - canvas.px(20);
    const auto note = [&](const std::string& text) {
        const TextLook look{Font::sans, 12.5, color::textDim};
        const Box plate{canvas.px(10), y - canvas.px(11), canvas.textWidth(text, look) + canvas.px(12), canvas.px(22)};
        canvas.roundedBox(plate, canvas.px(5), color::panel.withAlpha(0.8));
        canvas.text(canvas.px(16), y, text, look);
        taken.push_back(plate);
        y -= canvas.px(24);
    };
    if (const auto all = input.controller.tree().nodes.size(); std::size_t(input.drawing.nodes) < all)
        note(fmt::format("{} of {} rays are drawn", input.drawing.nodes, all));
    if (const auto all = input.controller.scene().lights.size(); all > mostNamedLamps)
        note(fmt::format("{} of {} lamps are named: the strongest here", mostNamedLamps, all));
    paintLabels(canvas, input, taken);
}

} // namespace rt::viz
