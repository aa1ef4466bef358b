// The fields of two rays that stand in the same place, compared in the order in which a tracer computes them.
#pragma once

#include "common/tree/tree_diff.h"

namespace rt
{

// Each gives the first difference, with `field`, `expected`, `got` and `angle` set, or nothing.

/// What is known when a ray has been followed to its hit.
std::optional<TreeDifference> compareFollowed(const RayTree::Node& expected, const RayTree::Node& got,
                                              const TreeTolerance& tolerance);
/// What a point sends without its children.
std::optional<TreeDifference> compareOwn(const RayTree::Node& expected, const RayTree::Node& got,
                                         const TreeTolerance& tolerance);
/// What is known when a ray returns.
std::optional<TreeDifference> compareReturned(const RayTree::Node& expected, const RayTree::Node& got,
                                              const TreeTolerance& tolerance);
/// What a child brings: its weight and its radiance.
std::optional<TreeDifference> compareBrought(const RayTree::Node& expected, const RayTree::Node& got,
                                             const TreeTolerance& tolerance);
/// `from`: the node that the expected shadow ray leaves.
std::optional<TreeDifference> compareShadows(const RayTree::Shadow& expected, const RayTree::Shadow& got,
                                             const RayTree::Node& from, const TreeTolerance& tolerance);
std::optional<TreeDifference> compareCapped(const RayTree::Capped& expected, const RayTree::Capped& got,
                                            const TreeTolerance& tolerance);

/// A tree that knows its steps knows which rays never returned: an exercise is not finished.
bool neverReturned(const RayTree::Node& node);

/// "(0.5, 0.25, 1)".
std::string shortText(const Vec3<double>& v);

} // namespace rt
