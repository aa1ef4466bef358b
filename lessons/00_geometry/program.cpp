#include <iostream>

#include <fmt/format.h>

#include "common/files/text_file.h"
#include "common/program/cli.h"
#include "lessons/00_geometry/tutorial.h"

namespace rt::lesson00
{

namespace
{

/// Lines through points so far away or so near to each other leave too few digits for a drawing.
constexpr double farthest = 1e6, nearest = 1e-6;

template <class Point>
void checkPoints(const Point& P, const Point& Q, const std::vector<double>& values, const std::string& option)
{
    for (const double value : values)
        if (std::abs(value) > farthest)
            throw UsageError(option, fmt::format("coordinates go from -1e6 to 1e6, got {}", number(value)));
    if (length(Q - P) < nearest)
        throw UsageError(option, "the two points are the same, or nearly: a line needs two points");
}

Lines linesOf(const std::optional<std::string>& line2, const std::optional<std::string>& line3)
{
    Lines lines;
    if (line2)
    {
        const auto v = numbers(*line2, 4, "--line2");
        lines.P2 = {v[0], v[1]};
        lines.Q2 = {v[2], v[3]};
        checkPoints(lines.P2, lines.Q2, v, "--line2");
    }
    if (line3)
    {
        const auto v = numbers(*line3, 6, "--line3");
        lines.P3 = {v[0], v[1], v[2]};
        lines.Q3 = {v[3], v[4], v[5]};
        checkPoints(lines.P3, lines.Q3, v, "--line3");
    }
    return lines;
}

void writeFigures(const std::vector<Figure>& drawn, const std::string& folder)
{
    for (const auto& figure : drawn)
    {
        const std::string path = folder + "/" + figure.name;
        if (figure.svg.empty())
        {
            std::cerr << fmt::format("{} is not drawn: {}\n", figure.name, figure.why);
            continue;
        }
        writeTextFile(path, figure.svg);
        std::cerr << path << '\n';
    }
}

} // namespace

int geometryMain(const Functions& functions, const std::string& program, const Steps* steps, int argc, char** argv)
{
    CommandLine app(steps ? "Lesson 00, geometry: the answers to the lecture's \"Tutorial 2 - Geometry\", step by step."
                          : "Exercise 00, geometry: your own answers to the lecture's \"Tutorial 2 - Geometry\".",
                    program);
    std::optional<std::string> line2, line3, folder;
    app.option("--line2", line2, "two points of the line of exercise 1; default: -3,0,2,2").type("x1,y1,x2,y2");
    app.option("--line3", line3, "two points of the line of exercise 3; default: -4,1,1,2,2,5")
        .type("x1,y1,z1,x2,y2,z2");
    app.option("--figures", folder, "also draw the figures, as SVG, into this folder").type("DIR");
    app.footer(fmt::format("Examples:\n"
                           "  {0}                              the tutorial's own points\n"
                           "  {0} --line2 1,-1,1,5             a vertical line\n"
                           "  {0} --line3 0,0,0,0,1,0          along the y axis\n"
                           "  {0} --figures .                  and the figures\n"
                           "Exit codes: 0 done, 2 bad input or usage.",
                           program));
    return runMain(app, argc, argv, [&] {
        const Lines lines = linesOf(line2, line3);
        if (folder && folder->empty()) throw UsageError("--figures", "expected a folder, got nothing");
        const std::string text = tutorialText(functions, lines, steps);
        if (folder) writeFigures(figures(functions, lines), *folder);
        std::cout << text;
        return int(exitDone);
    });
}

} // namespace rt::lesson00
