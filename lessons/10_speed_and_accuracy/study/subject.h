// A scene with one setting, ready to be rendered, timed and inspected.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "common/scene/render.h"

#include "setting.h"

namespace rt::lesson10
{

/// Of one pixel's first sample; `rays` is of all samples.
struct PixelFacts
{
    PrimitiveId first = noPrimitive; ///< what the camera ray met
    std::uint64_t shape = 0;         ///< of the ray tree: kinds, depths, primitives
    std::int64_t rays = 0;           ///< shadow rays included
    int acne = 0, leaks = 0; ///< rays that were stopped by the surface they leave; that passed what they should meet
};

/// One pass over the rows of a picture, on one thread.
struct Pass
{
    Image image;           ///< as many rows as were asked for
    double cpuSeconds = 0; ///< of this thread
};

class Subject
{
public:
    virtual ~Subject() = default;

    /// The whole picture on all threads.
    virtual Image render(const RenderOptions& options) const = 0;

    /// Every `stride`th row on the calling thread, with the time that it took. Ends early if `stop` is set.
    virtual Pass timedPass(int stride, const std::atomic<bool>& stop) const = 0;

    /// Facts of every pixel of every `stride`th row; without `judge` no acne and no leaks. Empty if there are more than
    /// `mostRays` rays: a tree may grow without end.
    virtual std::optional<std::vector<PixelFacts>> inspect(int stride, bool judge, std::int64_t mostRays,
                                                           const std::atomic<bool>& stop) const = 0;
};

/// Throws std::range_error if a number of the scene does not fit the scalar type, std::invalid_argument for a combination
/// that the study does not have (a poor formula with a poor leaving policy).
std::unique_ptr<Subject> prepare(const SceneDescription& scene, const Setting& setting);

/// CPU time of the calling thread in seconds.
double threadSeconds();

} // namespace rt::lesson10
