// Builds the hierarchy of bvh.h: splits by the surface area heuristic in bins (Wald, "On fast Construction of SAH-based
// Bounding Volume Hierarchies", RT 2007), always the largest part of a node next until it has eight.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/base/parallel.h"
#include "common/base/vec.h"

namespace rt
{

inline constexpr int bvhWidth = 8;    ///< children of a node
inline constexpr int bvhLeafSize = 4; ///< shapes of a leaf, at most

template <std::floating_point Real>
struct Box
{
    Vec3<Real> low{infinity<Real>}, high{-infinity<Real>};

    void add(const Vec3<Real>& p)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    void add(const Box& box)
    {
        add(box.low);
        add(box.high);
    }
    Vec3<Real> middle() const { return Real(0.5) * low + Real(0.5) * high; }
    Real halfArea() const
    {
        const Vec3<Real> size = high - low;
        return size.x * size.y + size.y * size.z + size.z * size.x;
    }
};

/// Up to four shapes; -1 fills up.
using BvhLeaf = std::array<std::int32_t, bvhLeafSize>;

struct alignas(64) BvhNode
{
    float planes[2 * 3 * bvhWidth]; ///< the lower ones of the x, y and z axis, then the upper ones
    std::int32_t child[bvhWidth];   ///< a node, or ~leaf
    std::uint32_t children;         ///< bit k: child k is there. A ray from infinity meets what has no box, too.
};

inline constexpr int bvhDeepest = 40;                          ///< binary splits by area; those below are in the middle
inline constexpr int bvhStackSize = 7 * (bvhDeepest + 32) + 8; ///< a node leaves seven siblings behind

/// The root is node 0.
struct BvhTree
{
    std::vector<BvhNode> nodes;
    std::vector<BvhLeaf> leaves;

    /// Returns the root of `other`, which is now a part of this one.
    std::int32_t append(const BvhTree& other)
    {
        const auto node = std::int32_t(nodes.size()), leaf = std::int32_t(leaves.size());
        for (const BvhNode& from : other.nodes)
        {
            BvhNode& to = nodes.emplace_back(from);
            for (int k = 0; k < bvhWidth; ++k)
                if (to.children >> k & 1) to.child[k] += to.child[k] < 0 ? -leaf : node;
        }
        leaves.insert(leaves.end(), other.leaves.begin(), other.leaves.end());
        return node;
    }
};

struct BvhBuilder
{
    const std::vector<Box<float>>& boxes;
    std::size_t apartFrom = 16384; ///< a node over more builds its children at the same time

    struct Item
    {
        Box<float> box;
        std::int32_t id;
    };
    /// A run of items. Leaves are a run of up to four.
    struct Part
    {
        std::size_t first, last;
        Box<float> box;
        int depth;

        std::size_t size() const { return last - first; }
    };
    std::vector<Item> items{};

    BvhTree build()
    {
        BvhTree tree;
        items.reserve(boxes.size());
        Part all{0, boxes.size(), {}, 0};
        for (const auto& box : boxes)
        {
            items.push_back({box, std::int32_t(items.size())});
            all.box.add(box);
        }
        tree.nodes.reserve(boxes.size() / 12);
        tree.leaves.reserve(boxes.size() * 2 / 5);
        if (!items.empty()) addNode(all, tree);
        tree.nodes.shrink_to_fit();
        tree.leaves.shrink_to_fit();
        return tree;
    }

