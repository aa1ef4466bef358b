#include "pairs.h"

#include <future>
#include <thread>

#include "lessons/programs/entries.h"
#include "reference.h"

namespace rt::lesson09
{

std::span<const Limitation> limitations()
{
    constexpr int upToMaxDepth = std::numeric_limits<int>::max();
    static constexpr Limitation all[] = {
        {.name = "shadows",
         .scene = "lessons/09_limitations/scenes/shadows.toml",
         .left = "a point light: a point is in its shadow or it is not, so all edges are sharp",
         .right = "a lamp with a size: shadows grow softer with the distance from what casts them",
         .method = "distribution ray tracing (Cook, Porter, Carpenter 1984)",
         .lightRadius = 1.0,
         .spp = 256},
        {.name = "indirect",
         .scene = "lessons/09_limitations/scenes/indirect.toml",
         .left = "direct light only: shadows are black, and what is white stays white",
         .right = "light from wall to wall: shadows are filled, and colours bleed onto what stands beside them",
         .method = "path tracing (Kajiya 1986), radiosity (Goral et al. 1984)",
         .lightRadius = 0.25,
         .spp = 256,
         .bounces = upToMaxDepth},
        {.name = "caustic",
         .scene = "lessons/09_limitations/scenes/caustic.toml",
         .left = "glass blocks the shadow ray: it casts the shadow of a stone",
         .right = "glass is a lens: it gathers the lamp's light into bright spots within its shadow",
         .method = "photon mapping (Jensen 1995)",
         .lightRadius = 1.5,
         .spp = 1024,
         .bounces = 1},
        {.name = "glossy",
         .scene = "lessons/09_limitations/scenes/glossy.toml",
         .left = "gloss reflects lamps only: without one in sight a glossy floor looks matt",
         .right = "gloss reflects all that is there, the more blurred the farther it is away",
         .method = "distribution ray tracing (Cook, Porter, Carpenter 1984)",
         .lightRadius = 0.5,
         .spp = 256,
         .lobes = true},
        {.name = "aliasing",
         .scene = "lessons/09_limitations/scenes/aliasing.toml",
         .left = "one ray a pixel: what is smaller turns into patterns that are not there, edges into stairs",
         .right = "many rays a pixel: what is smaller turns into its mean, and edges are smooth",
         .method = "supersampling (Whitted 1980 did it adaptively)",
         .lightRadius = 0.25,
         .spp = 256,
         .onlySamples = true},
    };
    return all;
}

const Limitation* findLimitation(const std::string& name)
{
    for (const auto& limitation : limitations())
        if (limitation.name == name) return &limitation;
    return nullptr;
}

Image lessonPicture(const SceneDescription& scene, const Limitation& limitation, const RenderOptions& options)
{
    RenderOptions own = options;
    if (limitation.onlySamples) own.spp = 1;
    return lesson08::entry.render(scene, Precision::doubled, own);
}

Image referencePicture(const SceneDescription& description, const Limitation& limitation, double lightRadius,
                       const RenderOptions& options)
{
    if (limitation.onlySamples) return lesson08::entry.render(description, Precision::doubled, options);

    SceneDescription described = description;
    // Light goes through glass on its own here; a shadow ray that goes through as well would count it twice.
    if (limitation.bounces > 0) described.trace.shadowThroughGlass = ShadowThroughGlass::block;
    const Scene<double> scene(described);
    const Beyond beyond{lightRadius, limitation.bounces, limitation.lobes};
    Image image(described.camera.width, described.camera.height);

    const auto pixel = [&](int x, int y) {
        const auto seed = std::uint64_t(y) * std::uint64_t(image.width) + std::uint64_t(x);
        Reference reference{scene, beyond, std::mt19937_64(seed)};
        return renderPixel(scene, reference, x, y, options.spp);
    };
    const auto stopped = [&] { return options.stop && *options.stop; };
    std::atomic<int> next = 0, done = 0;
    const auto work = [&] {
        const TraceLimit limit(options.stop);
        for (int y; (y = next++) < image.height && !stopped();)
        {
            for (int x = 0; x < image.width && !stopped(); ++x) image.at(x, y) = pixel(x, y);
            if (options.progress) options.progress(double(++done) / image.height);
        }
    };
    const int threads = options.threads > 0 ? options.threads : std::max(1, int(std::thread::hardware_concurrency()));
    std::vector<std::future<void>> workers;
    for (int i = 0; i < threads; ++i) workers.push_back(std::async(std::launch::async, work));
    for (auto& worker : workers) try
        {
            worker.get();
        }
        catch (const Stopped&)
        {
            // The caller knows; the others stop as well.
        }
    return image;
}

Image sideBySide(const Image& left, const Image& right)
{
    constexpr int gap = 4;
    Image both(left.width + gap + right.width, left.height);
    std::fill(both.pixels.begin(), both.pixels.end(), Vec3<double>(1));
    for (int y = 0; y < left.height; ++y)
    {
        for (int x = 0; x < left.width; ++x) both.at(x, y) = left.at(x, y);
        for (int x = 0; x < right.width; ++x) both.at(left.width + gap + x, y) = right.at(x, y);
    }
    return both;
}

} // namespace rt::lesson09
