// What the command lines of all programs share.
#pragma once

#include <string>

#include "common/program/command_line.h"
#include "common/program/lesson_entry.h"
#include "common/program/program.h"

namespace rt
{

/// The options that choose what is traced: all programs that trace have them.
struct TraceOptions
{
    std::string scene;
    std::string size; ///< "WxH"; empty: the scene's
    std::string real = "double";
    int depth = -1;      ///< -1: the scene's
    std::string fresnel; ///< empty: the scene's
    int spp = 1;
    int threads = 0;
    std::string pixel; ///< "x,y"
    std::string ray;   ///< "ox,oy,oz,dx,dy,dz"

    Precision precision() const;
    bool hasProbe() const { return !pixel.empty() || !ray.empty(); }
};

void addTraceOptions(CommandLine& app, TraceOptions& options);

/// Loads the scene and lets the options override it: size, depth, fresnel. A pixel of the file moves with a new size.
/// Throws SceneError, or UsageError when an option makes no sense.
SceneDescription loadScene(const TraceOptions& options);

/// The pixel or ray that was asked for, or the scene's own pixel. Throws UsageError.
Probe probe(const TraceOptions& options, const SceneDescription& scene);

/// Numbers separated by commas, exactly `count` of them, all finite. Throws UsageError naming the option.
std::vector<double> numbers(const std::string& text, std::size_t count, const std::string& option);

/// Runs a program's work. Every exception becomes one sentence on standard error and an exit code, and signals end it
/// (interrupt.h).
int runMain(CommandLine& app, int argc, char** argv, const std::function<int()>& work);

} // namespace rt
