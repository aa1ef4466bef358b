#include "viz/window/scene_labels.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "viz/drawing/lamps.h"
#include "viz/drawing/object_meshes.h"

namespace rt::viz
{

namespace
{

constexpr int mostRayLabels = 24;

struct Label
{
    std::string text;
    std::string key; // it is the same label as before if this is the same
    int node = -1;
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
        const auto* node = given.controller.node();
        lamps = namedLamps(given.controller.scene(), node && node->hit ? node->hit->point : given.objects.centre);
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
        auto& memory = input.labels.places;
        for (auto& [key, place] : memory) place.isShown = false;
        for (const auto& label : labels)
        {
            requests.push_back(label.request);
            if (const auto before = memory.find(label.key); before != memory.end())
                requests.back().kept = before->second.box;
        }
        const auto places = placeLabels(requests, input.width, input.height, lines, taken, canvas.hair());
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (places[i])
            {
                memory[labels[i].key] = {*places[i], labels[i].node, true};
                draw(labels[i], *places[i]);
            }
    }

private:
    Canvas& canvas;
    const OverlayInput& input;
    Projector projector;
    std::vector<std::array<vec2, 2>> lines;
    std::vector<int> lineOf; // of each segment; -1: it is behind the viewer
    std::vector<Label> labels;
    std::vector<bool> lamps; // that are named

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
        Label label{text, text, -1, look, {0, 0, 0, 0}, false, {}};
        label.request.width = canvas.textWidth(text, look) + canvas.px(11);
        label.request.height = canvas.px(look.size + 6);
        label.request.gap = canvas.px(7);
        label.request.priority = priority;
        labels.push_back(std::move(label));
        return labels.back();
    }

    static void name(Label& label, const Segment& segment)
    {
        label.node = segment.node;
        label.key =
            fmt::format("{}/{}/{}/{}/{}", label.text, int(segment.role), segment.node, segment.shadow, segment.capped);
    }

    void addLights()
    {
        const auto& lights = input.controller.scene().lights;
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (const auto at = lamps[i] ? lightAnchor(int(i)) : std::nullopt)
            {
                auto& label = add(fmt::format("light {}", i), {Font::sans, 12.5, color::text}, 80);
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
            if (segment.light >= 0 && std::size_t(segment.light) < lamps.size() && !lamps[std::size_t(segment.light)])
                continue;
            const bool chosen = segment.node == selected;
            const bool isCrowded = input.drawing.nodes > crowded;
            if (!chosen && isCrowded && !isRay(segment.role)) continue;
            const auto& line = lines[std::size_t(lineOf[i])];
            const double shown = std::hypot(line[1][0] - line[0][0], line[1][1] - line[0][1]);
            if (!chosen && shown < canvas.px(26)) continue;
            if (!chosen && ++count > mostRayLabels) continue;

            const Rgba kind = colorOf(segment.role);
            if (segment.notTraced())
            {
                auto& label = add(segment.stopped == End::cutoff ? "cutoff" : "MAXDEPTH", {Font::bold, 11, kind},
                                  chosen ? 95 : 40);
                name(label, segment);
                label.plate = color::dark.withAlpha(0.6);
                label.request.anchors = {line[1], line[0]};
                continue;
            }
            const bool main = isRay(segment.role);
            auto& label = add(labelOf(segment), {Font::bold, main ? 13.0 : 12.0, main ? color::dark : kind},
                              (chosen ? 100 : 50) + (main ? 20 : 0) - std::min(segment.node, 30));
            name(label, segment);
            label.plate = main ? kind : color::dark.withAlpha(0.6);
            label.outlined = chosen && main && input.drawing.nodes > 1;
            label.request.anchors = alongSegment(line, input.width, input.height);
            // The far half of a fading ray is too pale to be named there.
            if (segment.fades)
                label.request.anchors =
                    alongSegment({line[0], {(line[0][0] + line[1][0]) / 2, (line[0][1] + line[1][1]) / 2}}, input.width,
                                 input.height);
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
        const vec3 down = -unit(scene.camera.up);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        {
            const auto name = fmt::format("sphere{}", i);
            const auto& sphere = scene.spheres[i];
            if (met.count(name) && !isBackdrop(sphere, scene.camera))
                addObject(name, sphere.center + 0.62 * sphere.radius * down);
        }
        for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        {
            const auto name = fmt::format("mesh{}", i), its = name + ".";
            const auto box = boxOf(scene.meshes[i]);
            const auto isMet =
                std::any_of(met.begin(), met.end(), [&](const auto& one) { return one.starts_with(its); });
            if (isMet && box) addObject(name, 0.5 * ((*box)[0] + (*box)[1]));
        }
    }

    void addObject(const std::string& name, const vec3& place)
    {
        const auto at = projector(place);
        if (!at) return;
        auto& label = add(name, {Font::sans, 11.5, color::text.withAlpha(0.9)}, 10);
        label.plate = color::dark.withAlpha(0.45);
        label.request.anchors = {*at};
        label.request.gap = canvas.px(1);
    }
};

} // namespace

int LabelPlaces::nodeAt(const vec2& point) const
{
    for (const auto& [key, place] : places)
    {
        const auto& box = place.box;
        if (place.isShown && place.node >= 0 && point[0] >= box.x && point[1] >= box.y &&
            point[0] < box.x + box.width && point[1] < box.y + box.height)
            return place.node;
    }
    return -1;
}

void paintLabels(Canvas& canvas, const OverlayInput& input, const std::vector<Box>& taken)
{
    Labels(canvas, input).paint(taken);
}

} // namespace rt::viz
