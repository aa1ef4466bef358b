#include "viz/state/refine.h"

#include <algorithm>
#include <utility>

namespace rt::viz
{

namespace
{
constexpr double mostAtOnce = 8192; // pixels
constexpr auto stopTime = std::chrono::milliseconds(5);
} // namespace

int coarsestFor(int width, int height)
{
    int every = 8;
    while (double(width) * height / (double(every) * every) > mostAtOnce) every *= 2;
    return every;
}

Image inBlocks(const Image& traced, int every)
{
    Image filled(traced.width, traced.height);
    const auto nearest = [every](int i, int size) {
        return std::min((i + every / 2) / every, (size - 1) / every) * every;
    };
    for (int y = 0; y < filled.height; ++y)
        for (int x = 0; x < filled.width; ++x)
            filled.at(x, y) = traced.at(nearest(x, traced.width), nearest(y, traced.height));
    return filled;
}

void CoarsePictures::put(CoarsePicture picture)
{
    const std::lock_guard lock(mutex);
    newest = std::move(picture);
    arrived.notify_all();
}

std::optional<CoarsePicture> CoarsePictures::take(std::chrono::milliseconds patience)
{
    std::unique_lock lock(mutex);
    arrived.wait_for(lock, patience, [this] { return newest.has_value(); });
    return std::exchange(newest, std::nullopt);
}

void CoarsePictures::goOn()
{
    const std::lock_guard lock(mutex);
    goesOn = true;
    arrived.notify_all();
}

void CoarsePictures::awaitGoOn(const std::atomic<bool>* stop)
{
    std::unique_lock lock(mutex);
    const auto isDone = [&] { return goesOn || (stop && *stop); };
    while (!isDone()) arrived.wait_for(lock, stopTime, isDone); // nobody notifies of `stop`
}

Image paintInPasses(const TreeSource& source, const SceneDescription& scene, RenderOptions options,
                    CoarsePictures& pictures)
{
    options.coarsest = coarsestFor(scene.camera.width, scene.camera.height);
    options.passed = [&](const Image& traced, int every) {
        pictures.put({inBlocks(traced, every), every});
        if (every == options.coarsest) pictures.awaitGoOn(options.stop);
    };
    return source.render(scene, options);
}

} // namespace rt::viz
