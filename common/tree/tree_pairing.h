// Which ray of one tree stands in the place of which ray of another.
#pragma once

#include <vector>

#include "common/tree/ray_tree.h"

namespace rt
{

/// What leaves each node, as indices, in the order of the tree. Total: a link that leads nowhere or to a later node counts
/// as none, so following parents always ends. The last entry, one past the nodes, holds what belongs to no node: the camera
/// ray, orphans and stray shadow rays.
struct TreeLinks
{
    std::vector<int> parent; ///< of each node; nodes.size(): none
    std::vector<std::vector<int>> children, shadows, capped;
};

TreeLinks linksOf(const RayTree& tree);

/// For each thing of one tree the one of the other that stands in its place, or -1.
struct Pairing
{
    std::vector<int> gotOf, expectedOf;
};

struct TreePairing
{
    Pairing nodes, shadows, capped;
};

/// The first rays are a pair; from there on the rays that leave a pair are paired by kind (shadow rays by light), then by
/// direction, then by order. So a missing ray does not shift those after it. Time is linear in the size of both trees.
TreePairing pairUp(const RayTree& expected, const TreeLinks& expectedLinks, const RayTree& got,
                   const TreeLinks& gotLinks);

} // namespace rt
