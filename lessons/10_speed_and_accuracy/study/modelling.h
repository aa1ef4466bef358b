// Model only what a scene requires: what does it cost to model more?
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "common/program/lesson_entry.h"

#include "study.h"

namespace rt::lesson10
{

/// One lesson on one scene, against the smallest lesson that suffices.
struct Modelled
{
    int lesson = 0;
    double cpuSeconds = 0;       ///< the minimum of interleaved rounds, one thread
    double ratio = 1;            ///< of the smallest lesson's time
    bool sameBits = true;        ///< as the smallest lesson's picture
    std::size_t bytesALevel = 0; ///< of stack, for each level of the recursion that was seen; 0: nothing recursed
};

struct ModelledScene
{
    std::string scene; ///< file, relative to the project
    int width = 0, height = 0;
    std::vector<Modelled> lessons{}; ///< the smallest that suffices first, lesson 08 last
};

/// All scene files of lessons 01 to 10, relative to the project.
std::vector<std::string> shippedScenes();

/// Times the smallest lesson, all between (`ladder`) and lesson 08. Empty if it was stopped.
std::optional<ModelledScene> model(const SceneDescription& scene, bool ladder, int rounds, double seconds,
                                   const std::atomic<bool>& stop);

/// Bytes of stack that a lesson's `trace` takes for each level of depth, at most, on rays of the scene.
std::size_t stackALevel(int lesson, const SceneDescription& scene);

} // namespace rt::lesson10
