#include "viz/strip_pane.h"

#include <sstream>

namespace rt::viz
{

const std::vector<KeyHelp>& keyHelp()
{
    static const std::vector<KeyHelp> help{
        {"click", "pixel or ray", "in the picture: choose the pixel; in space: choose a ray"},
        {"↑ ↓", "ray", "previous and next ray of the tree"},
        {"PgUp", "parent", "the ray that sent this one"},
        {"⇧ ←↑↓→", "move pixel", "move the pixel; without ⇧ while the pointer is on the picture"},
        {"drag", "turn", "turn the scene; with ⇧ or the middle button move it"},
        {"wheel", "zoom", "zoom the scene or the picture, scroll the numbers"},
        {"r", "fit scene", "show the whole scene"},
        {"t", "fit rays", "show the rays of the tree"},
        {"[ ]", "depth", "MAXDEPTH one lower, one higher"},
        {"n", "normals", "normals on and off"},
        {"h", "help", "this sheet"},
        {"F12", "", "save a picture of the window as raytree.png"},
        {"q", "quit", "quit"},
    };
    return help;
}

double drawKey(Canvas& canvas, double x, double y, const std::string& key, double size)
{
    const TextLook look{Font::sans, size, color::text};
    const double width = canvas.textWidth(key, look) + canvas.px(11), height = canvas.px(size + 7);
    canvas.roundedBox({x, y - height / 2, width, height}, canvas.px(4), color::panelRaised);
    canvas.text(x + canvas.px(5.5), y, key, look);
    return x + width;
}

bool StripPane::update(unsigned)
{
    return false;
}

void StripPane::paint(Canvas& canvas)
{
    canvas.fill({0, area.height - 1.0, double(area.width), 1}, color::line);
    const double middle = area.height / 2.0;
    const TextLook look{Font::sans, 12.5, color::textDim};
    double x = canvas.px(16);
    for (const auto& help : keyHelp())
    {
        if (!*help.brief) continue;
        // The whole entry or none of it.
        double width = canvas.textWidth(help.brief, look) + canvas.px(7);
        std::istringstream keys(help.keys);
        for (std::string key; keys >> key;) width += canvas.textWidth(key, {Font::sans, 12, {}}) + canvas.px(14);
        if (x + width > area.width - canvas.px(12)) continue;

        std::istringstream again(help.keys);
        for (std::string key; again >> key;) x = drawKey(canvas, x, middle, key, 12) + canvas.px(3);
        x += canvas.px(4);
        x += canvas.text(x, middle, help.brief, look) + canvas.px(18);
    }
}

} // namespace rt::viz
