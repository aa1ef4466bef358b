// A scene in the tracer's scalar type, and the two questions that every lesson asks it: intersect and occluded.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/base/hit.h"
#include "common/base/light.h"
#include "common/base/ray_limit.h"
#include "common/scene/camera.h"
#include "common/scene/coincident.h"
#include "common/scene/scene_description.h"
#include "common/scene/sky.h"
#include "common/search/leave_triangle.h"
#include "common/search/look_ahead.h"
#include "common/search/sphere_search.h"
#include "common/search/triangle_search.h"

namespace rt
{

template <std::floating_point Real>
class Scene
{
public:
    Camera<Real> camera;
    TraceSettings settings;
    Sky<Real> sky;
    std::vector<Material<Real>> materials; ///< the described ones, then one for each checker
    std::vector<Sphere<Real>> spheres;
    std::vector<Plane<Real>> planes;
    std::vector<Triangle<Real>> triangles; ///< those of the file, then those of its meshes
    std::vector<Light<Real>> lights;
    Instructions instructions = bestInstructions(); ///< of intersect and occluded; pictures are the same for all
    Real brightest = 0; ///< no ray returns more, if there is a cutoff that asks for it; else 0

    /// Converts each number once and normalises directions. Throws UnfitNumber if one does not fit Real.
    explicit Scene(const SceneDescription& description);

    /// The slides' IntersectScene: the nearest hit with t > 0, or nothing. A ray never meets again the plane or triangle
    /// that it leaves, and the sphere only at its far side. Equal distances: the lowest primitive id wins; where surfaces
    /// lie on one another, foremost says which. `shapes` supplies the formulas; only exercise 01 passes its own.
    template <class Formulas = Shapes<Real>>
    [[gnu::always_inline]] std::optional<Hit<Real>> intersect(const Ray<Real>& ray, const Formulas& shapes = {}) const
    {
        countRay();
        if constexpr (looksAhead<Real> && std::is_same_v<Formulas, Shapes<Real>>)
            if (ray.ahead && ray.ahead->isFor(ray)) return ray.ahead->hit;
#if RAYTREE_HAS_AVX2
        if constexpr (hasLanes<Real> && std::is_same_v<Formulas, Shapes<Real>>)
            if (instructions == Instructions::avx2) return intersectAvx2(ray);
#endif
        return intersectWith<Instructions::baseline>(ray, shapes);
    }

    /// The slides' !IsVisible: is there anything on the open segment from I towards L (unit), shorter than `distance`?
    /// Glass is something, unless the scene says shadow_through_glass = "tint". A lamp so near that its light does not fit
    /// Real sits on the point: the point itself is in its way.
    template <class Formulas = Shapes<Real>>
    [[gnu::always_inline]] bool occluded(const Point<Real>& I, const Vec3<Real>& L, Real distance,
                                         const Formulas& shapes = {}) const
    {
        countRay();
#if RAYTREE_HAS_AVX2
        if constexpr (hasLanes<Real> && std::is_same_v<Formulas, Shapes<Real>>)
            if (instructions == Instructions::avx2) return occludedAvx2(I, L, distance);
#endif
        return occludedWith<Instructions::baseline>(I, L, distance, shapes);
    }

    /// The product of the colours of all dielectric surfaces on that segment; white unless shadow_through_glass = "tint".
    Vec3<Real> shadowTint(const Point<Real>& I, const Vec3<Real>& L, Real distance) const
    {
        // Here, to be inlined: most scenes need nothing else.
        if (settings.shadowThroughGlass == ShadowThroughGlass::block) return Vec3<Real>(1);
        return tintBetween(I, L, distance);
    }

    /// Does lookAhead take less time than to intersect one by one? If all is scanned, and nothing lies on something else.
    bool wantsLookAhead() const
    {
        return looksAhead<Real> && isScanned;
    }

    /// Sets `hit` of `count` rays, a multiple of four, that leave no primitive; if wantsLookAhead.
    void lookAhead(Ahead<Real>* rays, int count) const
    {
        if constexpr (!looksAhead<Real>) return;
#if RAYTREE_HAS_AVX2
        if constexpr (hasLanes<Real>)
            if (instructions == Instructions::avx2) return lookAheadAvx2(rays, count);
#endif
        lookAheadWith<Instructions::baseline>(rays, count);
    }

