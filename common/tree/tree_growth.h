// How large the ray trees of a scene can get, before anything is traced.
#pragma once

#include <string>

#include "common/scene/features.h"

namespace rt
{

/// One sentence if a pixel of the scene can lead to more rays than are traced (ray_limit.h), since what a lesson with these
/// features sees splits rays at each depth; else empty. With a cutoff nothing is foretold: it bounds the tree in its own way.
std::string growthWarning(const SceneDescription& scene, const FeatureSet& models);

/// A sentence if [trace] cutoff is above all light there is, so that not even camera rays are traced; "" otherwise.
std::string cutoffWarning(const SceneDescription& scene, const FeatureSet& models);

} // namespace rt
