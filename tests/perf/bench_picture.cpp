// Whole pictures with lesson 08's tracer: rays by kind, seconds, bytes, as one line of JSON. One call is one turn of an
// interleaved comparison, which ./raytree bench makes.
#include <chrono>

#include "bench_common.h"
#include "common/files/picture_file.h"
#include "common/program/guarded_main.h"
#include "common/scene/render.h"
#include "lessons/08_phong/trace.h"

namespace
{

using namespace rt;
using namespace rt::perf;

/// Counts what the lesson's own trace tells.
struct RayCounter : NoRecorder
{
    Measured* into = nullptr;
    RayCounter() = default;
    explicit RayCounter(Measured& measured) : into(&measured) {}
    void ray(const auto& ray, const auto&) const { into->rays.add(ray.kind); }
    void shadow(const auto&, const auto&, const auto&, auto, bool) const { ++into->rays.shadow; }
    void capped(const auto& ray) const { into->capped.add(ray.kind); }
    void capped(const auto& ray, const auto&) const { into->capped.add(ray.kind); }
};

struct Options : SceneOptions
{
    std::string real = "double", instructions = "best";
    int threads = 1;
    bool count = false;
};

template <class Real>
void countRays(const Scene<Real>& scene, int width, int height, Measured& into)
{
    lesson08::Tracer<Real, RayCounter> tracer{scene, RayCounter(into)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
        {
            if (interrupted()) return;
            renderPixel(scene, tracer, x, y, 1);
        }
}

template <class Real>
Measured measure(const SceneDescription& description, const Options& options)
{
    Measured measured{
        .program = "raytree", .real = options.real, .instructions = options.instructions, .threads = options.threads};
    const double bytes = allocatedBytes(), start = cpuSeconds();
    Scene<Real> scene(description);
    measured.buildCpu = cpuSeconds() - start;
    measured.bytes = allocatedBytes() - bytes;
    if (options.instructions == "baseline") scene.instructions = Instructions::baseline;
    measured.instructions = scene.instructions == Instructions::baseline ? "baseline" : "avx2";
    const auto& camera = description.camera;
    const RenderOptions how{.spp = 1, .threads = options.threads, .progress = {}, .stop = &interrupted()};
    Image image =
        render<lesson08::Tracer<Real>>(scene, 8, 8, how); // the first one starts threads, which takes milliseconds
    for (int i = 0; i < options.repeat && !interrupted(); ++i)
    {
        const double cpu = cpuSeconds();
        const auto wall = std::chrono::steady_clock::now();
        image = render<lesson08::Tracer<Real>>(scene, camera.width, camera.height, how);
        measured.cpu.push_back(cpuSeconds() - cpu);
        measured.wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count());
    }
    if (options.count) countRays(scene, camera.width, camera.height, measured);
    if (!options.out.empty() && !interrupted()) writeImage(image, options.out);
    return measured;
}

int run(int argc, char** argv)
{
    CommandLine app("Measures one picture with lesson 08's tracer; prints one line of JSON.", "bench_picture");
    Options options;
    app.option("--real", options.real, "scalar type").oneOf({"float", "double", "long-double"}).showsDefault();
    app.option("--instructions", options.instructions, "baseline, or the best that the processor has")
        .oneOf({"baseline", "best"})
        .showsDefault();
    app.option("--threads", options.threads, "threads").range(1, 1024).showsDefault();
    app.flag("--count", options.count, "count rays, in one more picture that is not measured");
    return runBench(app, argc, argv, options, [&](const SceneDescription& scene) {
        return options.real == "float"    ? measure<float>(scene, options)
               : options.real == "double" ? measure<double>(scene, options)
                                          : measure<long double>(scene, options);
    });
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
