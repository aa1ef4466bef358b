#include "viz/scene_overlay.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "viz/object_meshes.h"
#include "viz/strip_pane.h"

namespace rt::viz
{

namespace
{

constexpr int mostRayLabels = 24;

bool isMain(RayRole role)
{
    return role == RayRole::camera || role == RayRole::reflected || role == RayRole::transmitted;
}

struct Label
{
    std::string text;
    TextLook look;
    Rgba plate{0, 0, 0, 0};
    bool outlined = false;
    LabelRequest request;
};

class Labels
{
public:
    Labels(Canvas& painter, const OverlayInput& given)
        : canvas(painter), input(given), projector(given.view, given.width, given.height)
    {
        for (const auto& segment : input.drawing.segments)
        {
            const auto line = projector.segment(segment.from, segment.to);
            lineOf.push_back(line ? int(lines.size()) : -1);
            if (line) lines.push_back(*line);
        }
    }

    void paint(const std::vector<Box>& taken)
    {
        addLights();
        addRays();
        addObjects();
        std::vector<LabelRequest> requests;
        for (const auto& label : labels) requests.push_back(label.request);
        const auto places = placeLabels(requests, input.width, input.height, lines, taken);
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (places[i]) draw(labels[i], *places[i]);
    }

private:
    Canvas& canvas;
    const OverlayInput& input;
    Projector projector;
    std::vector<std::array<vec2, 2>> lines;
    std::vector<int> lineOf;   // of each segment; -1: it is behind the viewer
    std::vector<Label> labels;

    void draw(const Label& label, const Box& box)
    {
        if (label.outlined)
        {
            const double rim = canvas.px(1.6);
            canvas.roundedBox({box.x - rim, box.y - rim, box.width + 2 * rim, box.height + 2 * rim}, canvas.px(6) + rim,
                              {255, 255, 255});
        }
        if (label.plate.a > 0) canvas.roundedBox(box, canvas.px(6), label.plate);
        canvas.text(box.x + (box.width - canvas.textWidth(label.text, label.look)) / 2, box.y + box.height / 2,
                    label.text, label.look);
    }

    Label& add(const std::string& text, const TextLook& look, int priority)
    {
        Label label{text, look, {0, 0, 0, 0}, false, {}};
        label.request.width = canvas.textWidth(text, look) + canvas.px(11);
        label.request.height = canvas.px(look.size + 6);
        label.request.gap = canvas.px(7);
        label.request.priority = priority;
        labels.push_back(std::move(label));
        return labels.back();
    }

    void addLights()
    {
        const auto& lights = input.controller.scene().lights;
        for (std::size_t i = 0; i < lights.size() && i < 12; ++i)
            if (const auto at = lightAnchor(int(i)))
            {
                auto& label = add(fmt::format("light {}", i), {Font::sans, 12.5, mix(lightColor(lights[i]), color::text, 0.4)}, 80);
                label.plate = color::dark.withAlpha(0.55);
                label.request.anchors = {*at};
                // Beside the ball, not over it.
                if (projector(lights[i].position) == at)
                    label.request.gap += lightRadius(input.drawing) * projector.pixelsPerUnit(lights[i].position);
            }
    }

    /// Where the light is, or where the way to it leaves the pane.
    std::optional<vec2> lightAnchor(int light)
    {
        const double edge = canvas.px(26);
        const auto inside = [&](const vec2& p) {
            return p[0] > edge && p[1] > edge && p[0] < input.width - edge && p[1] < input.height - edge;
        };
        const auto at = projector(input.controller.scene().lights[std::size_t(light)].position);
        if (at && inside(*at)) return at;
        for (const auto& segment : input.drawing.segments)
            if (segment.light == light && (segment.role == RayRole::reaches || segment.role == RayRole::beyond))
                if (const auto line = projector.segment(segment.from, segment.to))
                    for (int step = 100; step > 0; --step)
                    {
                        const double t = step / 100.0;
                        const vec2 p{(*line)[0][0] + t * ((*line)[1][0] - (*line)[0][0]),
                                     (*line)[0][1] + t * ((*line)[1][1] - (*line)[0][1])};
                        if (inside(p)) return p;
                    }
        return std::nullopt;
    }

    void addRays()
    {
        const int selected = input.controller.selected();
        int count = 0;
        for (std::size_t i = 0; i < lineOf.size(); ++i)
        {
            const auto& segment = input.drawing.segments[i];
            if (lineOf[i] < 0 || segment.role == RayRole::beyond) continue;
            if (segment.role == RayRole::normal && !input.controller.showsNormals()) continue;
            const bool chosen = segment.node == selected;
            const bool crowded = input.drawing.nodes > 6;
            if (!chosen && crowded && !isMain(segment.role)) continue;
            const auto& line = lines[std::size_t(lineOf[i])];
            const double shown = std::hypot(line[1][0] - line[0][0], line[1][1] - line[0][1]);
            if (!chosen && shown < canvas.px(26)) continue;
            if (!chosen && ++count > mostRayLabels) continue;

            const Rgba kind = colorOf(segment.role);
            if (segment.notTraced)
            {
                auto& label = add("MAXDEPTH", {Font::bold, 11, kind}, chosen ? 95 : 40);
                label.plate = color::dark.withAlpha(0.6);
                label.request.anchors = {line[1], line[0]};
                continue;
            }
            const bool main = isMain(segment.role);
            auto& label = add(labelOf(segment), {Font::bold, main ? 13.0 : 12.0, main ? color::dark : kind},
                              (chosen ? 100 : 50) + (main ? 20 : 0) - std::min(segment.node, 30));
            label.plate = main ? kind : color::dark.withAlpha(0.6);
            label.outlined = chosen && main && input.drawing.nodes > 1;
            label.request.anchors = alongSegment(line, input.width, input.height);
            if (main && shown > 5 * label.request.width) label.request.line = lineOf[i];
            if (segment.role == RayRole::normal) label.request.anchors = {line[1]};
        }
    }

