// Tiles on oneTBB. Each pixel is computed by itself, so the picture has the same bits for any number of threads.
#pragma once

#include <atomic>
#include <functional>

#include "common/base/parallel.h"
#include "common/scene/pixel.h"

namespace rt
{

struct RenderOptions
{
    int spp = 1;                               ///< samples per pixel; 1 is the pixel's centre
    int threads = 0;                           ///< 0: one a core
    std::function<void(double)> progress = {}; ///< called now and then, from any thread, with the share done in [0, 1]
    const std::atomic<bool>* stop = nullptr;   ///< set it to interrupt; the picture is then incomplete
    /// A power of two. Above 1 the picture comes in passes: pixels whose x and y are multiples of it, then those of half of
    /// it, until all are there.
    int coarsest = 1;
    /// Called after each pass but the last, by the thread that asked for the picture, with what has been traced so far.
    std::function<void(const Image&, int every)> passed = {};
};

/// The picture of the scene as `Tracer` sees it; a pixel whose exercise is not attempted is magenta. Throws TooManyRays, naming
/// the first pixel that was found to lead to more than rayLimit.
template <class Tracer, std::floating_point Real>
Image render(const Scene<Real>& scene, int width, int height, const RenderOptions& options)
{
    Image image(width, height);
    const int tiles = tilesOf(image);
    std::atomic<bool> ended = false; // by an exception
    const auto isStopped = [&] { return options.stop && *options.stop; };
    const auto shareOf = [](int every) { return every > 0 ? 1.0 / (double(every) * every) : 0.0; };
    Workers workers(options.threads);
    // Each pixel is traced in one pass only.
    for (Pass pass{.every = options.coarsest}; pass.every >= 1; pass = {pass.every / 2, pass.every})
    {
        std::atomic<int> done = 0;
        const auto one = [&](int tile) {
            if (isStopped()) return;
            try
            {
                renderTile<Tracer>(image, tile, scene, options.spp, pass, options.stop, &ended);
            }
            catch (...)
            {
                ended = true; // oneTBB begins no more tiles, but waits for those that are under way
                throw;
            }
            const double before = shareOf(pass.traced), now = shareOf(pass.every);
            if (options.progress) options.progress(before + (now - before) * (double(++done) / tiles));
        };
        workers.forEach(tiles, one);
        if (isStopped()) break;
        if (options.passed && pass.every > 1) options.passed(image, pass.every);
    }
    return image;
}

} // namespace rt
