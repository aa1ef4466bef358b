// Whole pictures with lesson 08's tracer on one thread: million rays a second (camera, shadow, reflected and transmitted).
//
//     trace_bench [--size=WxH] [--once] [--real=float|double|long] [--build=SPHERES] [Google Benchmark's options] scene.toml...
//
// --build measures how long the hierarchy over that many random spheres takes, and its bytes.
// --once traces each picture once without the clock, for counting instructions:
//     valgrind --tool=callgrind trace_bench --once --size=128x96 scene.toml
#include <cstdio>
#include <cstring>
#include <memory>
#include <random>

#include <benchmark/benchmark.h>

#include "common/render.h"
#include "common/scene_file.h"
#include "lessons/08_phong/trace.h"

namespace
{

using namespace rt;

struct RayCounter : NoRecorder
{
    static inline long rays = 0;
    void ray(const auto&, const auto&) const { ++rays; }
    void shadow(const auto&, const auto&, const auto&, auto, bool) const { ++rays; }
};

/// The sum of all pixels: the same number for the same picture.
template <class Tracer, class Real>
double picture(const Scene<Real>& scene, int width, int height)
{
    Tracer tracer{scene};
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
        {
            const Vec3<double> color(renderPixel(scene, tracer, x, y, 1));
            sum += color.x + color.y + color.z;
        }
    return sum;
}

template <class Real>
void add(const SceneDescription& description, const char* real, bool once)
{
    const auto scene = std::make_shared<const Scene<Real>>(description);
    const int width = description.camera.width, height = description.camera.height;
    RayCounter::rays = 0;
    const double sum = once ? picture<lesson08::Tracer<Real>>(*scene, width, height)
                            : picture<lesson08::Tracer<Real, RayCounter>>(*scene, width, height);
    std::printf("%s %s: %ld rays, sum of pixels %a\n", description.file.c_str(), real, RayCounter::rays, sum);
    if (once) return;
    benchmark::RegisterBenchmark((description.title + " " + real).c_str(), [=, rays = RayCounter::rays](auto& state) {
        for ([[maybe_unused]] auto _ : state)
            benchmark::DoNotOptimize(picture<lesson08::Tracer<Real>>(*scene, width, height));
        state.counters["rays/s"] = benchmark::Counter(double(rays), benchmark::Counter::kIsIterationInvariantRate);
    })->Unit(benchmark::kMillisecond);
}

/// Building the search over `count` random spheres, and its size.
void addBuild(int count)
{
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> in(-1, 1);
    std::vector<Sphere<double>> spheres;
    for (int i = 0; i < count; ++i)
        spheres.push_back({{in(engine), in(engine), in(engine)}, 1 / std::cbrt(count) / 4, 0});
    const auto build = [spheres](auto& state) {
        std::size_t bytes = 0;
        for ([[maybe_unused]] auto _ : state) bytes = SphereSearch<double>(spheres).bytes();
        state.counters["bytes/sphere"] = double(bytes) / double(spheres.size());
    };
    benchmark::RegisterBenchmark(("build " + std::to_string(count)).c_str(), build)->Unit(benchmark::kMillisecond);
}

} // namespace

int main(int argc, char** argv)
{
    int width = 1024, height = 768;
    bool once = false;
    std::string real = "double";
    benchmark::Initialize(&argc, argv);
    for (int i = 1; i < argc; ++i)
    {
        const std::string argument = argv[i];
        if (std::sscanf(argv[i], "--size=%dx%d", &width, &height) == 2) continue;
        if (argument.rfind("--real=", 0) == 0)
            real = argument.substr(7);
        else if (argument.rfind("--build=", 0) == 0)
            addBuild(std::stoi(argument.substr(8)));
        else if (argument == "--once")
            once = true;
        else
        {
            auto scene = loadScene(argument);
            scene.camera.width = width;
            scene.camera.height = height;
            if (real == "float")
                add<float>(scene, "float", once);
            else if (real == "double")
                add<double>(scene, "double", once);
            else
                add<long double>(scene, "long double", once);
        }
    }
    if (!once) benchmark::RunSpecifiedBenchmarks();
}
