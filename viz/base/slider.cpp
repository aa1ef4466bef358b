#include "viz/base/slider.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rt::viz
{

namespace
{

constexpr double decades = 4;        // from 0.01 % to 100 %
constexpr double nothing = 1 / 50.0; // the part of the track that stands for 0

} // namespace

double Slider::at(double x) const
{
    const double position = std::clamp((x - left) / std::max(1.0, right - left), 0.0, 1.0);
    return stops > 0 ? std::round(position * stops) / stops : position;
}

int Slider::stopAt(double x) const
{
    return int(std::lround(at(x) * stops));
}

double throughputAt(double position)
{
    if (!(position > nothing)) return 0;
    return std::pow(10, -decades * (1 - (std::min(position, 1.0) - nothing) / (1 - nothing)));
}

double positionOf(double throughput)
{
    if (!(throughput > 0)) return 0;
    return std::clamp(nothing + (1 - nothing) * (1 + std::log10(throughput) / decades), nothing, 1.0);
}

std::string percent(double throughput)
{
    return fmt::format("{:.2g} %", 100 * throughput) == "1e+02 %" ? "100 %" : fmt::format("{:.2g} %", 100 * throughput);
}

} // namespace rt::viz
