// A node of the ray tree explains itself: the lecture's formulas, symbolic and with the node's own numbers.
#pragma once

#include <string>
#include <vector>

#include "common/ray_tree.h"
#include "common/scene_description.h"

namespace rt
{

/// One formula of the lecture at one node.
struct Formula
{
    std::string title;    ///< "Reflected vector"
    std::string symbolic; ///< "R = D - 2(D.N)N"
    std::string numbers;  ///< the same with this node's numbers, and the result; may have several lines
};

/// The formulas that produced nodes[node], in the order in which the lesson used them. `scene` must be the scene that the
/// tree was recorded in (for the colours of its lights); lights that it does not have are left out.
std::vector<Formula> explainNode(const RayTree& tree, const SceneDescription& scene, int node);

/// All nodes of the tree, as text.
std::string explain(const RayTree& tree, const SceneDescription& scene);

} // namespace rt
