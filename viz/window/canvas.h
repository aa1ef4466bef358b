// Text, boxes and lines in pixels, y up: what the flat panes are made of.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <vtkContext2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>

#include "viz/base/palette.h"
#include "viz/drawing/labels.h"
#include "viz/window/fonts.h"

namespace rt::viz
{

struct TextLook
{
    Font font = Font::sans;
    double size = 14; ///< pixels, before scaling
    Rgba color = color::text;
};

class Canvas
{
public:
    Canvas(vtkContext2D* painter, double contentScale) : context(painter), scale(contentScale) {}

    /// A design length in pixels of the screen.
    double px(double length) const { return length * scale; }
    /// The width of a thin line: whole pixels, at least one.
    double hair() const { return std::max(1.0, std::floor(scale)); }

    /// Vertically centred on y. Returns the width.
    double text(double x, double y, const std::string& text, const TextLook& look);
    /// With an ellipsis where it is wider than `width`; nothing if not even that fits. Returns the width.
    double textWithin(double x, double y, double width, const std::string& text, const TextLook& look);
    double textWidth(const std::string& text, const TextLook& look);
    /// The width of each character of the mono font.
    double monoWidth(double size) { return textWidth(std::string(40, '0'), {Font::mono, size, {}}) / 40; }

    void fill(const Box& box, const Rgba& color);
    void roundedBox(const Box& box, double radius, const Rgba& color);
    /// An outline `width` pixels thick within the box.
    void frame(const Box& box, double width, const Rgba& color);
    void line(const vec2& from, const vec2& to, double width, const Rgba& color);
    void disc(const vec2& centre, double radius, const Rgba& color);
    void polygon(const std::vector<vec2>& corners, const Rgba& color);
    void image(double x, double y, vtkImageData* pixels);

private:
    vtkContext2D* context;
    double scale;
    vtkNew<vtkTextProperty> property;

    void apply(const TextLook& look, int otherFont = -1);
    double runWidth(const FontRun& run, const TextLook& look);
    void brush(const Rgba& color);
};

} // namespace rt::viz
