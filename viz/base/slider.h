// What a slider stands for; how it looks is the strip's business.
#pragma once

#include <string>

namespace rt::viz
{

/// Values at `left` and right end of a track, of `stops` equal intervals; 0: any value between.
struct Slider
{
    double left = 0, right = 1; ///< pixels
    int stops = 0;

    /// In [0, 1], at the nearest stop.
    double at(double x) const;
    /// 0 to `stops`; the nearest one.
    int stopAt(double x) const;
    double x(double position) const { return left + position * (right - left); }
};

/// The throughput below which rays are hidden, for a position in [0, 1]: 0 hides nothing, then from 0.01 % to 100 % in
/// equal factors.
double throughputAt(double position);
double positionOf(double throughput);
/// "0 %", "0.01 %", "2.5 %", "100 %"
std::string percent(double throughput);

} // namespace rt::viz
