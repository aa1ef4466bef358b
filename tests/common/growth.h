// How the time of something grows: the same question on any machine, unlike seconds.
#pragma once

#include <algorithm>
#include <ctime>

namespace rt
{

/// CPU time of work(8 n) over that of work(n): about 8 if it is linear, 64 if it is quadratic. The smaller of two runs
/// each, since whatever else the machine does can only add. work(n) should take a millisecond at least.
template <class Work>
double growthByEight(int n, Work work)
{
    const auto cpu = [&](int size) {
        std::clock_t least = 0;
        for (int run = 0; run < 2; ++run)
        {
            const std::clock_t start = std::clock();
            work(size);
            const std::clock_t used = std::max<std::clock_t>(std::clock() - start, 1);
            least = run == 0 ? used : std::min(least, used);
        }
        return double(least);
    };
    const double small = cpu(n);
    return cpu(8 * n) / small;
}

constexpr double aboutLinear = 32; ///< measured are 8 to 15: what no longer fits the cache takes longer

} // namespace rt
