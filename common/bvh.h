// A hierarchy of boxes, four children a node (Wald, Benthin, Boulos: "Getting Rid of Packets", RT 2008). It only tells which
// leaves a ray may meet; what is hit, and where, the shapes' formulas say. So the answer is that of a scan over all shapes.
//
// Boxes are padded for the ray's and the formulas' rounding (Ize, "Robust BVH Ray Traversal", JCGT 2013, does it for the
// former only): a shape whose computed distance is t lies in boxes that the ray is found to enter at t or before.
#pragma once

#include "common/bvh_build.h"
#include "common/lanes.h"

namespace rt
{

template <std::floating_point Real>
class Bvh
{
public:
    static constexpr int width = bvhWidth;

    Bvh() = default; ///< empty: nothing is ever visited

    /// Over the shapes whose boxes are `boxes`. `padding` is the largest error of a hit point, as a share of |O| + `extent`:
    /// the sums of the absolute coordinates of the ray's origin, and the largest such number of a shape.
    Bvh(const std::vector<Box<Real>>& boxes, Real padding, Real extent) : paddingShare(padding), shapesExtent(extent)
    {
        BvhBuilder<Real>{boxes, nodes, leaves}.build();
    }

    bool empty() const { return nodes.empty(); }

    /// Leaf number -> indices into `boxes`; -1 fills up.
    const std::vector<BvhLeaf>& leafShapes() const { return leaves; }

    std::size_t bytes() const { return nodes.capacity() * sizeof(BvhNode<Real>) + leaves.capacity() * sizeof(BvhLeaf); }

    /// The shapes' numbers are in the leaves, for callers that keep their own copy in that order.
    void forgetLeaves() { leaves = {}; }

    /// Calls visit(leaf) for each leaf that the ray may meet in (0, limit], nearest boxes first, until visit returns true.
    /// visit may lower `limit`.
    template <class Visit>
    bool visitLeaves(const Vec3<Real>& O, const Vec3<Real>& D, const Real& limit, Visit&& visit) const
    {
        if (nodes.empty()) return false;
        const Slabs ray(O, D, paddingShare * (std::abs(O.x) + std::abs(O.y) + std::abs(O.z) + shapesExtent));
        struct Entry
        {
            Real t;               ///< where the ray enters
            std::ptrdiff_t child; ///< no narrower than what copies an entry, or each copy waits for the memory
        };
        Entry stack[bvhStackSize];
        stack[0] = {0, 0};
        for (int top = 1; top > 0;)
        {
            const Entry entry = stack[--top];
            if (!(entry.t <= limit)) continue;
            if (entry.child < 0)
            {
                if (visit(std::size_t(~entry.child))) return true;
                continue;
            }
            const BvhNode<Real>& node = nodes[std::size_t(entry.child)];
            Real enters[width], exits[width];
            ray.meet(node, limit, enters, exits);
            const int bottom = top;
            for (int k = 0; k < node.count; ++k)
            {
                if (!(enters[k] <= exits[k])) continue;
                int place = top++;
                for (; place > bottom && stack[place - 1].t < enters[k]; --place) stack[place] = stack[place - 1];
                stack[place] = {enters[k], node.child[k]};
            }
        }
        return false;
    }

private:
    /// The ray, prepared for boxes: where it passes the planes of a padded box, x = (plane - O -+ pad) / D.
    struct Slabs
    {
        struct Axis
        {
            Lanes<Real> inverse, enterO, leaveO; ///< the same number in each lane
            std::ptrdiff_t enter, leave;         ///< the lower or the upper planes, counted from a node's first
        } axes[3];

        Slabs(const Vec3<Real>& O, const Vec3<Real>& D, Real pad)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                // 1 / 0 would make 0 * infinity of a plane through O. This is as steep, and finite.
                constexpr Real least = std::numeric_limits<Real>::min();
                const Real inverse = 1 / (std::abs(D[axis]) < least ? std::copysign(least, D[axis]) : D[axis]);
                axes[axis] = {Lanes<Real>{} + inverse, Lanes<Real>{} + (O[axis] + std::copysign(pad, inverse)),
                              Lanes<Real>{} + (O[axis] - std::copysign(pad, inverse)),
                              (inverse < 0 ? 3 + axis : axis) * width, (inverse < 0 ? axis : 3 + axis) * width};
            }
        }

        // Each step is monotonic: a box around another is never entered later, nor left earlier, to the last bit.
        [[gnu::always_inline]] static void cut(const Axis& axis, const Real* planes, Lanes<Real>& first,
                                               Lanes<Real>& last)
        {
            const auto t = (load(planes + axis.enter) - axis.enterO) * axis.inverse;
            const auto u = (load(planes + axis.leave) - axis.leaveO) * axis.inverse;
            first = t > first ? t : first;
            last = u < last ? u : last;
        }

        [[gnu::always_inline]] void meet(const BvhNode<Real>& node, Real limit, Real (&enters)[width],
                                         Real (&exits)[width]) const
        {
            for (int k = 0; k < width; k += laneCount<Real>)
            {
                Lanes<Real> first{}, last = Lanes<Real>{} + limit;
                cut(axes[0], node.planes + k, first, last);
                cut(axes[1], node.planes + k, first, last);
                cut(axes[2], node.planes + k, first, last);
                store(first, enters + k);
                store(last, exits + k);
            }
        }
    };

    std::vector<BvhNode<Real>> nodes;
    std::vector<BvhLeaf> leaves;
    Real paddingShare = 0, shapesExtent = 0;
};

} // namespace rt
