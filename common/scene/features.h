// Model only what a scene requires: what a scene asks for, what a lesson models, and what is missing between them.
#pragma once

#include <string>
#include <vector>

#include "common/scene/scene_description.h"

namespace rt
{

/// In the order in which the lessons bring them.
enum class Feature
{
    direct,     ///< lights, shadows, diffuse surfaces
    mirror,     ///< pure specular surfaces
    partial,    ///< partly specular surfaces
    sky,        ///< light from outside the scene
    refraction, ///< dielectrics
    fresnel,    ///< the reflected share of a dielectric
    policies,   ///< energy cutoff, and what a capped ray returns
    phong       ///< glossy highlights
};

/// "mirrors", "partial reflection", ...: as it stands in a sentence.
const char* name(Feature feature);

struct Requirement
{
    Feature feature;
    std::string because; ///< "material 'glass' has an index of refraction (ior = 1.5)"
};

/// What the scene requires, in the order of Feature, each with its first reason. Materials that no object uses count for
/// nothing.
std::vector<Requirement> required(const SceneDescription& scene);

using FeatureSet = std::vector<Feature>;

/// The requirements that `models` does not contain.
std::vector<Requirement> missing(const std::vector<Requirement>& requirements, const FeatureSet& models);

} // namespace rt
