#include "viz/layout.h"

#include <algorithm>

namespace rt::viz
{

Layout layoutFor(int width, int height)
{
    width = std::max(width, 8);
    height = std::max(height, 8);
    Layout layout;
    layout.scale = std::clamp(std::min(width / 1600.0, height / 900.0), 0.8, 4.0);

    const int titleHeight = std::clamp(int(46 * layout.scale), 1, height / 4);
    const int stripHeight = std::clamp(int(34 * layout.scale), 1, height / 4);
    const int columnHeight = height - titleHeight - stripHeight, column = std::max(2, width * 37 / 100);
    const int imageHeight = std::clamp(std::min(column * 3 / 4, columnHeight * 45 / 100), 1, columnHeight - 1);

    layout.title = {0, height - titleHeight, width, titleHeight};
    layout.strip = {0, 0, width, stripHeight};
    layout.image = {0, stripHeight + columnHeight - imageHeight, column, imageHeight};
    layout.numbers = {0, stripHeight, column, columnHeight - imageHeight};
    layout.scene = {column, stripHeight, width - column, columnHeight};
    return layout;
}

} // namespace rt::viz