    /// The tree is the same, and in the same order, whatever is built at the same time: parts share no items.
    std::int32_t addNode(const Part& whole, BvhTree& tree)
    {
        Part parts[bvhWidth] = {whole};
        int count = 1;
        while (count < bvhWidth)
        {
            int largest = -1;
            for (int k = 0; k < count; ++k)
                if (parts[k].size() > bvhLeafSize &&
                    (largest < 0 || parts[k].box.halfArea() > parts[largest].box.halfArea()))
                    largest = k;
            if (largest < 0) break;
            const std::size_t middle = split(parts[largest]);
            parts[count] = part(middle, parts[largest].last, parts[largest].depth + 1);
            parts[largest] = part(parts[largest].first, middle, parts[largest].depth + 1);
            ++count;
        }
        BvhTree apart[bvhWidth];
        const bool atOnce = whole.size() > apartFrom;
        const auto isNode = [&](int k) { return parts[k].size() > bvhLeafSize; };
        if (atOnce)
            forEach(count, [&](int k) {
                if (isNode(k)) addNode(parts[k], apart[k]);
            });

        const std::size_t index = tree.nodes.size();
        tree.nodes.emplace_back().children = (1U << count) - 1;
        for (int k = 0; k < bvhWidth; ++k)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                auto& planes = tree.nodes[index].planes;
                planes[axis * bvhWidth + k] = k < count ? parts[k].box.low[axis] : infinity<float>;
                planes[(3 + axis) * bvhWidth + k] = k < count ? parts[k].box.high[axis] : -infinity<float>;
            }
            const std::int32_t child = k >= count   ? 0
                                       : !isNode(k) ? addLeaf(parts[k], tree)
                                       : atOnce     ? tree.append(apart[k])
                                                    : addNode(parts[k], tree);
            tree.nodes[index].child[k] = child; // only now: addNode moves the nodes
        }
        return std::int32_t(index);
    }

    std::int32_t addLeaf(const Part& leaf, BvhTree& tree) const
    {
        BvhLeaf shapes;
        shapes.fill(-1);
        for (std::size_t i = leaf.first; i < leaf.last; ++i) shapes[i - leaf.first] = items[i].id;
        tree.leaves.push_back(shapes);
        return ~std::int32_t(tree.leaves.size() - 1);
    }

    Part part(std::size_t first, std::size_t last, int depth) const
    {
        Part result{first, last, {}, depth};
        for (std::size_t i = first; i < last; ++i) result.box.add(items[i].box);
        return result;
    }

    /// Orders the items of a part so that two good parts lie before and after the index it returns.
    std::size_t split(const Part& whole)
    {
        constexpr int bins = 16;
        struct Bin
        {
            Box<float> box;
            std::size_t count = 0;
        };
        Box<float> middles;
        for (std::size_t i = whole.first; i < whole.last; ++i) middles.add(items[i].box.middle());
        const Vec3<float> size = middles.high - middles.low;
        const Vec3<float> scale = float(bins) / size;
        const auto binOf = [&](const Item& item, int axis) {
            const float place = (item.box.middle()[axis] - middles.low[axis]) * scale[axis];
            return place < bins - 1 ? int(place) : bins - 1; // also where nothing differs and place is NaN
        };
        Bin bin[3][bins];
        for (std::size_t i = whole.first; i < whole.last; ++i)
            for (int axis = 0; axis < 3; ++axis)
            {
                Bin& b = bin[axis][binOf(items[i], axis)];
                b.box.add(items[i].box);
                ++b.count;
            }

        // Four shapes are tested at a time: a part costs its area times the leaves that it needs at least.
        const auto cost = [](const Bin& b) {
            return b.box.halfArea() * float((b.count + bvhLeafSize - 1) / bvhLeafSize);
        };
        float best = infinity<float>;
        int bestAxis = -1, bestBin = 0;
        for (int axis = 0; axis < 3 && whole.depth < bvhDeepest; ++axis)
        {
            float above[bins];
            Bin sum;
            for (int k = bins - 1; k > 0; --k)
            {
                sum.box.add(bin[axis][k].box);
                sum.count += bin[axis][k].count;
                above[k] = sum.count == 0 ? infinity<float> : cost(sum);
            }
            sum = {};
            for (int k = 0; k + 1 < bins; ++k)
            {
                sum.box.add(bin[axis][k].box);
                sum.count += bin[axis][k].count;
                if (sum.count == 0 || sum.count == whole.size()) continue;
                const float total = cost(sum) + above[k + 1];
                if (total < best) best = total, bestAxis = axis, bestBin = k;
            }
        }
        const auto begin = items.begin() + std::ptrdiff_t(whole.first),
                   end = items.begin() + std::ptrdiff_t(whole.last);
        if (bestAxis >= 0)
        {
            const auto middle =
                std::partition(begin, end, [&](const Item& item) { return binOf(item, bestAxis) <= bestBin; });
            return std::size_t(middle - items.begin());
        }
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
        const auto middle = begin + std::ptrdiff_t((whole.size() / 2 + bvhLeafSize - 1) / bvhLeafSize * bvhLeafSize);
        std::nth_element(begin, middle, end,
                         [axis](const Item& a, const Item& b) { return a.box.middle()[axis] < b.box.middle()[axis]; });
        return std::size_t(middle - items.begin());
    }
};

} // namespace rt
