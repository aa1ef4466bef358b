#include "bench_common.h"

#include <ctime>
#include <malloc.h>

#include <nlohmann/json.hpp>

namespace rt::perf
{

double cpuSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double allocatedBytes()
{
    const auto info = mallinfo2();
    return double(info.uordblks) + double(info.hblkhd);
}

std::string json(const SceneDescription& scene, const Measured& m)
{
    const nlohmann::ordered_json line{
        {"program", m.program},
        {"scene", scene.file},
        {"width", scene.camera.width},
        {"height", scene.camera.height},
        {"depth", scene.trace.maxDepth},
        {"spheres", scene.spheres.size()},
        {"lights", scene.lights.size()},
        {"real", m.real},
        {"instructions", m.instructions},
        {"threads", m.threads},
        {"rays",
         {{"camera", m.rays.camera},
          {"shadow", m.rays.shadow},
          {"reflected", m.rays.reflected},
          {"transmitted", m.rays.transmitted}}},
        {"capped", {{"reflected", m.capped.reflected}, {"transmitted", m.capped.transmitted}}},
        {"build_cpu", m.buildCpu},
        {"bytes", m.bytes},
        {"cpu", m.cpu},
        {"wall", m.wall}};
    return line.dump();
}

} // namespace rt::perf
