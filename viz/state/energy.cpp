#include "viz/state/energy.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace rt::viz
{

Vec3<double> Energy::gathered() const
{
    Vec3<double> sum(0);
    for (const auto& level : depths) sum += level.gathered;
    return sum;
}

Energy energyPerDepth(const RayTree& tree, const std::function<bool(int)>& carries,
                      const std::function<bool(int)>& gathers)
{
    Energy energy;
    std::map<int, DepthEnergy> byDepth; // a file may claim any depth
    for (const auto& node : tree.nodes)
    {
        if (!carries(node.id)) continue;
        if (!isFinite(node.throughput) || !isFinite(node.contribution))
        {
            ++energy.broken;
            continue;
        }
        auto& level = byDepth[node.depth];
        level.depth = node.depth;
        ++level.rays;
        level.weight += node.throughput;
        if (gathers(node.id)) level.gathered += node.contribution;
    }
    for (const auto& entry : byDepth) energy.depths.push_back(entry.second);
    return energy;
}

Energy energyPerDepth(const RayTree& tree)
{
    const auto all = [](int) { return true; };
    return energyPerDepth(tree, all, all);
}

double luminance(const Vec3<double>& color)
{
    return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
}

std::vector<DepthEnergy> grouped(const Energy& energy, std::size_t most)
{
    std::vector<DepthEnergy> groups(energy.depths.begin(),
                                    energy.depths.begin() + std::ptrdiff_t(std::min(most, energy.depths.size())));
    for (std::size_t i = most; i < energy.depths.size(); ++i)
    {
        groups.back().rays += energy.depths[i].rays;
        groups.back().gathered += energy.depths[i].gathered;
    }
    return groups;
}

std::vector<double> cumulativeShares(const Energy& energy)
{
    const double whole = luminance(energy.gathered());
    if (!(whole > 0) || !std::isfinite(whole)) return {};
    std::vector<double> shares;
    double sum = 0;
    for (const auto& level : energy.depths) shares.push_back((sum += luminance(level.gathered)) / whole);
    shares.back() = 1;
    return shares;
}

std::string shareText(const Energy& energy)
{
    constexpr double enough = 0.95;
    const auto shares = cumulativeShares(energy);
    const auto reached = std::find_if(shares.begin(), shares.end(), [](double share) { return share >= enough; });
    if (reached == shares.end()) return "";
    const auto last = std::size_t(reached - shares.begin());
    // Not "100 %" for what is only nearly all.
    const double percent = *reached * 100, rounded = *reached < 1 ? std::min(percent, 99.9) : percent;
    const auto number = rounded > 99 && rounded < 100 ? fmt::format("{:.1f}", rounded) : fmt::format("{:.0f}", rounded);
    const int from = energy.depths.front().depth, to = energy.depths[last].depth;
    if (last == 0) return fmt::format("depth {} gives {} %", from, number);
    return fmt::format("depth {}-{} give {} %", from, to, number);
}

} // namespace rt::viz
