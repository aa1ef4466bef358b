#include "viz/window/strip_pane.h"

#include <algorithm>
#include <map>
#include <sstream>

#include <fmt/format.h>

namespace rt::viz
{

namespace
{

bool has(const FeatureSet& models, std::initializer_list<Feature> features)
{
    return std::any_of(features.begin(), features.end(), [&](Feature feature) {
        return std::find(models.begin(), models.end(), feature) != models.end();
    });
}

bool isIn(const Box& box, double x, double y)
{
    return x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height;
}

/// A triangle of the size of a letter, pointing right (1) or left (-1).
void arrow(Canvas& canvas, double x, double y, double reach, int way, const Rgba& ink)
{
    canvas.polygon({{x + way * reach, y}, {x - way * reach * 0.75, y + reach}, {x - way * reach * 0.75, y - reach}},
                   ink);
}

void bar(Canvas& canvas, double x, double y, double half, const Rgba& ink)
{
    canvas.fill({std::round(x - canvas.px(1.2)), y - half, canvas.px(2.4), 2 * half}, ink);
}

} // namespace

const std::vector<KeyHelp>& keyHelp()
{
    static const std::vector<KeyHelp> help{
        {"click", "pixel or ray", "the picture: choose the pixel; space or tree: choose a ray"},
        {"h", "help", "this sheet"},
        {"← →", "step", "one step back, one step on; the recursion as it happened"},
        {"Space", "play", "play the steps, pause"},
        {"↑ ↓", "ray", "previous and next ray of the tree"},
        {"PgUp", "parent", "the ray that sent this one"},
        {"⇧ ←↑↓→", "move pixel", "move the pixel"},
        {"[ ]", "depth", "MAXDEPTH one lower, one higher"},
        {"r", "fit scene", "show the whole scene and picture"},
        {"t", "fit rays", "fit the rays that are shown, in space and in the graph"},
        {"m", "enlarge", "enlarge the pane clicked last; again: the next one; Esc: all panes"},
        {", .", "", "play slower, faster"},
        {"+ -", "", "larger letters, smaller ones"},
        {"Home End", "", "before the first step, after the last"},
        {"g 12 ⏎", "", "go to ray 12"},
        {"1 2 3 4 5", "", "show or hide camera, reflected, transmitted, shadow rays lit and blocked"},
        {"n", "", "normals on and off"},
        {"c d", "", "comparison on and off; go to the first difference"},
        {"l", "", "light or dark look"},
        {"e", "", "export the tree: .json .vtp .gltf .glb .html"},
        {"F12", "", "save a picture of the window"},
        {"drag", "", "turn the scene; with ⇧ or the middle button move it; move picture or tree"},
        {"wheel", "", "zoom scene, picture or tree; scroll numbers or code"},
        {"Esc", "", "close this sheet, end typing, clear the message"},
        {"q", "", "quit"},
    };
    return help;
}

std::string keyOfCap(const std::string& cap)
{
    static const std::map<std::string, std::string> names{
        {"←", "Left"},      {"→", "Right"},    {"↑", "Up"},          {"↓", "Down"},
        {"Space", "space"}, {"PgUp", "Prior"}, {"[", "bracketleft"}, {"]", "bracketright"},
        {",", "comma"},     {".", "period"},   {"+", "plus"},        {"-", "minus"},
        {"Home", "Home"},   {"End", "End"},    {"Esc", "Escape"},    {"F12", "F12"}};
    if (const auto found = names.find(cap); found != names.end()) return found->second;
    return cap.size() == 1 ? cap : "";
}

Box capBox(Canvas& canvas, double x, double y, const std::string& cap, double size)
{
    const double height = canvas.px(size + 7);
    return {x, y - height / 2, canvas.textWidth(cap, {Font::sans, size, {}}) + canvas.px(11), height};
}

double drawKey(Canvas& canvas, double x, double y, const std::string& key, double size, bool isHot)
{
    const Box box = capBox(canvas, x, y, key, size);
    if (!keyOfCap(key).empty())
        canvas.roundedBox(box, canvas.px(4), isHot ? mix(color::panelRaised, color::text, 0.18) : color::panelRaised);
    canvas.text(x + canvas.px(5.5), y, key, {Font::sans, size, keyOfCap(key).empty() ? color::accent : color::text});
    return x + box.width;
}

bool StripPane::update(unsigned changes)
{
    return changes & ~(changedHover | changedPicture | changedPass | changedShare);
}

void StripPane::set(int slider, double x)
{
    const auto& track = tracks[slider];
    if (slider == stepSlider) controller.stepTo(track.stopAt(x));
    if (slider == depthSlider) controller.setMaxDepth(track.stopAt(x));
    if (slider == weakSlider) controller.setWeakest(throughputAt(track.at(x)));
}

bool StripPane::press(int x, int y)
{
    held = -1;
    for (int i = 0; i < sliders; ++i)
        if (isIn(grips[i], x, y)) held = i;
    if (held < 0) return false;
    heldX = x;
    set(held, heldX);
    return true;
}

bool StripPane::drag(int dx, int)
{
    if (held < 0) return false;
    heldX += dx;
    set(held, heldX);
    return false; // the controller says what has changed
}

void StripPane::release()
{
    if (held >= 0) askForDrawing();
    held = -1;
}

bool StripPane::click(int x, int y)
{
    for (const auto& spot : spots)
        if (isIn(spot.box, x, y))
        {
            const auto act = spot.act; // painting makes new spots
            act();
            return false;
        }
    return false;
}

void StripPane::hover(int x, int y)
{
    pointerX = x;
    pointerY = y;
    const auto find = [&](const auto& places, const auto& boxOf) {
        int found = -1;
        for (std::size_t i = 0; i < std::size(places); ++i)
            if (isIn(boxOf(places[i]), x, y)) found = int(i);
        return found;
    };
    const int spot = find(spots, [](const Spot& s) { return s.box; });
    const int slider = find(grips, [](const Box& box) { return box; });
    if (spot == hot && slider == hotSlider) return;
    hot = spot;
    hotSlider = slider;
    askForDrawing();
}

void StripPane::leave()
{
    pointerX = pointerY = -1;
    if (hot >= 0 || hotSlider >= 0) askForDrawing();
    hot = hotSlider = -1;
}

bool StripPane::isHot(const Box& box) const
{
    return isIn(box, pointerX, pointerY);
}

void StripPane::addSpot(const Box& box, const std::string& hint, std::function<void()> act)
{
    spots.push_back({box, std::move(act), hint});
}

/// First step, back, play, on, last step.
double StripPane::paintButtons(Canvas& canvas, double x, double y)
{
    const double side = canvas.px(28), gap = canvas.px(4), half = canvas.px(5);
    const bool atStart = controller.step() == 0, atEnd = controller.isComplete();
    struct Button
    {
        const char* hint;
        bool isIdle;
        std::function<void()> act;
        std::function<void(double, const Rgba&)> draw;
    };
    const Button buttons[] = {
        {"before the first step  (Home)", atStart, [this] { controller.stepTo(0); },
         [&](double cx, const Rgba& ink) {
             bar(canvas, cx - half, y, half, ink);
             arrow(canvas, cx + canvas.px(1.5), y, half, -1, ink);
         }},
        {"one step back  (←)", atStart, [this] { controller.stepBy(-1); },
         [&](double cx, const Rgba& ink) { arrow(canvas, cx - canvas.px(1), y, half, -1, ink); }},
        {controller.isPlaying() ? "pause  (Space)" : "play  (Space)", controller.lastStep() == 0,
         [this] { controller.setPlaying(!controller.isPlaying()); },
         [&](double cx, const Rgba& ink) {
             if (!controller.isPlaying()) return arrow(canvas, cx, y, canvas.px(6.5), 1, ink);
             bar(canvas, cx - canvas.px(3.2), y, canvas.px(6), ink);
             bar(canvas, cx + canvas.px(3.2), y, canvas.px(6), ink);
         }},
        {"one step on  (→)", atEnd, [this] { controller.stepBy(1); },
         [&](double cx, const Rgba& ink) { arrow(canvas, cx + canvas.px(1), y, half, 1, ink); }},
        {"after the last step  (End)", atEnd && !controller.current(),
         [this] { controller.stepTo(controller.lastStep()); },
         [&](double cx, const Rgba& ink) {
             bar(canvas, cx + half, y, half, ink);
             arrow(canvas, cx - canvas.px(1.5), y, half, 1, ink);
         }},
    };
    for (const auto& button : buttons)
    {
        const bool isMain = &button == &buttons[2];
        const double width = isMain ? side * 1.45 : side;
        const Box box{x, y - side / 2, width, side};
        const Rgba face = isMain && !button.isIdle ? color::accent : color::panelRaised;
        canvas.roundedBox(box, canvas.px(6), isHot(box) && !button.isIdle ? mix(face, color::text, 0.18) : face);
        button.draw(x + width / 2, button.isIdle ? mix(color::panelRaised, color::textFaint, 0.55)
                                   : isMain      ? color::dark
                                                 : color::text);
        if (!button.isIdle) addSpot(box, button.hint, button.act);
        x += width + gap;
    }
    return x;
}

void StripPane::paintSlider(Canvas& canvas, Role role, const Box& place, const std::string& label,
                            const std::string& value, double position)
{
    const double y = place.y + place.height / 2, knob = canvas.px(7), rail = canvas.px(4);
    const TextLook name{Font::sans, 12, color::textDim}, number{Font::bold, 12, color::text};
    auto& track = tracks[role];
    // The value has a place of its own width at the right, so that the track stays where it is.
    const double room = canvas.textWidth(role == weakSlider    ? "0.0001 %"
                                         : role == depthSlider ? "1024"
                                                               : "9999 of 9999",
                                         number);
    const double wordy = canvas.textWidth(label, name) + canvas.px(12);
    const bool withLabel = place.width - wordy - room > canvas.px(90);
    if (withLabel) canvas.text(place.x, y, label, name);
    track.left = place.x + (withLabel ? wordy : 0) + knob;
    track.right = std::max(track.left + 1, place.x + place.width - room - canvas.px(10) - knob);
    canvas.text(track.right + knob + canvas.px(9), y, value, number);

    const double x = track.x(std::clamp(position, 0.0, 1.0));
    canvas.roundedBox({track.left - rail / 2, y - rail / 2, track.right - track.left + rail, rail}, rail / 2,
                      color::line);
    canvas.roundedBox({track.left - rail / 2, y - rail / 2, x - track.left + rail, rail}, rail / 2, color::accent);
    if (role == depthSlider && (track.right - track.left) / track.stops > canvas.px(7))
        for (int i = 0; i <= track.stops; ++i)
            canvas.fill({std::round(track.x(double(i) / track.stops)), y - canvas.px(6.5), canvas.hair(), canvas.px(3)},
                        color::textFaint);
    const bool isLively = held == role || hotSlider == role;
    canvas.disc({x, y}, knob + (isLively ? canvas.px(1.5) : 0), color::accent);
    canvas.disc({x, y}, knob - canvas.px(3.5), isLively ? color::dark : color::panel);
    grips[role] = {track.left - 2 * knob, place.y, track.right - track.left + 4 * knob, place.height};
}

/// What keys 1 to 5, n and c switch, each with its key.
double StripPane::paintChips(Canvas& canvas, double x, double y)
{
    struct Chip
    {
        const char* key;
        std::string text;
        RayRole role;
        bool isOn, isTaught;
        std::function<void()> act;
    };
    const auto& models = controller.source().models;
    const bool mirrors = has(models, {Feature::mirror, Feature::partial, Feature::fresnel});
    const bool shadows = has(models, {Feature::direct});
    const auto kind = [&](const char* key, const char* text, RayRole role, Kind of, bool isTaught) {
        return Chip{key, text, role, controller.shows(of), isTaught, [this, of] { controller.toggle(of); }};
    };
    const std::vector<Chip> chips{
        kind("1", "camera", RayRole::camera, Kind::camera, true),
        kind("2", "reflected", RayRole::reflected, Kind::reflected, mirrors),
        kind("3", "transmitted", RayRole::transmitted, Kind::transmitted, has(models, {Feature::refraction})),
        kind("4", "light reached", RayRole::reaches, Kind::lit, shadows),
        kind("5", "blocked", RayRole::blocked, Kind::blocked, shadows),
        {"n", "normals", RayRole::normal, controller.showsNormals(), true, [this] { controller.toggleNormals(); }},
        {"c", "compare", RayRole::other, controller.comparison() != nullptr, controller.canCompare(),
         [this] { controller.toggleComparison(); }},
    };
    const double height = canvas.px(22);
    for (const auto& chip : chips)
    {
        if (!chip.isTaught) continue;
        const Rgba ink = chip.isOn ? color::text : color::textFaint;
        const TextLook text{Font::sans, 12, ink}, key{Font::bold, 11, chip.isOn ? color::dark : color::textFaint};
        const double cap = canvas.px(19);
        const double width = cap + canvas.textWidth(chip.text, text) + canvas.px(15);
        if (x + width > area.width - canvas.px(10)) break;
        const Box box{x, y - height / 2, width, height};
        canvas.roundedBox(box, canvas.px(6),
                          isHot(box) ? mix(color::panelRaised, color::text, 0.14) : color::panelRaised);
        const Box capBox{x + canvas.px(2.5), box.y + canvas.px(2.5), cap, height - canvas.px(5)};
        if (chip.isOn) canvas.roundedBox(capBox, canvas.px(4.5), colorOf(chip.role));
        canvas.text(capBox.x + (cap - canvas.textWidth(chip.key, key)) / 2, y, chip.key, key);
        const double at = x + cap + canvas.px(8), wide = canvas.text(at, y, chip.text, text);
        if (!chip.isOn)
            canvas.fill({at, std::round(y), wide, canvas.hair()}, color::textFaint); // struck out: not by colour alone
        addSpot(box, fmt::format("{} {}  ({})", chip.isOn ? "hide" : "show", chip.text, chip.key), chip.act);
        x += width + canvas.px(6);
    }
    return x;
}

/// What is being typed, what went wrong, or what the pointer is over; false if there is nothing of that.
bool StripPane::paintLine(Canvas& canvas, double x, double y)
{
    const double width = area.width - canvas.px(14) - x, height = canvas.px(24), pad = canvas.px(9);
    if (width < canvas.px(60)) return true; // no room for keys either
    const TextLook look{Font::sans, 12.5, color::text};
    if (typed)
    {
        const double end = x + pad + canvas.text(x + pad, y, "go to ray ", look);
        const double digits = canvas.text(end, y, *typed, {Font::bold, 13, color::accent});
        canvas.fill({end + digits + 2 * canvas.hair(), y - canvas.px(8), canvas.px(1.5), canvas.px(16)}, color::text);
        canvas.textWithin(end + digits + canvas.px(16), y, area.width - end - digits - canvas.px(30),
                          "⏎ goes there, Esc leaves", {Font::sans, 12, color::textDim});
        return true;
    }
    if (const auto& message = controller.message(); !message.empty())
    {
        const auto first = message.substr(0, message.find('\n'));
        const Box box{x, y - height / 2, width, height};
        const bool isCalm = controller.tone() != Tone::trouble;
        const Rgba ink = isCalm ? color::accent : color::warning;
        canvas.roundedBox(box, canvas.px(6), mix(color::panel, ink, 0.16));
        const double cx = x + canvas.px(15), half = canvas.px(7);
        if (isCalm)
            canvas.disc({cx, y}, half, ink);
        else
            canvas.polygon({{cx, y + half}, {cx + half * 1.1, y - half * 0.85}, {cx - half * 1.1, y - half * 0.85}},
                           ink);
        const TextLook mark{Font::bold, 10, color::dark};
        const char* sign = isCalm ? "i" : "!";
        canvas.text(cx - canvas.textWidth(sign, mark) / 2, y - canvas.px(isCalm ? 0 : 1), sign, mark);
        canvas.textWithin(x + canvas.px(30), y, width - canvas.px(38), first, {Font::sans, 12.5, color::text});
        addSpot(box, "", [this] { controller.say(""); });
        return true;
    }
    if (hot >= 0 && std::size_t(hot) < spots.size() && isHot(spots[std::size_t(hot)].box) &&
        !spots[std::size_t(hot)].hint.empty())
    {
        canvas.textWithin(x + pad, y, width - 2 * pad, spots[std::size_t(hot)].hint,
                          {Font::sans, 12.5, color::textDim});
        return true;
    }
    static const std::string about[sliders] = {"how much has happened  (← →)",
                                               "rays deeper than this are not traced  ([ ])",
                                               "rays that bring less than this share of the pixel are hidden"};
    if (hotSlider >= 0)
    {
        canvas.textWithin(x + pad, y, width - 2 * pad, about[hotSlider], {Font::sans, 12.5, color::textDim});
        return true;
    }
    return false;
}

void StripPane::paintKeys(Canvas& canvas, double x, double y)
{
    const TextLook look{Font::sans, 12, color::textDim};
    for (const auto& help : keyHelp())
    {
        if (!*help.brief) continue;
        // The whole entry or none of it.
        double width = canvas.textWidth(help.brief, look) + canvas.px(7);
        std::istringstream keys(help.keys);
        for (std::string key; keys >> key;) width += canvas.textWidth(key, {Font::sans, 11.5, {}}) + canvas.px(14);
        if (x + width > area.width - canvas.px(12)) continue;

        std::istringstream again(help.keys);
        for (std::string key; again >> key;)
        {
            const Box box = capBox(canvas, x, y, key, 11.5);
            x = drawKey(canvas, x, y, key, 11.5, isHot(box)) + canvas.px(3);
            // No hint: it would stand in the place of the keys.
            if (const auto name = keyOfCap(key); !name.empty()) addSpot(box, "", [this, name] { typeKey(name); });
        }
        x += canvas.px(4);
        x += canvas.text(x, y, help.brief, look) + canvas.px(16);
    }
}

void StripPane::paint(Canvas& canvas)
{
    spots.clear();
    const double width = area.width, pad = canvas.px(14);
    canvas.fill({0, area.height - canvas.hair(), width, canvas.hair()}, color::line);
    const double rowHeight = area.height / 2.0, upper = area.height - rowHeight * 0.53, lower = rowHeight * 0.5;

    const double left = paintButtons(canvas, pad, upper) + canvas.px(16);
    const double room = std::max(3.0, width - left - pad), gap = std::min(canvas.px(30), room / 12);
    const double share = room - 2 * gap;
    Box place{left, upper - rowHeight * 0.45, share * 0.40, rowHeight * 0.9};

    tracks[stepSlider].stops = std::max(1, controller.lastStep());
    paintSlider(canvas, stepSlider, place, "step", fmt::format("{} of {}", controller.step(), controller.lastStep()),
                double(controller.step()) / std::max(1, controller.lastStep()));
    place.x += place.width + gap;
    place.width = share * 0.27;
    if (held != depthSlider) deepestCap = std::max({deepestCap, controller.deepest() + 2, controller.maxDepth()});
    tracks[depthSlider].stops = std::max(1, deepestCap);
    paintSlider(canvas, depthSlider, place, "MAXDEPTH", std::to_string(controller.maxDepth()),
                double(controller.maxDepth()) / std::max(1, deepestCap));
    place.x += place.width + gap;
    place.width = share * 0.33;
    tracks[weakSlider].stops = 0;
    paintSlider(canvas, weakSlider, place, "hide weaker than", percent(controller.weakest()),
                positionOf(controller.weakest()));

    const double x = paintChips(canvas, pad, lower) + canvas.px(10);
    if (!paintLine(canvas, x, lower)) paintKeys(canvas, x, lower);
}

} // namespace rt::viz
