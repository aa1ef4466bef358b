// How much each depth of the recursion carries and brings: what a depth cap trades away.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/tree/ray_tree.h"

namespace rt::viz
{

struct DepthEnergy
{
    int depth = 0;
    int rays = 0;
    /// Sum of the rays' throughputs: what the pixel would gain if radiance 1 came along every ray of this depth.
    Vec3<double> weight{0, 0, 0};
    /// Sum of the rays' contributions: what the pixel does gain from the surfaces that these rays hit, linear radiance.
    Vec3<double> gathered{0, 0, 0};
};

struct Energy
{
    std::vector<DepthEnergy> depths; ///< those that occur, ascending
    int broken = 0;                  ///< rays left out because a number of theirs is not finite

    /// Over all depths: for a whole tree the root's radiance, but for rounding.
    Vec3<double> gathered() const;
};

/// Sums over the rays for which `carries` holds, and of these the contributions of those for which `gathers` holds.
Energy energyPerDepth(const RayTree& tree, const std::function<bool(int node)>& carries,
                      const std::function<bool(int node)>& gathers);
/// Of the whole tree.
Energy energyPerDepth(const RayTree& tree);

/// Brightness of a linear RGB colour (Rec. 709 primaries): 0.2126 r + 0.7152 g + 0.0722 b.
double luminance(const Vec3<double>& color);

/// The same with at most `most` (> 0) entries: the last stands for all from its depth on, with the sum of their rays and
/// what they gather, and with the weight that is carried as far as to its own depth.
std::vector<DepthEnergy> grouped(const Energy& energy, std::size_t most);

/// The part of the luminance gathered down to each of energy.depths; the last is 1. Empty if nothing was gathered.
std::vector<double> cumulativeShares(const Energy& energy);

/// "depth 0-2 give 97 %": the first depths that together give at least 95 %. Empty if nothing was gathered.
std::string shareText(const Energy& energy);

} // namespace rt::viz
