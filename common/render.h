// Tiles on oneTBB. Each pixel is computed by itself, so the picture has the same bits for any number of threads.
#pragma once

#include <atomic>
#include <functional>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "common/image.h"
#include "common/scene.h"
#include "common/todo.h"

namespace rt
{

struct RenderOptions
{
    int spp = 1;                             ///< samples per pixel; 1 is the pixel's centre
    int threads = 0;                         ///< 0: one a core
    std::function<void(double)> progress;    ///< called now and then, from any thread, with the share done in [0, 1]
    const std::atomic<bool>* stop = nullptr; ///< set it to interrupt; the picture is then incomplete
};

/// Where sample `index` of a pixel lies in it, in [0, 1)². The R2 sequence (Roberts 2018), whose first point is the centre.
template <std::floating_point Real>
std::array<Real, 2> samplePosition(int index)
{
    if (index == 0) return {Real(0.5), Real(0.5)};
    const auto fraction = [index](Real step) {
        const Real x = Real(0.5) + Real(index) * step;
        return x - std::floor(x);
    };
    return {fraction(Real(0.75487766624669276005L)), fraction(Real(0.56984029099805326591L))};
}

/// The colour of pixel (px, py): the mean of its samples.
template <class Tracer, std::floating_point Real>
Vec3<Real> renderPixel(const Scene<Real>& scene, Tracer& tracer, int px, int py, int spp)
{
    Vec3<Real> sum(0);
    for (int i = 0; i < spp; ++i)
    {
        const auto [x, y] = samplePosition<Real>(i);
        sum += tracer.trace(scene.camera.ray(Real(px) + x, Real(py) + y));
    }
    return spp == 1 ? sum : sum / Real(spp);
}

/// The picture of the scene as `Tracer` sees it; a pixel whose exercise is not attempted is magenta.
template <class Tracer, std::floating_point Real>
Image render(const Scene<Real>& scene, int width, int height, const RenderOptions& options)
{
    constexpr int side = 32;
    const int columns = (width + side - 1) / side, tiles = columns * ((height + side - 1) / side);
    Image image(width, height);
    std::atomic<int> done = 0;
    const auto renderTile = [&](int tile) {
        if (options.stop && *options.stop) return;
        Tracer tracer{scene};
        const int left = tile % columns * side, top = tile / columns * side;
        for (int y = top; y < std::min(top + side, height); ++y)
            for (int x = left; x < std::min(left + side, width); ++x) try
                {
                    image.at(x, y) = Vec3<double>(renderPixel(scene, tracer, x, y, options.spp));
                }
                catch (const NotAttempted&)
                {
                    image.at(x, y) = magenta;
                }
        if (options.progress) options.progress(double(++done) / tiles);
    };
    const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] { tbb::parallel_for(0, tiles, renderTile); });
    return image;
}

} // namespace rt
