// Just enough SVG for line drawings with labels that stay inside the frame.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace rt::lesson00
{

inline constexpr const char *ink = "#111827", *grey = "#6b7280", *faint = "#e5e7eb", *blue = "#1d4ed8",
                            *red = "#c2410c", *green = "#15803d", *violet = "#7e22ce";

/// In pixels, x to the right, y down. Throws std::runtime_error when asked to draw what is not finite.
class Svg
{
public:
    using Point = glm::dvec2;
    struct Line
    {
        std::string words;
        std::string color = ink;
    };

    Svg(int width, int height, const std::string& title);

    /// What follows is cut off at this rectangle, until endClip().
    void clip(const Point& corner, const Point& size);
    void endClip();

    void line(const Point& a, const Point& b, const std::string& color, double width, const std::string& dashes = "");
    /// A line with a head at b.
    void arrow(const Point& a, const Point& b, const std::string& color, double width = 2.5);
    void path(const std::vector<Point>& points, const std::string& color, double width, const std::string& dashes = "");
    void area(const std::vector<Point>& points, const std::string& color, double opacity);
    void dot(const Point& center, const std::string& color, double radius = 4.5);
    /// The mark of a right angle at a corner between two directions.
    void rightAngle(const Point& corner, const Point& u, const Point& v, double size = 13);
    /// Labels that follow stay left of this.
    void keepLabelsLeftOf(double x)
    {
        labelsEnd = x;
    }
    /// Text that is moved as far as it must to stay in the frame. `anchor`: start, middle or end.
    void label(const Point& at, const std::string& words, const std::string& color = ink, double size = 16,
               const std::string& anchor = "start", bool bold = false);
    /// A label beside a point, in a direction on the page.
    void beside(const Point& at, const Point& direction, const std::string& words, const std::string& color = ink,
                double distance = 16, bool bold = false);
    /// Lines of text below each other, the first one bold; an empty line is a gap.
    void panel(const Point& at, const std::vector<Line>& lines);

    std::string text() const
    {
        return body + "</svg>\n";
    }

private:
    int width, height;
    int clips = 0;
    double labelsEnd;
    std::string body;
};

} // namespace rt::lesson00
