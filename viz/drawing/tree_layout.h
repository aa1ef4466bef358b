// Where the nodes of the ray tree lie in its drawing.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "common/tree/ray_tree.h"

namespace rt::viz
{

enum class ItemKind
{
    ray,
    shadow,
    notFollowed ///< MAXDEPTH or cutoff
};

struct TreeItem
{
    ItemKind kind = ItemKind::ray;
    int node = 0;    ///< the ray itself, or the one at whose hit point the shadow ray or the ray not followed starts
    int index = -1;  ///< into tree.shadows or tree.capped; -1 for rays
    int parent = -1; ///< item; less than the item's own index; -1 for roots
    int level = 0;   ///< rows from the root, not what the ray says of its depth
    double x = 0, y = 0;
};

/// A node-link drawing in abstract units: 1 is the least distance between rays of one level, and between levels. y grows
/// downwards. Shadow rays, and rays that were not followed, are leaves; they may stand `tightest` apart.
struct TreeLayout
{
    std::vector<TreeItem> items;    ///< in preorder: what happened first comes first
    std::vector<int> ofNode;        ///< item of each node
    std::vector<int> ofShadow;      ///< of each of tree.shadows
    std::vector<int> ofNotFollowed; ///< of each of tree.capped
    double width = 0, height = 0;   ///< items lie within [0, width] x [0, height]
    int levels = 0;
    bool sideways = false; ///< grows to the right rather than downwards
    /// The least distances within a level: between rays, between a ray and a shadow ray, between shadow rays. At most
    /// `farthest`, which also stands for none. What is not followed counts as a ray.
    double rayGap = farthest, mixedGap = farthest, shadowGap = farthest;
    static constexpr double farthest = 4;

    /// The items of each level, one level after the other, in the order of their positions.
    std::vector<int> byLevel;
    std::vector<std::size_t> levelStart; ///< levels + 1 positions in byLevel
};

inline constexpr double tightest = 0.7;

/// Every subtree takes a span of its own; a parent stands over the middle of its children. Time and memory grow in
/// proportion to the tree, whatever its depth. `sideways`: the root is on the left. Nodes without a parent are roots.
TreeLayout layOutTree(const RayTree& tree, bool sideways = false);

/// The same drawing turned over the diagonal.
TreeLayout turned(TreeLayout layout);

/// Would this layout give its nodes more room if it were turned, in a pane of that width over height? Texts stand beside
/// leaves better than below them: when in doubt the tree grows sideways.
bool isBetterTurned(const TreeLayout& layout, double width, double height);

/// The item whose centre is nearest to (x, y), of those within the ellipse of these radii; -1: none.
int itemAt(const TreeLayout& layout, double x, double y, double radiusX, double radiusY);

/// Items whose centres lie within the rectangle, ends included; level by level.
std::vector<int> itemsWithin(const TreeLayout& layout, double left, double top, double right, double bottom);

/// Parent, its parent, and so on to the root.
std::vector<int> ancestorsOf(const TreeLayout& layout, int item);

/// How the drawing lies in its pane: pixels, y up from the lower left. Width and height have their own scales, so that a
/// tree of 10,000 leaves and ten levels fills the pane; neither grows beyond the `largest`.
class TreeView
{
public:
    struct Frame
    {
        double width = 1, height = 1;                    ///< of the pane
        double left = 0, right = 0, top = 0, bottom = 0; ///< free margins
        double fitted = 60, largest = 120;               ///< pixels a unit: at most, when fitted and when zoomed
    };

    /// Shows everything.
    void fit(const TreeLayout& layout, const Frame& frame);
    /// The tree or the pane has changed: fits again unless the user has zoomed; then nodes stay as far apart.
    void adapt(const TreeLayout& layout, const Frame& frame);
    /// Zooms about a point of the pane, which stays where it is, between what fits and the largest.
    void zoomAt(double factor, double paneX, double paneY);
    void pan(double dx, double dy);
    /// Brings a point of the drawing to the middle, at least that many pixels a unit.
    void centre(double x, double y, double pixelsPerUnit);
    /// Brings a point of the drawing within the margins if it is outside.
    void reveal(double x, double y);

    std::array<double, 2> toPane(double x, double y) const { return {left + x * unitX(), top - y * unitY()}; }
    std::array<double, 2> toTree(double paneX, double paneY) const
    {
        return {(paneX - left) / unitX(), (top - paneY) / unitY()};
    }
    double unitX() const { return std::min(fitX * zoom, std::max(fitX, frame.largest)); } ///< pixels, > 0
    double unitY() const { return std::min(fitY * zoom, std::max(fitY, frame.largest)); }
    bool isZoomed() const { return zoomed; }

private:
    Frame frame;
    double treeWidth = 0, treeHeight = 0;
    double fitX = 1, fitY = 1, zoom = 1;
    double left = 0, top = 0; // of the root's corner, in the pane
    bool zoomed = false;

    double mostZoom() const { return std::max(1.0, frame.largest / std::min(fitX, fitY)); }
    void keepInside();
};

} // namespace rt::viz
