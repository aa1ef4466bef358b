#include "lessons/00_geometry/figures/svg.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "common/files/markup.h"

namespace rt::lesson00
{

namespace
{

/// Hundredths of a pixel are enough.
std::string pixels(double x)
{
    if (!std::isfinite(x)) throw std::runtime_error("its numbers are not finite");
    return fmt::format("{}", std::round(x * 100) / 100 + 0.0);
}

std::string pixels(const std::vector<Svg::Point>& points)
{
    std::string text;
    for (const auto& p : points) text += (text.empty() ? "" : " ") + pixels(p.x) + "," + pixels(p.y);
    return text;
}

/// How wide DejaVu Sans may become.
double widthOf(const std::string& words, double size, bool bold)
{
    const auto letters = std::count_if(words.begin(), words.end(), [](char c) { return (c & 0xC0) != 0x80; });
    return double(letters) * size * (bold ? 0.68 : 0.61);
}

} // namespace

Svg::Svg(int w, int h, const std::string& title) : width(w), height(h), labelsEnd(w)
{
    body = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
                       "font-family=\"DejaVu Sans, sans-serif\">\n<title>{2}</title>\n"
                       "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
                       w, h, escapedMarkup(title));
}

void Svg::clip(const Point& corner, const Point& size)
{
    ++clips;
    body += fmt::format("<clipPath id=\"frame{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n"
                        "<g clip-path=\"url(#frame{})\">\n",
                        clips, pixels(corner.x), pixels(corner.y), pixels(size.x), pixels(size.y), clips);
}

void Svg::endClip()
{
    body += "</g>\n";
}

void Svg::line(const Point& a, const Point& b, const std::string& color, double w, const std::string& dashes)
{
    path({a, b}, color, w, dashes);
}

void Svg::path(const std::vector<Point>& points, const std::string& color, double w, const std::string& dashes)
{
    body += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", pixels(points),
                        color, pixels(w), dashes.empty() ? "" : " stroke-dasharray=\"" + dashes + "\"");
}

void Svg::area(const std::vector<Point>& points, const std::string& color, double opacity)
{
    body += fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"{}\"/>\n", pixels(points), color,
                        pixels(opacity));
}

void Svg::arrow(const Point& a, const Point& b, const std::string& color, double w)
{
    const double l = glm::length(b - a);
    if (l == 0) return;
    const Point along = (b - a) / l, across(-along.y, along.x);
    const double head = std::min(5 * w, 0.6 * l);
    line(a, b - 0.8 * head * along, color, w);
    area({b, b - head * along + 0.4 * head * across, b - head * along - 0.4 * head * across}, color, 1);
}

void Svg::dot(const Point& center, const std::string& color, double radius)
{
    body += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", pixels(center.x), pixels(center.y),
                        pixels(radius), color);
}

void Svg::rightAngle(const Point& corner, const Point& u, const Point& v, double size)
{
    const Point a = size * glm::normalize(u), b = size * glm::normalize(v);
    path({corner + a, corner + a + b, corner + b}, "#374151", 1.5);
}

void Svg::label(const Point& at, const std::string& words, const std::string& color, double size,
                const std::string& anchor, bool bold)
{
    const double w = widthOf(words, size, bold), before = anchor == "start" ? 0 : anchor == "end" ? w : w / 2;
    const double x = std::clamp(at.x, before + 6, std::max(before + 6, labelsEnd - 6 - (w - before)));
    const double y = std::clamp(at.y, size + 4, height - 8.0);
    body += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{} stroke=\"white\" "
                        "stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\">{}</text>\n",
                        pixels(x), pixels(y), pixels(size), color, anchor, bold ? " font-weight=\"bold\"" : "",
                        escapedMarkup(words));
}

void Svg::beside(const Point& at, const Point& direction, const std::string& words, const std::string& color,
                 double distance, bool bold)
{
    const double l = glm::length(direction);
    const Point d = l > 0 ? direction / l : Point(0, -1);
    label(at + distance * d + Point(0, 6), words, color, 16, d.x > 0.4 ? "start" : d.x < -0.4 ? "end" : "middle", bold);
}

void Svg::panel(const Point& at, const std::vector<Line>& lines)
{
    double y = at.y;
    for (const auto& [words, color] : lines)
    {
        if (!words.empty()) label({at.x, y}, words, color, 15, "start", y == at.y);
        y += words.empty() ? 12 : 24;
    }
}

} // namespace rt::lesson00