    /// "sphere0", "plane1", "triangle2": kind, and order in the file among its kind; "mesh0.triangle12" in a mesh.
    std::string primitiveName(PrimitiveId id) const;

private:
    template <Instructions set, class Formulas>
    std::optional<Hit<Real>> intersectWith(const Ray<Real>& ray, const Formulas& shapes) const;

    template <Instructions set>
    void lookAheadWith(Ahead<Real>* rays, int count) const;

    template <Instructions set, class Formulas>
    bool occludedWith(const Point<Real>& I, const Vec3<Real>& L, Real distance, const Formulas& shapes) const;

#if RAYTREE_HAS_AVX2
    RAYTREE_AVX2 void lookAheadAvx2(Ahead<Real>* rays, int count) const
    {
        lookAheadWith<Instructions::avx2>(rays, count);
    }
    RAYTREE_AVX2 std::optional<Hit<Real>> intersectAvx2(const Ray<Real>& ray) const
    {
        return intersectWith<Instructions::avx2>(ray, Shapes<Real>{});
    }
    RAYTREE_AVX2 bool occludedAvx2(const Point<Real>& I, const Vec3<Real>& L, Real distance) const
    {
        return occludedWith<Instructions::avx2>(I, L, distance, Shapes<Real>{});
    }
#endif

    template <Instructions set, class Found, class Formulas>
    void visitHits(const Vec3<Real>& O, const Vec3<Real>& D, PrimitiveId from, const Formulas& shapes,
                   const Real& limit, Found&& found) const;

    template <Instructions set, class Found>
    void visitTriangles(const Vec3<Real>& O, const Vec3<Real>& D, PrimitiveId from, const Real& limit,
                        Found& found) const;

    template <Instructions set, class Found>
    void visitFromRim(const Ray<Real>& ray, const LeaveTriangle<Real>& left, const Real& limit, Found& found) const;

#if RAYTREE_HAS_AVX2
    // By itself, since most scenes have none, and scans of spheres are faster beside less.
    template <class Found>
    RAYTREE_AVX2 [[gnu::noinline]] void visitTrianglesAvx2(const Vec3<Real>& O, const Vec3<Real>& D, PrimitiveId from,
                                                           const Real& limit, Found& found) const
    {
        visitTriangles<Instructions::avx2>(O, D, from, limit, found);
    }
#endif

    /// Has it all its digits?
    static bool isOrdinary(Wide<Real> x)
    {
        return x >= std::numeric_limits<Wide<Real>>::min() && x < infinity<Wide<Real>>;
    }

    /// hitAt, of a scene with sheets. A ray that leaves one meets only what startOn said of it.
    [[gnu::noinline]] std::optional<Hit<Real>> foremostHit(const Ray<Real>& ray, Real t, PrimitiveId id) const
    {
        if (sheetOfPrimitive(ray.from) != sheetOfPrimitive(id)) id = foremost(ray, t, id);
        return hitAt(ray, t, id);
    }

    Hit<Real> hitAt(const Ray<Real>& ray, Real t, PrimitiveId id) const;

    Hit<Real> finish(const Ray<Real>& ray, Real t, PrimitiveId id, const Vec3<Real>& I, const Vec3<Real>& outward,
                     int material) const;

    Vec3<Real> tintBetween(const Point<Real>& I, const Vec3<Real>& L, Real distance) const;

    /// Flat surfaces that lie on one another.
    struct Sheet
    {
        PrimitiveId plane = noPrimitive; ///< the first of its planes
        std::vector<PrimitiveId> planes, triangles;
        std::vector<Triangle<Real>> copies; ///< of these triangles
        TriangleSearch<Real> search{{}};
    };

    void findSheets(const SceneDescription& description);

    std::int32_t sheetOfPrimitive(PrimitiveId id) const
    {
        return sheetOf.empty() || id < 0 ? -1 : sheetOf[std::size_t(id)];
    }

    int layerOf(PrimitiveId id, const Vec3<Real>& D) const;

    PrimitiveId foremost(const Ray<Real>& ray, Real t, PrimitiveId found) const;

    /// What a ray meets of the surface that it leaves and of those that lie on it; and the plane that it does not meet.
    struct Start
    {
        PrimitiveId id, left;
        std::optional<Real> t = std::nullopt;
    };
    Start startOn(const Vec3<Real>& O, const Vec3<Real>& D, PrimitiveId from) const;

