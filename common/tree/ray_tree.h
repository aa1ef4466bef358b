// The ray tree of one pixel: plain data in double, indices for links. This is what the viewer, the explanation, the tests
// and the grader read, and what the JSON format (common/tree/ray_tree.schema.json) holds.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "common/base/ray.h"

namespace rt
{

/// Why no child of a node was followed.
enum class End
{
    none,     ///< it has children
    absorbed, ///< a surface that does not send the ray on
    miss,     ///< nothing was hit
    cap,      ///< the next ray would be deeper than max_depth
    cutoff,   ///< the next ray could not have added enough
    black     ///< the surface's colour is black
};

struct RayTree
{
    struct Hit
    {
        double t = 0;
        Vec3<double> point{0, 0, 0};
        Vec3<double> normal{0, 0, 0}; ///< outward, unit
        std::string primitive;        ///< "sphere0": kind, and order in the file among its kind
        std::string material;
        bool inside = false;         ///< the ray arrived from the inner side
        Vec3<double> color{1, 1, 1}; ///< of the material at this point
    };

    /// One ray that was followed. Nodes stand in preorder; node 0 is the camera ray.
    struct Node
    {
        int id = 0;
        int parent = -1;
        RayKind kind = RayKind::camera;
        int depth = 0;
        Vec3<double> origin{0, 0, 0};
        Vec3<double> direction{0, 0, 0};
        std::optional<Hit> hit;
        std::optional<double> n1, n2;       ///< index of refraction before and behind the surface; dielectrics only
        std::optional<double> fresnel;      ///< reflected share that the lesson used
        double weight = 1;                  ///< share of its parent
        Vec3<double> throughput{1, 1, 1};   ///< factor from this node's radiance to the pixel
        Vec3<double> radiance{0, 0, 0};     ///< what it returned
        Vec3<double> own{0, 0, 0};          ///< the part of `radiance` that came from no child
        Vec3<double> contribution{0, 0, 0}; ///< throughput * (own and the stand-ins of capped children)
        End end = End::none;
        bool tir = false;    ///< total internal reflection
        bool orphan = false; ///< its parent could not be told from its depth
        int line = 0;        ///< of the lesson's trace.h where the ray was followed; 0: unknown
        int returnLine = 0;  ///< where it returned
        int step = 0;        ///< order among all that happened (see eventsOf); 0 everywhere: unknown
        int returnStep = 0;  ///< of its return
    };

    struct Shadow
    {
        int node = 0;  ///< the node at whose hit point it starts
        int light = 0; ///< order in the file
        Vec3<double> direction{0, 0, 0};
        double distance = 0;
        bool visible = false;
        Vec3<double> tint{1, 1, 1}; ///< what glass on the way lets through, under shadow_through_glass = "tint"
        struct Blocker
        {
            std::string primitive;
            Vec3<double> point{0, 0, 0};
        };
        std::optional<Blocker> blocker; ///< the nearest thing in the way
        int line = 0;
        int step = 0;
    };

    /// A ray that was not followed, and the colour that stood in for what it would have brought.
    struct Capped
    {
        int node = 0; ///< the node that would have been its parent
        RayKind kind = RayKind::reflected;
        Vec3<double> direction{0, 0, 0};
        double weight = 1;
        Vec3<double> radiance{0, 0, 0};
        End reason = End::cap;
        int line = 0;
        int step = 0;
    };

    int version = 1;
    int lesson = 0;     ///< 0: not one of the lessons
    std::string scene;  ///< file of the scene
    std::string source; ///< file whose lines the nodes name, relative to the project; empty: unknown
    std::string real = "double";
    std::optional<std::array<int, 2>> pixel; ///< x right, y down; empty when a ray was given
    int maxDepth = 0;
    std::vector<Node> nodes;
    std::vector<Shadow> shadows;
    std::vector<Capped> capped;

    /// The ids of the node's children, in the order in which they were followed.
    std::vector<int> childrenOf(int node) const;
    /// The index of refraction that the node's ray comes through, by what the surfaces before said; empty for the camera's.
    std::optional<double> mediumOf(int node) const;
    /// Does the node's surface say another n1? Then some ior_outside is wrong or missing, or surfaces overlap.
    bool isContradicted(int node) const;
    /// The indices into `shadows` of the shadow rays that leave the node's hit point.
    std::vector<int> shadowsOf(int node) const;
};

const char* name(RayKind kind);          ///< "camera", "reflected", "transmitted"
const char* name(End end);               ///< "none", "absorbed", "miss", ...
std::string text(double x);              ///< five digits
std::string text(const Vec3<double>& v); ///< "(x, y, z)", five digits each

/// What the root returns according to the tree alone: each node's own colour plus weight * (hit.color * child) for each
/// child, bottom-up, in Real arithmetic. For float and double these are the bits of nodes[0].radiance.
template <std::floating_point Real>
Vec3<Real> evaluate(const RayTree& tree);

/// One sentence about a node that isContradicted: what its surface says of the medium, and what the surface before said.
std::string contradictionText(const RayTree& tree, int node);

/// The first of them as a warning, with scene and ray; "" if there is none.
std::string firstContradiction(const RayTree& tree);

/// The tree as indented text in the slides' words, one paragraph a ray.
std::string toText(const RayTree& tree);

/// The tree as JSON, format version 1, pretty-printed; numbers read back to the same double, non-finite ones as null.
std::string toJson(const RayTree& tree);

/// Reads what toJson wrote, or another tracer's. Throws std::runtime_error with one sentence that names the place and
/// what was expected. Accepts at most 64 MiB and 2^20 entries of each list; numbers that are null become NaN, and a node
/// without `own` gets what its radiance has beyond its children's.
RayTree rayTreeFromJson(const std::string& json);

} // namespace rt
