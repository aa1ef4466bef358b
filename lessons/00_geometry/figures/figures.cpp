#include "lessons/00_geometry/figures/figures.h"

namespace rt::lesson00
{

double niceStep(double length)
{
    const double power = std::pow(10, std::floor(std::log10(length / 10)));
    const double steps = length / 10 / power;
    return (steps <= 1.5 ? 1 : steps <= 3.5 ? 2 : steps <= 7.5 ? 5 : 10) * power;
}

std::vector<Figure> figures(const Functions& functions, const Lines& lines)
{
    const auto draw = [](const std::string& name, const std::function<Svg()>& make) {
        try
        {
            return Figure{name, make().text(), ""};
        }
        catch (const std::exception& reason)
        {
            return Figure{name, "", reason.what()};
        }
    };
    return {draw("00_exercise_1.svg", [&] { return drawLine2(functions, lines.P2, lines.Q2); }),
            draw("00_exercise_2a.svg", drawPointsOfALine), draw("00_exercise_2b.svg", drawDifferenceOfPoints),
            draw("00_exercise_3.svg", [&] { return drawLine3(functions, lines.P3, lines.Q3); })};
}

} // namespace rt::lesson00
