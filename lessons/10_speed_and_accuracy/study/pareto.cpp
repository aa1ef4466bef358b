#include "pareto.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace rt::lesson10
{

bool dominates(const Cost& a, const Cost& b)
{
    return a.time <= b.time && a.accuracy >= b.accuracy && (a.time < b.time || a.accuracy > b.accuracy);
}

std::vector<std::size_t> paretoFront(const std::vector<Cost>& points)
{
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::erase_if(order, [&](std::size_t i) { return std::isnan(points[i].time) || std::isnan(points[i].accuracy); });
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        if (points[i].time != points[j].time) return points[i].time < points[j].time;
        return points[i].accuracy > points[j].accuracy;
    });
    // From the fastest on, each that is more accurate than all before it.
    std::vector<std::size_t> front;
    for (const auto i : order)
        if (front.empty() || points[i].accuracy > points[front.back()].accuracy) front.push_back(i);
    return front;
}

} // namespace rt::lesson10
