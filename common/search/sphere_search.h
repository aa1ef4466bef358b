// Which spheres a ray meets, four at a time: the formula of shapes.h, step by step the same, so with the same bits. A lane is
// one sphere.
#pragma once

#include "common/base/shapes.h"
#include "common/search/bvh.h"

namespace rt
{

template <std::floating_point Real>
class SphereSearch
{
public:
    /// More spheres than this are searched through a hierarchy: tests/perf/README.md has the measurement.
    static constexpr std::size_t mostScanned = 16;

    /// Spheres i with first[i] != i are there already, and left out; an empty `first` leaves none out.
    explicit SphereSearch(const std::vector<Sphere<Real>>& spheres, std::size_t most = mostScanned,
                          const std::vector<int>& first = {})
    {
        std::vector<BvhLeaf> groups;
        if (spheres.size() > most && areOrdinary(spheres))
        {
            std::vector<Box<Number>> boxes(spheres.size());
            for (std::size_t i = 0; i < spheres.size(); ++i)
            {
                const Vec3<Number> C(spheres[i].C);
                boxes[i] = {C - Number(spheres[i].r), C + Number(spheres[i].r)};
            }
            // Directions have unit length up to unitError<Real>, and hit points err by as much, and by the formula's own.
            tree = Bvh<Number>(boxes, 4 * unitError<Real>);
            groups = tree.leafShapes();
            tree.forgetLeaves();
        }
        if (tree.empty())
            for (std::size_t i = 0; i < spheres.size(); ++i)
            {
                if (i % lanes == 0) groups.emplace_back().fill(-1);
                groups.back()[i % lanes] = std::int32_t(i);
            }
        blocks.resize(groups.size());
        for (std::size_t i = 0; i < groups.size(); ++i)
            for (int k = 0; k < lanes; ++k)
            {
                std::int32_t id = groups[i][std::size_t(k)];
                if (id >= 0 && !first.empty() && first[std::size_t(id)] != id) id = -1;
                blocks[i].id[k] = id;
                const Sphere<Real> sphere = id < 0 ? Sphere<Real>{} : spheres[std::size_t(id)];
                for (int axis = 0; axis < 3; ++axis) blocks[i].C[axis][k] = sphere.C[axis];
                blocks[i].squaredRadius[k] = id < 0 ? -1 : Number(sphere.r) * Number(sphere.r);
            }
    }

    /// Calls found(id, t) for each sphere but `from` that the ray meets at t <= limit, until it returns true. It may lower
    /// `limit`; spheres that are farther may be called for all the same.
    template <Instructions set, class Found>
    bool visit(const Vec3<Real>& O, const Vec3<Real>& D, PrimitiveId from, const Real& limit, Found&& found) const
    {
        // The boxes are padded for unit vectors, which all lessons trace; others meet every sphere.
        if (tree.empty() || !isUnit(D))
        {
            for (const auto& block : blocks)
                if (visitBlock<set>(block, Vec3<Number>(O), Vec3<Number>(D), from, limit, found)) return true;
            return false;
        }
#if RAYTREE_HAS_AVX2
        if constexpr (set == Instructions::avx2) return visitTreeAvx2(O, D, from, limit, found);
#endif
        return visitTree<set>(O, D, from, limit, found);
    }

    std::size_t bytes() const
    {
        return blocks.capacity() * sizeof(Block) + tree.bytes();
    }

private:
    using Number = Wide<Real>; ///< what the formula computes in

    static constexpr int lanes = bvhLeafSize;

    struct Block
    {
        Number C[3][lanes];
        Number squaredRadius[lanes]; ///< -1: no sphere, which no ray meets
        PrimitiveId id[lanes];
    };

    /// Can r² be computed with a relative error? Below that the formula meets spheres far off their boxes.
    static bool areOrdinary(const std::vector<Sphere<Real>>& spheres)
    {
        using Limits = std::numeric_limits<Number>;
        return std::all_of(spheres.begin(), spheres.end(), [](const auto& sphere) {
            return Number(sphere.r) * Number(sphere.r) >= Limits::min() / Limits::epsilon();
        });
    }

    template <Instructions set, class Found>
    bool visitTree(const Vec3<Real>& rayO, const Vec3<Real>& rayD, PrimitiveId from, const Real& limit,
                   Found& found) const
    {
        const Vec3<Number> O(rayO), D(rayD);
        return tree.template visitLeaves<set>(
            O, D, limit, [&](std::size_t leaf) { return visitBlock<set>(blocks[leaf], O, D, from, limit, found); });
    }

#if RAYTREE_HAS_AVX2
    // By itself, or it would take so many registers that scans get slower.
    template <class Found>
    RAYTREE_AVX2 [[gnu::noinline]] bool visitTreeAvx2(const Vec3<Real>& O, const Vec3<Real>& D, PrimitiveId from,
                                                      const Real& limit, Found& found) const
    {
        return visitTree<Instructions::avx2>(O, D, from, limit, found);
    }
#endif

    template <Instructions set, class Found>
    static bool visitBlock(const Block& block, const Vec3<Number>& O, const Vec3<Number>& D, PrimitiveId from,
                           const Real& limit, Found& found)
    {
        // SOLUTION 01-sphere
        using Lanes = rt::Lanes<Number, set>;
        Number bs[lanes], discriminants[lanes];
        unsigned met = 0;
        for (int k = 0; k < lanes; k += laneCount<Number, set>)
        {
            Lanes x, y, z, discriminant;
            std::memcpy(&x, block.C[0] + k, sizeof x);
            std::memcpy(&y, block.C[1] + k, sizeof y);
            std::memcpy(&z, block.C[2] + k, sizeof z);
            std::memcpy(&discriminant, block.squaredRadius + k, sizeof discriminant);
            x = O.x - x;
            y = O.y - y;
            z = O.z - z;
            const Lanes b = x * D.x + y * D.y + z * D.z;
            x -= b * D.x;
            y -= b * D.y;
            z -= b * D.z;
            discriminant -= x * x + y * y + z * z;
            std::memcpy(bs + k, &b, sizeof b);
            std::memcpy(discriminants + k, &discriminant, sizeof discriminant);
            met |= bitsOf(discriminant >= 0) << k;
        }
        for (; met; met &= met - 1)
        {
            const int k = std::countr_zero(met);
            if (block.id[k] == from) continue;
            const Number b = bs[k], squaredRadius = block.squaredRadius[k];
            const Vec3<Number> oc(O.x - block.C[0][k], O.y - block.C[1][k], O.z - block.C[2][k]);
            const Number c = dot(oc, oc) - squaredRadius;
            if (b > 0 && c > 0) continue; // outside and going away: both roots are negative
            const Number q = -(b + std::copysign(std::sqrt(discriminants[k]), b));
            const Number other = c / q;
            const Real t1 = Real(std::min(q, other)), t2 = Real(std::max(q, other));
            const Real t = t1 > 0 ? t1 : t2;
            if (t > 0 && t <= limit && found(block.id[k], t)) return true;
        }
        return false;
        // END
    }

    std::vector<Block> blocks; ///< in the order of ids, or of the tree's leaves
    Bvh<Number> tree;
};

} // namespace rt
