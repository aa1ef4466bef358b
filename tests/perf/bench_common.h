// What the measuring programs share: which scene, how large, and the line of JSON they end with.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "bench_scenes.h"
#include "common/files/picture_file.h"
#include "common/program/cli.h"

namespace rt::perf
{

struct SceneOptions
{
    std::string scene, size, out;
    int depth = -1, lights = 0, repeat = 1;
};

inline void addSceneOptions(CommandLine& app, SceneOptions& options)
{
    app.option("scene", options.scene, "s1 .. s6, s5:N, s6:LEVELS or a file").required().type("SCENE");
    app.option("--size", options.size, "size of the picture in pixels; default: the scene's").type("WxH");
    app.option("--depth", options.depth, "MAXDEPTH; default: the scene's").range(0, 1024).type("N");
    app.option("--lights", options.lights, "this many lights; default: the scene's").range(1, 4096).type("N");
}

inline SceneDescription chosenScene(const SceneOptions& options)
{
    SceneDescription scene = benchScene(options.scene);
    if (!options.size.empty())
    {
        int width = 0, height = 0, read = 0;
        if (std::sscanf(options.size.c_str(), "%dx%d%n", &width, &height, &read) != 2 ||
            std::size_t(read) != options.size.size() || width < 1 || height < 1 || width > 16384 || height > 16384)
            throw UsageError("--size",
                             "expected WxH, each from 1 to 16384, as in 640x480; got \"" + options.size + '"');
        setSize(scene, width, height);
    }
    if (options.depth >= 0) scene.trace.maxDepth = options.depth;
    if (options.lights > 0) setLights(scene, options.lights);
    return scene;
}

struct RayCounts
{
    long camera = 0, shadow = 0, reflected = 0, transmitted = 0;

    void add(RayKind kind)
    {
        ++(kind == RayKind::camera ? camera : kind == RayKind::reflected ? reflected : transmitted);
    }
    long all() const { return camera + shadow + reflected + transmitted; }
};

struct Measured
{
    std::string program, real, instructions;
    int threads = 1;
    RayCounts rays = {};
    RayCounts capped = {};                   ///< rays that were not followed, since they were too deep
    double buildCpu = 0;                     ///< seconds to make the scene, on all threads
    double bytes = 0;                        ///< memory that the scene keeps
    std::vector<double> cpu = {}, wall = {}; ///< seconds of each picture
};

/// Seconds of CPU time of this process, all its threads.
double cpuSeconds();

/// Bytes that are allocated now.
double allocatedBytes();

/// One line of JSON.
std::string json(const SceneDescription& scene, const Measured& measured);

/// A measuring program: options, scene, measure(scene), its line of JSON.
template <class Measure>
int runBench(CommandLine& app, int argc, char** argv, SceneOptions& options, const Measure& measure)
{
    addSceneOptions(app, options);
    app.option("--repeat", options.repeat, "pictures that are measured").range(1, 1000).showsDefault();
    app.option("--out", options.out, "write the picture: linear if .exr").type("FILE");
    return runMain(app, argc, argv, [&] {
        if (!options.out.empty()) checkWritable(options.out);
        const auto scene = chosenScene(options);
        watchInterrupt();
        const Measured measured = measure(scene);
        if (interrupted()) return int(exitInterrupted);
        std::puts(json(scene, measured).c_str());
        return int(exitDone);
    });
}

} // namespace rt::perf