    /// Names of the objects that the rays meet, as the numbers pane uses them.
    void addObjects()
    {
        const auto& tree = input.controller.tree();
        const auto& scene = input.controller.scene();
        std::set<std::string> met;
        for (const auto& node : tree.nodes)
            if (node.hit && met.size() < 8) met.insert(node.hit->primitive);
        for (const auto& shadow : tree.shadows)
            if (shadow.blocker && met.size() < 8) met.insert(shadow.blocker->primitive);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        {
            const auto name = fmt::format("sphere{}", i);
            if (!met.count(name) || isBackdrop(scene.spheres[i], scene.camera)) continue;
            const auto& sphere = scene.spheres[i];
            const vec3 down = -unit(scene.camera.up);
            const auto at = projector(sphere.center + 0.62 * sphere.radius * down);
            if (!at) continue;
            auto& label = add(name, {Font::sans, 11.5, color::text.withAlpha(0.9)}, 10);
            label.plate = color::dark.withAlpha(0.45);
            label.request.anchors = {*at};
            label.request.gap = canvas.px(1);
        }
    }
};

/// An arrow of the legend as it looks in space, from x on; returns where it ends.
double drawSample(Canvas& canvas, double x, double y, RayRole role)
{
    const Rgba color = colorOf(role);
    const bool thin = !isMain(role);
    const double width = canvas.px(36), stroke = canvas.px(thin ? 1.6 : 3.4), head = canvas.px(thin ? 8 : 9);
    const double tip = x + width, half = canvas.px(thin ? 3 : 4.6);
    const auto cone = [&](double end) { canvas.polygon({{end, y}, {end - head, y + half}, {end - head, y - half}}, color); };
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

bool models(const LessonEntry& lesson, Feature feature)
{
    return std::find(lesson.models.begin(), lesson.models.end(), feature) != lesson.models.end();
}

/// The kinds that this lesson has taught. Returns what it covers.
Box drawLegend(Canvas& canvas, const OverlayInput& input)
{
    struct Entry
    {
        RayRole role;
        const char* text;
    };
    const auto& lesson = input.controller.lesson();
    std::vector<Entry> entries{{RayRole::camera, "camera ray"}};
    if (models(lesson, Feature::mirror) || models(lesson, Feature::fresnel)) entries.push_back({RayRole::reflected, "reflected"});
    if (models(lesson, Feature::refraction)) entries.push_back({RayRole::transmitted, "transmitted"});
    entries.push_back({RayRole::reaches, "shadow ray, light reached"});
    entries.push_back({RayRole::blocked, "blocked"});
    if (input.controller.showsNormals()) entries.push_back({RayRole::normal, "normal"});

    const TextLook look{Font::sans, 12.5, color::textDim};
    const double height = canvas.px(30), y = canvas.px(14) + height / 2, left = canvas.px(14);
    const auto widthOf = [&](const Entry& entry) {
        return canvas.px(36 + 8) + canvas.textWidth(entry.text, look) + canvas.px(20);
    };
    double width = canvas.px(6);
    std::size_t shown = 0;
    while (shown < entries.size() && left + width + widthOf(entries[shown]) < input.width - canvas.px(14))
        width += widthOf(entries[shown++]);
    const Box box{left, y - height / 2, width, height};
    canvas.roundedBox(box, canvas.px(8), color::dark.withAlpha(0.72));
    double x = left + canvas.px(14);
    for (std::size_t i = 0; i < shown; ++i)
    {
        x = drawSample(canvas, x, y, entries[i].role) + canvas.px(8);
        x += canvas.text(x, y, entries[i].text, look) + canvas.px(20);
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
    std::vector<Axis> axes{{{1, 0, 0}, "x", {240, 128, 128}}, {{0, 1, 0}, "y", {144, 214, 144}}, {{0, 0, 1}, "z", {130, 170, 255}}};
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

void drawHelp(Canvas& canvas, const OverlayInput& input)
{
    canvas.fill({0, 0, double(input.width), double(input.height)}, color::dark.withAlpha(0.82));
    const double row = canvas.px(29);
    double y = input.height / 2.0 + row * double(keyHelp().size()) / 2;
    const double left = std::max(canvas.px(24), input.width / 2.0 - canvas.px(330)), column = canvas.px(150);
    canvas.text(left, y, "Keys and mouse", {Font::bold, 18, color::text});
    y -= 1.4 * row;
    for (const auto& help : keyHelp())
    {
        double x = left;
        std::istringstream keys(help.keys);
        for (std::string key; keys >> key;) x = drawKey(canvas, x, y, key, 13) + canvas.px(4);
        canvas.text(left + column, y, help.what, {Font::sans, 14, color::text});
        y -= row;
    }
}

} // namespace

void paintSceneOverlay(Canvas& canvas, const OverlayInput& input)
{
    if (input.controller.showsHelp()) return drawHelp(canvas, input);
    std::vector<Box> taken{drawLegend(canvas, input), drawAxes(canvas, input)};
    if (const auto all = input.controller.tree().nodes.size(); std::size_t(input.drawing.nodes) < all)
    {
        const auto note = fmt::format("{} of {} rays are drawn", input.drawing.nodes, all);
        const TextLook look{Font::sans, 12.5, color::textDim};
        const double y = input.height - canvas.px(20);
        taken.push_back({canvas.px(14), y - canvas.px(10), canvas.text(canvas.px(16), y, note, look), canvas.px(20)});
    }
    Labels(canvas, input).paint(taken);
}

} // namespace rt::viz
