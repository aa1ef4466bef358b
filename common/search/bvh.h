// A hierarchy of boxes, eight children a node (Wald, Benthin, Boulos: "Getting Rid of Packets", RT 2008). It only tells which
// leaves a ray may meet; what is hit, and where, the shapes' formulas say. So the answer is that of a scan over all shapes.
//
// Boxes are floats, whatever the tracer computes in: coordinates from -1 to 1 about the middle of the shapes. They are padded
// for all rounding, the formulas' too: a shape whose computed distance is t lies in boxes that the ray is found to enter at t
// or before. (Ize, "Robust BVH Ray Traversal", JCGT 2013, does it for the boxes' own rounding.)
#pragma once

#include <bit>

#include "common/search/bvh_build.h"
#include "common/search/lanes.h"

namespace rt
{

/// How far from 1 the square of a direction's length may be, so that boxes may be asked.
template <std::floating_point Real>
inline constexpr Real unitError = 16 * std::numeric_limits<Real>::epsilon();

template <std::floating_point Real>
bool isUnit(const Vec3<Real>& D)
{
    return std::abs(dot(D, D) - 1) <= unitError<Real>;
}

template <std::floating_point Number>
class Bvh
{
public:
    Bvh() = default; ///< empty: nothing is ever visited

    /// Over the shapes whose boxes are `boxes`; stays empty if these are so large or so small that they have no middle or no
    /// scale. `formulas` is the largest error of a hit point, as a share of the sum of the absolute coordinates of the ray's
    /// origin and of any point of the boxes.
    Bvh(const std::vector<Box<Number>>& boxes, Number formulas) : formulasShare(formulas)
    {
        Box<Number> all;
        for (const auto& box : boxes) all.add(box);
        const Vec3<Number> size = Number(0.5) * all.high - Number(0.5) * all.low;
        const Number half = std::max({size.x, size.y, size.z});
        middle = all.middle();
        if (!isFinite(middle) || !(half > std::numeric_limits<Number>::min() * 4) || !(half < infinity<Number>)) return;
        scale = std::ldexp(Number(1), -std::ilogb(half) - 1);

        const Vec3<Number> distance = abs(middle);
        const Number sum = (distance.x + distance.y + distance.z) * scale;
        const Number pad = boxesShare * 4 * nearby + formulas * (2 * sum + nearby + 3);
        std::vector<Box<float>> placed(boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i)
            placed[i] = {Vec3<float>((boxes[i].low - middle) * scale - pad),
                         Vec3<float>((boxes[i].high - middle) * scale + pad)};
        tree = BvhBuilder{placed}.build();
    }

    bool empty() const { return tree.nodes.empty(); }

    /// Leaf number -> indices into `boxes`; -1 fills up.
    const std::vector<BvhLeaf>& leafShapes() const { return tree.leaves; }

    std::size_t bytes() const
    {
        return tree.nodes.capacity() * sizeof(BvhNode) + tree.leaves.capacity() * sizeof(BvhLeaf);
    }

    /// The shapes' numbers are in the leaves, for callers that keep their own copy in that order.
    void forgetLeaves() { tree.leaves = {}; }