    Real brightestReturn() const;
    const Material<Real>& materialOf(PrimitiveId id) const;

    std::vector<std::int32_t> sheetOf; ///< of each primitive; -1: none; empty if there are no sheets
    std::vector<Sheet> sheets;
    std::vector<Plane<Real>> planesToMeet; ///< of a sheet the first only: the others have N = 0, and no ray meets them
    std::vector<int> firstOfSpheres;       ///< of equal spheres; of others it is the sphere itself

    SphereSearch<Real> sphereSearch{{}};
    TriangleSearch<Real> triangleSearch{{}};
    std::vector<PrimitiveId> meshes;                     ///< the first triangle of each
    Real nearestLamp = std::numeric_limits<Real>::min(); ///< distance²: closer, light may overflow

    PrimitiveId firstPlane = 0, firstTriangle = 0;
    bool isScanned = false; ///< no hierarchies, no triangles, no sheets
};

/// Calls found(id, t) for the primitives that the ray meets at t <= limit, in any order, until it returns true. It may lower
/// `limit`; some that are farther may be called for all the same.
template <std::floating_point Real>
template <Instructions set, class Found, class Formulas>
void Scene<Real>::visitHits(const Vec3<Real>& O, const Vec3<Real>& D, PrimitiveId from, const Formulas& shapes,
                            const Real& limit, Found&& found) const
{
    const Ray<Real> ray{.O = O, .D = D, .from = from};
    Start start{.id = from, .left = from};
    if (from >= 0)
    {
        if (from < firstPlane)
            start.t = Shapes<Real>::leaveSphere(ray, spheres[std::size_t(from)]);
        else if (!sheetOf.empty()) [[unlikely]]
            start = startOn(O, D, from);
        if (start.t && found(start.id, *start.t)) return;
    }
    PrimitiveId id = firstPlane;
    for (const auto& plane : planesToMeet)
    {
        if (id != start.left)
            if (const auto t = shapes.intersectPlane(ray, plane))
                if (found(id, *t)) return;
        ++id;
    }
    if constexpr (std::is_same_v<Formulas, Shapes<Real>>)
    {
        if (sphereSearch.template visit<set>(O, D, from, limit, found)) return;
    }
    else // Other formulas have their own roundings, which no box is padded for.
        for (id = 0; id < firstPlane; ++id)
            if (id != from && firstOfSpheres[std::size_t(id)] == id)
                if (const auto t = shapes.intersectSphere(ray, spheres[std::size_t(id)]))
                    if (found(id, *t)) return;
    if (triangles.empty()) return;
#if RAYTREE_HAS_AVX2
    if constexpr (set == Instructions::avx2) return visitTrianglesAvx2(O, D, from, limit, found);
#endif
    visitTriangles<set>(O, D, from, limit, found);
}

template <std::floating_point Real>
template <Instructions set, class Found>
void Scene<Real>::visitTriangles(const Vec3<Real>& O, const Vec3<Real>& D, PrimitiveId from, const Real& limit,
                                 Found& found) const
{
    const Ray<Real> ray{.O = O, .D = D, .from = from};
    const auto sheet = sheetOfPrimitive(from);
    const auto withId = [&](PrimitiveId index, Real t) {
        const PrimitiveId id = firstTriangle + index;
        return (sheet < 0 || sheetOf[std::size_t(id)] != sheet) && bool(found(id, t));
    };
    if (from < firstTriangle)
    {
        triangleSearch.template visit<set>(
            triangles, ray, limit,
            [&](PrimitiveId index) { return Shapes<Real>::intersectTriangle(ray, triangles[std::size_t(index)]); },
            withId);
        return;
    }
    const LeaveTriangle<Real> left(ray, triangles[std::size_t(from - firstTriangle)]);
    if (left.startsWithin())
        triangleSearch.template visit<set>(
            triangles, ray, limit, [&](PrimitiveId index) { return left.meet(triangles[std::size_t(index)]); }, withId);
    else
        visitFromRim<set>(ray, left, limit, withId);
}

/// For float, and for the few rays of other types whose rounded origin is not on their triangle.
template <std::floating_point Real>
template <Instructions set, class Found>
void Scene<Real>::visitFromRim(const Ray<Real>& ray, const LeaveTriangle<Real>& left, const Real& limit,
                               Found& found) const
{
    // The search through boxes begins where the tests of triangles do: else it may leave out a triangle that is very near.
    const auto inside = left.fromWithin();
    Ray<Real> moved = ray;
    moved.O = Vec3<Real>(inside.origin());
    triangleSearch.template visit<set>(
        triangles, moved, limit,
        [&](PrimitiveId index) -> std::optional<Real> {
            const auto t = inside.meet(left.widened(triangles[std::size_t(index)]));
            if (!t) return std::nullopt;
            return std::max(Real(*t), std::numeric_limits<Real>::denorm_min());
        },
        found);
}

template <std::floating_point Real>
template <Instructions set, class Formulas>
std::optional<Hit<Real>> Scene<Real>::intersectWith(const Ray<Real>& ray, const Formulas& shapes) const
{
    Real nearest = infinity<Real>;
    PrimitiveId id = noPrimitive;
    visitHits<set>(ray.O, ray.D, ray.from, shapes, nearest, [&](PrimitiveId candidate, Real t) {
        if (t < nearest || (t == nearest && candidate < id))
        {
            nearest = t;
            id = candidate;
        }
        return false;
    });
    if (id == noPrimitive) return std::nullopt;
    if (!sheetOf.empty()) [[unlikely]]
        return foremostHit(ray, nearest, id);
    return hitAt(ray, nearest, id);
}

template <std::floating_point Real>
template <Instructions set>
void Scene<Real>::lookAheadWith(Ahead<Real>* rays, int count) const
{
    if constexpr (looksAhead<Real>)
        for (int first = 0; first < count; first += LaneRays<Real, set>::lanes)
        {
            LaneRays<Real, set> group(rays + first);
            PrimitiveId id = 0;
            for (const auto& sphere : spheres) group.meet(sphere, id++);
            for (const auto& plane : planes) group.meet(plane, id++);
            for (int k = 0; k < group.lanes; ++k)
            {
                auto& ahead = rays[first + k];
                if (group.id[k] == noPrimitive)
                    ahead.hit.reset();
                else
                    ahead.hit.emplace(hitAt({.O = ahead.O, .D = ahead.D}, group.nearest[k], PrimitiveId(group.id[k])));
            }
        }
}

template <std::floating_point Real>
template <Instructions set, class Formulas>
bool Scene<Real>::occludedWith(const Point<Real>& I, const Vec3<Real>& L, Real distance, const Formulas& shapes) const
{
    if (distance * distance > 0 && distance * distance < nearestLamp) return true;
    const bool throughGlass = settings.shadowThroughGlass == ShadowThroughGlass::tint;
    bool blocked = false;
    visitHits<set>(I, L, I.on, shapes, distance, [&](PrimitiveId id, Real t) {
        return blocked = t < distance && !(throughGlass && materialOf(id).isDielectric());
    });
    return blocked;
}

template <std::floating_point Real>
Vec3<Real> Scene<Real>::tintBetween(const Point<Real>& I, const Vec3<Real>& L, Real distance) const
{
    Vec3<Real> tint(1);
    // From surface to surface, as the light goes straight on: each one that is crossed takes its share. A line crosses a
    // sphere twice at most; where two surfaces coincide, rounding might find now the one, now the other for ever.
    Ray<Real> ray{.O = I, .D = L, .from = I.on};
    for (auto left = 2 * spheres.size() + planes.size() + triangles.size(); left > 0; --left)
    {
        const auto hit = intersect(ray);
        if (!hit) break;
        distance -= hit->t;
        if (!(distance > 0)) break;
        tint *= hit->mat.color;
        ray.O = hit->I;
        ray.from = hit->I.on;
    }
    return tint;
}

template <std::floating_point Real>
const Material<Real>& Scene<Real>::materialOf(PrimitiveId id) const
{
    if (id < firstPlane) return materials[std::size_t(spheres[std::size_t(id)].material)];
    if (id < firstTriangle) return materials[std::size_t(planes[std::size_t(id - firstPlane)].material)];
    return materials[std::size_t(triangles[std::size_t(id - firstTriangle)].material)];
}

/// An upper bound of what `trace` returns: the sky's brightest spot, or all lights as near as they are to any surface, for
/// no surface sends on more than arrives. Infinite if a light sits on a surface; there is then no cutoff.
template <std::floating_point Real>
Real Scene<Real>::brightestReturn() const
{
    Vec3<Real> direct(0);
    for (const auto& light : lights)
    {
        Real nearest = infinity<Real>;
        for (const auto& sphere : spheres)
            nearest = std::min(nearest, std::abs(length(light.position - sphere.C) - sphere.r));
        for (const auto& plane : planes) nearest = std::min(nearest, std::abs(dot(light.position - plane.P, plane.N)));
        for (const auto& triangle : triangles) // its plane is not farther than itself
            nearest = std::min(nearest, std::abs(dot(light.position - triangle.a, triangle.N)));
        direct += light.color / (nearest * nearest);
    }
    return std::max(largestChannel(direct), sky.brightest());
}

/// Point, normal and material of the one hit that counts. Points are put back onto their surface, so that their error
/// does not grow with the distance that the ray came.
template <std::floating_point Real>
Hit<Real> Scene<Real>::hitAt(const Ray<Real>& ray, Real t, PrimitiveId id) const
{
    const Vec3<Real> P = ray.O + t * ray.D;
    if (id < firstPlane)
    {
        const auto& sphere = spheres[std::size_t(id)];
        // From so far that P is rounded to the centre, the side is at least the one that the ray comes from.
        const Vec3<Real> N = unitOr(P - sphere.C, -ray.D);
        return finish(ray, t, id, sphere.C + sphere.r * N, N, sphere.material);
    }
    if (id < firstTriangle)
    {
        const auto& plane = planes[std::size_t(id - firstPlane)];
        const Vec3<Real> I = P - dot(P - plane.P, plane.N) * plane.N;
        return finish(ray, t, id, I, plane.N, plane.materialAt(I));
    }
    const auto& triangle = triangles[std::size_t(id - firstTriangle)];
    return finish(ray, t, id, P - dot(P - triangle.a, triangle.N) * triangle.N, triangle.N, triangle.material);
}

/// Here, and nowhere else, the normal is turned against the ray, and the media on its two sides are told apart.
template <std::floating_point Real>
Hit<Real> Scene<Real>::finish(const Ray<Real>& ray, Real t, PrimitiveId id, const Vec3<Real>& I,
                              const Vec3<Real>& outward, int material) const
{
    const auto& mat = materials[std::size_t(material)];
    const bool inside = dot(ray.D, outward) > 0;
    const Real within = mat.isDielectric() ? mat.ior : 1, around = mat.isDielectric() ? mat.iorOutside : 1;
    return {{I, id, largestChannel(mat.color)}, inside ? -outward : outward, mat, t, inside,
            inside ? within : around,           inside ? around : within};
}

template <std::floating_point Real>
std::string Scene<Real>::primitiveName(PrimitiveId id) const
{
    if (id < 0) return "nothing";
    if (id < firstPlane) return "sphere" + std::to_string(id);
    if (id < firstTriangle) return "plane" + std::to_string(id - firstPlane);
    const PrimitiveId triangle = id - firstTriangle;
    for (std::size_t mesh = meshes.size(); mesh-- > 0;)
        if (triangle >= meshes[mesh])
            return "mesh" + std::to_string(mesh) + ".triangle" + std::to_string(triangle - meshes[mesh]);
    return "triangle" + std::to_string(triangle);
}

} // namespace rt

#include "common/scene/scene_from_description.h"
#include "common/scene/scene_sheets.h"

namespace rt
{

// Compiled once, in scene.cpp, and not in each file that traces: that halves the time to build. Who has the headers only, as
// the grader's kits, defines RAYTREE_HEADERS_ONLY.
#define RAYTREE_SCENE(declare, Real)                                                                                   \
    declare template class Scene<Real>;                                                                                \
    declare template std::optional<Hit<Real>> Scene<Real>::intersectWith<Instructions::baseline>(                      \
        const Ray<Real>&, const Shapes<Real>&) const;                                                                  \
    declare template bool Scene<Real>::occludedWith<Instructions::baseline>(const Point<Real>&, const Vec3<Real>&,     \
                                                                            Real, const Shapes<Real>&) const;
#ifndef RAYTREE_HEADERS_ONLY
RAYTREE_SCENE(extern, float)
RAYTREE_SCENE(extern, double)
RAYTREE_SCENE(extern, long double)
#endif

} // namespace rt
