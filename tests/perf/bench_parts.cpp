// The parts of a picture by themselves: what one call costs. Rays are those of a picture of s5: they hit, graze and miss as in
// earnest. Options are Google Benchmark's.
#include <map>
#include <memory>

#include <benchmark/benchmark.h>

#include "bench_scenes.h"
#include "common/program/guarded_main.h"
#include "common/scene/render.h"
#include "common/tree/tree_recorder.h"
#include "lessons/08_phong/trace.h"

namespace
{

using namespace rt;

constexpr int width = 64, height = 48;

/// A scene, its camera rays, and the shadow rays of what these hit.
template <class Real>
struct World
{
    Scene<Real> scene;
    std::vector<Ray<Real>> rays;
    struct ToLight
    {
        Point<Real> I;
        Vec3<Real> L;
        Real distance;
    };
    std::vector<ToLight> shadows;

    static SceneDescription sized(const char* name)
    {
        SceneDescription description = perf::benchScene(name);
        perf::setSize(description, width, height);
        return description;
    }

    explicit World(const char* name) : scene(sized(name))
    {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
            {
                rays.push_back(scene.camera.ray(Real(x) + Real(0.5), Real(y) + Real(0.5)));
                if (const auto hit = scene.intersect(rays.back()))
                    for (const auto& light : scene.lights)
                    {
                        const Vec3<Real> L = light.position - hit->I;
                        shadows.push_back({hit->I, unit(L), length(L)});
                    }
            }
    }

    /// Made once; benchmarks run one after the other.
    static const World& of(const char* name)
    {
        static std::map<std::string, std::unique_ptr<World>> worlds;
        auto& world = worlds[name];
        if (!world) world = std::make_unique<World>(name);
        return *world;
    }
};

/// Calls `part` with each of `inputs` in turn.
template <class Inputs, class Part>
void each(benchmark::State& state, const Inputs& inputs, const Part& part)
{
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state)
    {
        benchmark::DoNotOptimize(part(inputs[i]));
        if (++i == inputs.size()) i = 0;
    }
}

template <class Real>
void sphere(benchmark::State& state)
{
    const auto& world = World<Real>::of("s5");
    each(state, world.rays,
         [&](const auto& ray) { return Shapes<Real>::intersectSphere(ray, world.scene.spheres[55]); });
}

template <class Real>
void intersect(benchmark::State& state, const char* name)
{
    const auto& world = World<Real>::of(name);
    each(state, world.rays, [&](const auto& ray) { return world.scene.intersect(ray); });
}

template <class Real>
void occluded(benchmark::State& state, const char* name)
{
    const auto& world = World<Real>::of(name);
    each(state, world.shadows, [&](const auto& s) { return world.scene.occluded(s.I, s.L, s.distance); });
}

template <class Real>
void trace(benchmark::State& state, const char* name)
{
    const auto& world = World<Real>::of(name);
    lesson08::Tracer<Real> tracer{world.scene};
    each(state, world.rays, [&](const auto& ray) { return tracer.trace(ray); });
}

template <class Real>
void recordTree(benchmark::State& state, const char* name)
{
    const auto& world = World<Real>::of(name);
    each(state, world.rays, [&](const auto& ray) {
        RayTree tree;
        tree.maxDepth = world.scene.settings.maxDepth;
        lesson08::Tracer<Real, TreeRecorder<Real>> tracer{world.scene, {tree, world.scene}};
        tracer.trace(ray);
        return tree.nodes.size();
    });
}

/// One node: eight spheres in eight boxes, with leaves that do nothing. Two nodes at most: the boxes of the leaves too.
template <class Number>
void node(benchmark::State& state)
{
    const auto& world = World<Number>::of("s5");
    std::vector<Box<Number>> boxes;
    for (std::size_t i = 50; i < 58; ++i)
    {
        const auto& s = world.scene.spheres[i];
        boxes.push_back({s.C - Vec3<Number>(s.r), s.C + Vec3<Number>(s.r)});
    }
    const Bvh<Number> tree(boxes, 4 * unitError<Number>);
    each(state, world.rays, [&](const auto& ray) {
        int leaves = 0;
        const auto count = [&](std::size_t) {
            ++leaves;
            return false;
        };
        tree.template visitLeaves<Instructions::baseline>(ray.O, ray.D, infinity<Number>, count);
        return leaves;
    });
}

/// The scalar test of one box that textbooks give, to compare with.
template <class Real>
void box(benchmark::State& state)
{
    const auto& world = World<Real>::of("s5");
    const auto& s = world.scene.spheres[55];
    const Vec3<Real> low = s.C - s.r, high = s.C + s.r;
    each(state, world.rays, [&](const auto& ray) {
        const Vec3<Real> a = (low - ray.O) / ray.D, b = (high - ray.O) / ray.D;
        const Vec3<Real> enter = glm::min(a, b), leave = glm::max(a, b);
        return std::max({enter.x, enter.y, enter.z, Real(0)}) <= std::min({leave.x, leave.y, leave.z});
    });
}

template <class Real>
void add(const std::string& real)
{
    using benchmark::RegisterBenchmark;
    RegisterBenchmark(("sphere/" + real).c_str(), sphere<Real>);
    RegisterBenchmark(("box/" + real).c_str(), box<Real>);
    RegisterBenchmark(("node/" + real).c_str(), node<Real>);
    for (const char* scene : {"s4", "s5", "s6"})
    {
        const std::string end = "/" + std::string(scene) + "/" + real;
        RegisterBenchmark(("intersect" + end).c_str(), intersect<Real>, scene);
        RegisterBenchmark(("occluded" + end).c_str(), occluded<Real>, scene);
        RegisterBenchmark(("trace" + end).c_str(), trace<Real>, scene);
        RegisterBenchmark(("tree" + end).c_str(), recordTree<Real>, scene);
    }
}

int run(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    add<float>("float");
    add<double>("double");
    add<long double>("long-double");
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
