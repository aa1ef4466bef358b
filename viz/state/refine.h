// A picture that is coarse at once and gets finer: what the thread that paints hands to the one that shows.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "viz/state/tree_source.h"

namespace rt::viz
{

/// A picture of which so far only every `every`-th pixel each way has been traced.
struct CoarsePicture
{
    Image image; ///< complete: each pixel that is missing is as the nearest one that is there
    int every = 1;
};

/// Pixels each way, a power of two and at least 8, of the first picture: no more than some 8000 are then traced.
int coarsestFor(int width, int height);

/// Fills the gaps between the pixels whose x and y are multiples of `every`, with blocks around them.
Image inBlocks(const Image& traced, int every);

/// Between two threads: a newer picture replaces one that nobody has taken.
class CoarsePictures
{
public:
    void put(CoarsePicture picture);
    /// The newest, once; waits at most that long for it.
    std::optional<CoarsePicture> take(std::chrono::milliseconds patience);

    /// The first picture has been shown, or nobody waits for it any more.
    void goOn();
    /// Until then, or until `stop` is set.
    void awaitGoOn(const std::atomic<bool>* stop);

private:
    std::mutex mutex;
    std::condition_variable arrived;
    std::optional<CoarsePicture> newest;
    bool goesOn = false;
};

/// The source's picture, with the same bits as without passes; the coarser ones are put on the way. After the first it leaves
/// the processor to whoever shows it, until told to go on. A source that makes no passes puts none. Throws what the source
/// throws.
Image paintInPasses(const TreeSource& source, const SceneDescription& scene, RenderOptions options,
                    CoarsePictures& pictures);

} // namespace rt::viz
