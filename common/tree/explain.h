// A node of the ray tree explains itself: the lecture's formulas, symbolic and with the node's own numbers.
#pragma once

#include <string>
#include <vector>

#include "common/scene/scene_description.h"
#include "common/tree/ray_tree.h"

namespace rt
{

/// One formula of the lecture at one node.
struct Formula
{
    std::string title;    ///< "Reflected vector"
    std::string symbolic; ///< "R = D - 2(D.N)N"
    std::string numbers;  ///< the same with this node's numbers, and the result; may have several lines
};

/// The lecture's functions themselves, from the lessons that teach them (lessons/programs/formulas.h): an explanation computes nothing
/// with a copy. Those of an exercise are its own, and may be null before the lesson that teaches them, except phong.
struct LectureFormulas
{
    double (*cosSquared2)(double cos1, double n1, double n2);
    double (*fresnel)(double cos1, double n1, double n2);
    double (*schlick)(double cos1, double n1, double n2);
    double (*phong)(const Vec3<double>& L, const Vec3<double>& N, const Vec3<double>& V, const Material<double>& mat);
};

/// The formulas that produced nodes[node], in the order in which the lesson used them. `scene` must be the scene that the
/// tree was recorded in (for the colours of its lights); lights that it does not have are left out.
std::vector<Formula> explainNode(const RayTree& tree, const SceneDescription& scene, const LectureFormulas& lecture,
                                 int node);

/// All nodes of the tree, as text.
std::string explain(const RayTree& tree, const SceneDescription& scene, const LectureFormulas& lecture);

} // namespace rt
