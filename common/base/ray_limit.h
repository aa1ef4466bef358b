// How many rays one camera ray may lead to, and where a tracer that is no longer wanted is stopped: both are looked at under
// Scene::intersect and occluded, out of the lessons' sight. With RAYTREE_HEADERS_ONLY nothing is counted.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace rt
{

/// No camera ray leads to more rays than this, itself and shadow rays included: trees that double at each depth would never
/// end. A ray tree of this size takes some 400 MB.
inline constexpr std::int64_t rayLimit = 1'000'000;
inline constexpr const char* rayLimitText = "1,000,000";

/// Thrown out of a tracer by the next ray once its `stop` is set.
struct Stopped : std::runtime_error
{
    Stopped() : std::runtime_error("it was stopped") {}
};

/// Thrown out of a tracer by the first ray too many.
struct TooManyRays : std::runtime_error
{
    TooManyRays() : std::runtime_error("there are too many rays") {}

    /// `what`: "pixel 3,4", "the ray".
    TooManyRays(const std::string& what, int depth)
        : std::runtime_error(
              what + " leads to more than " + rayLimitText + " rays at depth " + std::to_string(depth) +
              ", which is the most that is traced; a smaller depth (--depth) leads to fewer, a cutoff in "
              "the scene too (lesson 07)")
    {
    }
};
inline std::string pixelText(int x, int y)
{
    return "pixel " + std::to_string(x) + "," + std::to_string(y);
}

#ifdef RAYTREE_HEADERS_ONLY

class TraceLimit
{
public:
    explicit TraceLimit(const std::atomic<bool>*, std::int64_t = rayLimit) {}
};
inline void beginCameraRay() {}
inline void countRay() {}
inline void uncountRay() {}

#else

namespace detail
{

/// Of one thread. Rays are counted in slices, so that a ray costs a decrement and a branch.
struct RayCount
{
    static constexpr int mostInSlice = 64;

    int slice = mostInSlice;                                      ///< rays until somebody looks
    int firstSlice = mostInSlice;                                 ///< of a camera ray
    std::int64_t left = std::numeric_limits<std::int64_t>::max(); ///< rays beyond the slice
    std::int64_t first = std::numeric_limits<std::int64_t>::max();
    const std::atomic<bool>* stop = nullptr;

    [[gnu::noinline, gnu::cold]] void look()
    {
        slice = 0; // who catches what is thrown and goes on, gets it again
        if (stop && *stop) throw Stopped();
        if (left <= 0) throw TooManyRays();
        const int next = int(std::min<std::int64_t>(mostInSlice, left));
        left -= next;
        slice = next - 1;
    }
};

inline constinit thread_local RayCount rayCount;

} // namespace detail

/// As long as it lives, what this thread traces ends with Stopped once `stop` is set, and with TooManyRays when a camera ray
/// leads to more than `most` rays. Elsewhere a thread traces without end.
class TraceLimit
{
public:
    explicit TraceLimit(const std::atomic<bool>* stop, std::int64_t most = rayLimit) : before(detail::rayCount)
    {
        auto& count = detail::rayCount;
        count.stop = stop;
        count.firstSlice = int(std::min<std::int64_t>(detail::RayCount::mostInSlice, most));
        count.first = most - count.firstSlice;
        count.slice = count.firstSlice;
        count.left = count.first;
    }
    ~TraceLimit() { detail::rayCount = before; }
    TraceLimit(const TraceLimit&) = delete;
    TraceLimit& operator=(const TraceLimit&) = delete;

private:
    detail::RayCount before;
};

/// The rays that follow belong to another camera ray.
inline void beginCameraRay()
{
    auto& count = detail::rayCount;
    if (count.stop && *count.stop) throw Stopped();
    count.slice = count.firstSlice;
    count.left = count.first;
}

/// Before each ray of a tracer, shadow rays too.
inline void countRay()
{
    if (--detail::rayCount.slice < 0) [[unlikely]]
        detail::rayCount.look();
}

/// Before a ray that only a recorder asks for: pictures and trees end at the same ray.
inline void uncountRay()
{
    ++detail::rayCount.slice;
}

#endif

} // namespace rt