    /// Calls visit(leaf) for each leaf that the ray may meet in (0, limit], near ones rather early, until visit returns
    /// true. visit may lower `limit`. isUnit(D).
    template <Instructions set, class Real, class Visit>
    bool visitLeaves(const Vec3<Number>& O, const Vec3<Number>& D, const Real& limit, Visit&& visit) const
    {
        if (tree.nodes.empty()) return false;
        Vec3<Number> o = (O - middle) * scale;
        Number start = 0; // where t is 0 among the boxes
        float pad = 0;
        if (const Number far = std::abs(o.x) + std::abs(o.y) + std::abs(o.z); !(far <= nearby)) [[unlikely]]
            pad = approach(o, D, far, start);
        Vec3<float> d(D);
        if (std::min({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) < least) [[unlikely]]
            d = awayFromZero(d);
        const Slabs<set> ray{{float(o.x), d.x, pad}, {float(o.y), d.y, pad}, {float(o.z), d.z, pad}};
        const auto along = [&] { return float((limit - start) * scale) * (1 + roundingUp) + roundingUp; };
        float end = along();
        std::uint64_t stack[bvhStackSize], entry = 0;
        for (int top = 0;;)
        {
            const auto child = std::int32_t(std::uint32_t(entry));
            if (child < 0)
            {
                if (visit(std::size_t(~child))) return true;
                end = along();
            }
            else
            {
                const BvhNode& node = tree.nodes[std::size_t(child)];
                float enters[bvhWidth];
                if (unsigned met = ray.meet(node, end, enters))
                {
                    const auto next = [&] {
                        const int k = std::countr_zero(met);
                        met &= met - 1;
                        return entryOf(enters[k], node.child[k]);
                    };
                    // The nearest first; to sort the others, too, takes longer than it saves.
                    entry = next();
                    while (met)
                    {
                        std::uint64_t other = next();
                        if (other < entry) std::swap(other, entry);
                        stack[top++] = other;
                    }
                    continue;
                }
            }
            do {
                if (top == 0) return false;
                entry = stack[--top];
            } while (!(std::bit_cast<float>(std::uint32_t(entry >> 32)) <= end));
        }
    }

private:
    /// Where the ray enters, at 0 or later, and what: one number that is the smaller the nearer.
    static std::uint64_t entryOf(float t, std::int32_t child)
    {
        return std::uint64_t(std::bit_cast<std::uint32_t>(t)) << 32 | std::uint32_t(child);
    }

    /// Error of where a ray meets a box, as a share of |O|: 2.8 times too much.
    static constexpr float boxesShare = 2 * std::numeric_limits<float>::epsilon();
    static constexpr float roundingUp = 8 * std::numeric_limits<float>::epsilon();
    static constexpr int nearby = 8; ///< origins so near are covered by the padding of the boxes

    /// The ray among the boxes: where it passes the planes of one, t = (O - plane) * -1/D.
    template <Instructions set>
    struct Slabs
    {
        using Lanes = rt::Lanes<float, set>;

        struct Axis
        {
            Lanes enterO, leaveO, minusInverse; ///< the same number in each lane
            std::ptrdiff_t enter, leave;        ///< bytes to the lower and the upper planes, or the other way round

            Axis(float o, float d, float pad)
                : enterO(Lanes{} + o), leaveO(enterO), minusInverse(Lanes{} + -1 / d),
                  enter(std::bit_cast<std::int32_t>(d) >> 31 & upper), leave(upper - enter)
            {
                if (pad == 0) return;
                enterO += std::copysign(pad, d);
                leaveO -= std::copysign(pad, d);
            }

            // Each step is monotonic: a box around another is never entered later, nor left earlier, to the last bit.
            [[gnu::always_inline]] void cut(const float* planes, Lanes& first, Lanes& last) const
            {
                const char* const bytes = reinterpret_cast<const char*>(planes);
                Lanes near, far;
                std::memcpy(&near, bytes + enter, sizeof near);
                std::memcpy(&far, bytes + leave, sizeof far);
                const Lanes t = (enterO - near) * minusInverse;
                const Lanes u = (leaveO - far) * minusInverse;
                first = t > first ? t : first;
                last = u < last ? u : last;
            }

            static constexpr std::ptrdiff_t upper = 3 * bvhWidth * sizeof(float);
        } x, y, z;

        [[gnu::always_inline]] unsigned meet(const BvhNode& node, float end, float (&enters)[bvhWidth]) const
        {
            unsigned met = 0;
            for (int k = 0; k < bvhWidth; k += laneCount<float, set>)
            {
                Lanes first{}, last = Lanes{} + end;
                x.cut(node.planes + k, first, last);
                y.cut(node.planes + k + bvhWidth, first, last);
                z.cut(node.planes + k + bvhWidth * 2, first, last);
                std::memcpy(enters + k, &first, sizeof first);
                met |= bitsOf(first <= last) << k;
            }
            return met & node.children;
        }
    };

    // 1 / 0 would make 0 * infinity of a plane through O. This is as steep, and finite.
    static constexpr float least = std::numeric_limits<float>::min();
    static Vec3<float> awayFromZero(Vec3<float> d)
    {
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(d[axis]) < least) d[axis] = std::copysign(least, d[axis]);
        return d;
    }

    /// Floats would be too coarse from afar: brings o nearer, and returns what more the boxes must then be padded by.
    [[gnu::noinline]] float approach(Vec3<Number>& o, const Vec3<Number>& D, Number far, Number& start) const
    {
        const Number ahead = std::max(Number(0), -dot(o, D) - 4);
        o += ahead * D;
        start = ahead / scale;
        return float(boxesShare * 4 * (std::abs(o.x) + std::abs(o.y) + std::abs(o.z)) + 4 * formulasShare * far);
    }

    BvhTree tree;
    Vec3<Number> middle{0, 0, 0};
    Number scale = 1, formulasShare = 0;
};

} // namespace rt
