#include "viz/drawing/lamps.h"

#include <algorithm>
#include <numeric>

namespace rt::viz
{

std::vector<bool> namedLamps(const SceneDescription& scene, const vec3& at)
{
    const auto& lamps = scene.lights;
    std::vector<bool> named(lamps.size(), lamps.size() <= mostNamedLamps);
    if (lamps.size() <= mostNamedLamps) return named;
    std::vector<double> strength;
    for (const auto& lamp : lamps)
    {
        const vec3 way = lamp.position - at;
        const double light = largestChannel(lamp.color) / std::max(1e-300, dot(way, way));
        strength.push_back(light > 0 ? light : 0); // nor NaN
    }
    std::vector<std::size_t> order(lamps.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return strength[a] > strength[b]; });
    for (std::size_t i = 0; i < mostNamedLamps; ++i) named[order[i]] = true;
    return named;
}

} // namespace rt::viz
