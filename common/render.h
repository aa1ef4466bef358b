// Tiles on oneTBB. Each pixel is computed by itself, so the picture has the same bits for any number of threads.
#pragma once

#include <atomic>
#include <functional>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "common/pixel.h"

namespace rt
{

struct RenderOptions
{
    int spp = 1;                             ///< samples per pixel; 1 is the pixel's centre
    int threads = 0;                         ///< 0: one a core
    std::function<void(double)> progress;    ///< called now and then, from any thread, with the share done in [0, 1]
    const std::atomic<bool>* stop = nullptr; ///< set it to interrupt; the picture is then incomplete
};

/// The picture of the scene as `Tracer` sees it; a pixel whose exercise is not attempted is magenta.
template <class Tracer, std::floating_point Real>
Image render(const Scene<Real>& scene, int width, int height, const RenderOptions& options)
{
    Image image(width, height);
    const int tiles = tilesOf(image);
    std::atomic<int> done = 0;
    const auto one = [&](int tile) {
        if (options.stop && *options.stop) return;
        renderTile<Tracer>(image, tile, scene, options.spp);
        if (options.progress) options.progress(double(++done) / tiles);
    };
    const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] { tbb::parallel_for(0, tiles, one); });
    return image;
}

} // namespace rt
