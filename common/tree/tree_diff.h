// Where two ray trees begin to differ: what the comparison in the viewer lights up, and what a student is told first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/tree/ray_tree.h"

namespace rt
{

/// Two numbers agree if they are equal, both NaN, or finite and |a - b| <= absolute + relative * their size. The size is the
/// larger magnitude of the two for a number and for a channel of a colour, 1 for a component of a direction, and for
/// positions and distances the largest of origin, hit point and t: that is what rounding goes by.
/// The defaults are for two tracers in double. Correct formulas written differently differ by some 1e-16 and every curved
/// surface may enlarge that tenfold; a mistake that is smaller than 1e-9 is none.
struct TreeTolerance
{
    double relative = 1e-9;
    double absolute = 1e-12; ///< scene units or radiance
};

/// For a tree in float against one in double or long double.
TreeTolerance floatAgainstDouble();

struct TreeDifference
{
    /// The kinds from the root: "camera > transmitted > reflected"; "reflected #2" is the second of its kind among its
    /// siblings. "..., shadow ray to light 0" and "..., reflected ray not followed" follow a comma. Long paths are shortened
    /// in the middle.
    std::string path;
    int expectedNode = -1, gotNode = -1; ///< ids; of a ray that is not a node, of the node it leaves; -1: there is none
    int shadowLight = -1;                ///< if it is about a shadow ray: its light
    /// As in the JSON format: "direction", "hit.point", "n1", "fresnel", "visible", "own", "radiance", ...; or "missing ray",
    /// "extra ray", the same with "shadow ray" and "capped ray", "hit" (one meets something, one nothing) or "return" (only
    /// one returns).
    std::string field;
    std::string expected, got;   ///< with as many digits as it takes to tell them apart
    std::optional<double> angle; ///< degrees between two directions or normals
};

/// The first difference in the order in which a tracer computes: a ray before what it hits, a hit before its shadow rays and
/// the rays that leave it, those before the colour that returns. So everything that the named value was computed from agrees.
/// Not compared: what the trees say about themselves (lesson, scene, precision, pixel, MAXDEPTH), source lines, and the
/// order of steps. Any two trees can be compared; empty if they agree.
std::optional<TreeDifference> firstDifference(const RayTree& expected, const RayTree& got,
                                              const TreeTolerance& tolerance = {});

/// For overlays.
struct TreeMatch
{
    std::vector<int> gotOf;      ///< for each node of `expected` the one of `got` in its place; -1: missing
    std::vector<int> expectedOf; ///< for each node of `got`; -1: extra
    /// For each node of `expected`: it is missing, or it, its shadow rays or its rays not followed differ. A colour that
    /// differs only because a child's does is not counted.
    std::vector<bool> differs;
};

TreeMatch matchTrees(const RayTree& expected, const RayTree& got, const TreeTolerance& tolerance = {});

/// "transmitted ray [3] (camera > transmitted): direction expected (..), got (..), 12.3 degrees apart", and on a second line
/// where to look, as far as that can be told.
std::string describe(const TreeDifference& difference);

} // namespace rt
