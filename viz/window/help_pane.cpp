#include "viz/window/help_pane.h"

#include <algorithm>
#include <sstream>

#include "viz/window/strip_pane.h"

namespace rt::viz
{

bool HelpPane::click(int x, int y)
{
    const auto hit = std::find_if(caps.begin(), caps.end(), [&](const Cap& cap) {
        return x >= cap.box.x && y >= cap.box.y && x < cap.box.x + cap.box.width && y < cap.box.y + cap.box.height;
    });
    const auto key = hit == caps.end() ? std::string() : hit->key;
    controller.toggleHelp();
    if (!key.empty() && key != "h" && key != "Escape") typeKey(key);
    return false;
}

void HelpPane::paint(Canvas& canvas)
{
    caps.clear();
    const auto& help = keyHelp();
    const double pad = canvas.px(40), keys = canvas.px(150);
    double widest = 0;
    for (const auto& entry : help) widest = std::max(widest, canvas.textWidth(entry.what, {Font::sans, 14, {}}));
    // Two columns where they fit.
    const double column = keys + widest + canvas.px(40);
    const bool isWide = 2 * column + pad < area.width;
    const auto rows = isWide ? (help.size() + 1) / 2 : help.size();
    const double head = canvas.px(46);
    const double row = std::min(canvas.px(34), (area.height - head - canvas.px(16)) / double(rows));
    // In a small window letters and keys are as small as they must be.
    const double size = std::clamp(row / canvas.px(1) * 0.62, 7.0, 14.0);
    const double left = std::max(canvas.px(20), (area.width - (isWide ? 2 * column : column)) / 2);
    const double top = (area.height + head + row * double(rows)) / 2;
    canvas.text(left, top - canvas.px(12), "Keys and mouse", {Font::bold, 19, color::text});

    for (std::size_t i = 0; i < help.size(); ++i)
    {
        const double start = left + (i >= rows ? column : 0), y = top - head - row * (double(i % rows) + 0.5);
        double x = start;
        std::istringstream words(help[i].keys);
        for (std::string key; words >> key;)
            if (row >= canvas.px(22))
            {
                if (const auto name = keyOfCap(key); !name.empty())
                    caps.push_back({capBox(canvas, x, y, key, std::min(size, 13.0)), name});
                x = drawKey(canvas, x, y, key, std::min(size, 13.0)) + canvas.px(4);
            }
            else
                x += canvas.text(x, y, key, {Font::bold, size, color::accent}) + canvas.px(7);
        canvas.textWithin(start + keys, y, area.width - start - keys - canvas.px(12), help[i].what,
                          {Font::sans, size, color::text});
    }
}

} // namespace rt::viz
