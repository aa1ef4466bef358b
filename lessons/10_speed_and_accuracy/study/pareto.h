// The Pareto front: what is worth choosing.
#pragma once

#include <vector>

namespace rt::lesson10
{

struct Cost
{
    double time = 0;     ///< less is better
    double accuracy = 0; ///< dB, more is better; may be infinite
};

/// Is `a` at least as good as `b` in both, and better in one? A time or accuracy that is NaN dominates nothing.
bool dominates(const Cost& a, const Cost& b);

/// The indices of the points that no other dominates, by time; of equal points the first. Points with NaN are never among them.
std::vector<std::size_t> paretoFront(const std::vector<Cost>& points);

} // namespace rt::lesson10
