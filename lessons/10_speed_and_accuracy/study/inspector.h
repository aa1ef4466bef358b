// A recorder that counts rays and judges each one: does the ray find what it should from the point that it truly leaves?
#pragma once

#include <cstdint>
#include <vector>

#include "common/scene/recorder.h"
#include "common/scene/scene.h"

#include "subject.h"

namespace rt::lesson10
{

/// The judge is the same scene in long double with exclusion. A ray that is stopped by the surface it leaves is acne; one that
/// passes what it should meet is a leak.
template <class World>
struct Inspector : NoRecorder
{
    using Real = typename World::Real;

    struct Place
    {
        Vec3<Real> I;
        PrimitiveId on;
    };

    const World* world;
    const Scene<long double>* judge; ///< null: only count
    PixelFacts* facts;
    std::vector<Place>* path; ///< path[d]: where the latest ray of depth d ended
    int depth = 0;            ///< of the latest ray

    void ray(const Ray<Real>& ray, const std::optional<Hit<Real>>& hit)
    {
        ++facts->rays;
        depth = ray.depth;
        if (path->size() <= std::size_t(depth)) path->resize(std::size_t(depth) + 1);
        (*path)[std::size_t(depth)] = hit ? Place{hit->I, hit->I.on} : Place{ray.O, noPrimitive};
        if (depth == 0) facts->first = hit ? hit->I.on : noPrimitive;
        const auto word = std::uint64_t(hit ? 2 * (hit->I.on + 1) + hit->inside : 0) * 64 + std::uint64_t(depth) * 4 +
                          std::uint64_t(ray.kind);
        facts->shape = (facts->shape ^ word) * 0x100000001b3;
        if (judge && depth > 0) compare(ray.D, hit);
    }

    template <class Light>
    void shadow(const Light& light, const Point<Real>& start, const Vec3<Real>& L, Real, bool visible)
    {
        ++facts->rays;
        if (!judge) return;
        const Place& place = (*path)[std::size_t(depth)];
        const Point<long double> I{Vec3<long double>(place.I), place.on};
        const Vec3<long double> way = Vec3<long double>(light.position) - I;
        uncountRay();
        const bool truth = !judge->occluded(I, unit(way), length(way));
        if (visible && !truth) ++facts->leaks;
        if (!visible && truth)
        {
            uncountRay();
            const auto blocker = world->intersect(Ray<Real>{.O = start, .D = L, .from = start.on});
            if (blocker && blocker->I.on == place.on) ++facts->acne;
        }
    }

private:
    void compare(const Vec3<Real>& D, const std::optional<Hit<Real>>& hit)
    {
        const Place& start = (*path)[std::size_t(depth) - 1];
        uncountRay();
        const auto truth = judge->intersect(
            Ray<long double>{.O = Vec3<long double>(start.I), .D = unit(Vec3<long double>(D)), .from = start.on});
        const bool nearer = hit && (!truth || 2 * hit->t < truth->t);
        if (nearer && hit->I.on == start.on) ++facts->acne;
        const bool same = hit && truth && hit->I.on == truth->I.on && hit->inside == truth->inside;
        if (truth && !same && (!hit || hit->t > truth->t)) ++facts->leaks;
    }
};

} // namespace rt::lesson10
