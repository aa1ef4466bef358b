// Part of scene.h: what a ray meets where flat surfaces lie on one another. coincident.h says which do.
#pragma once

#include "common/scene/scene.h"

namespace rt
{

template <std::floating_point Real>
void Scene<Real>::findSheets(const SceneDescription& description)
{
    for (const auto& found : CoincidentSurfaces(description).sheets())
    {
        if (sheetOf.empty()) sheetOf.assign(spheres.size() + planes.size() + triangles.size(), -1);
        auto& sheet = sheets.emplace_back();
        const auto add = [&](PrimitiveId id) { sheetOf[std::size_t(id)] = std::int32_t(sheets.size()) - 1; };
        for (const int plane : found.planes)
        {
            auto& its = planes[std::size_t(plane)];
            const auto& first = planes[std::size_t(found.planes[0])];
            // One plane, and its distance is computed once.
            its.P = first.P;
            its.N = dot(its.N, first.N) < 0 ? -first.N : first.N;
            sheet.planes.push_back(firstPlane + plane);
            add(firstPlane + plane);
        }
        if (!sheet.planes.empty()) sheet.plane = sheet.planes[0];
        for (const int triangle : found.triangles)
        {
            sheet.triangles.push_back(firstTriangle + triangle);
            sheet.copies.push_back(triangles[std::size_t(triangle)]);
            add(firstTriangle + triangle);
        }
        sheet.search = TriangleSearch<Real>(sheet.copies);
    }
    planesToMeet = planes;
    for (const auto& sheet : sheets)
        for (const auto id : sheet.planes)
            if (id != sheet.plane) planesToMeet[std::size_t(id - firstPlane)].N = Vec3<Real>(0);
}

/// Where surfaces lie on one another, a ray first gets out of glass (-1), then meets what is opaque (0), then gets into glass (1),
/// as if there were a gap of air that has no width. Seen from the other side the order is the reverse.
template <std::floating_point Real>
int Scene<Real>::layerOf(PrimitiveId id, const Vec3<Real>& D) const
{
    if (!materialOf(id).isDielectric()) return 0;
    const Vec3<Real>& N =
        id < firstTriangle ? planes[std::size_t(id - firstPlane)].N : triangles[std::size_t(id - firstTriangle)].N;
    return dot(D, N) > 0 ? -1 : 1;
}

/// Of the surfaces that lie on the plane or triangle `found`, which the ray meets at t: the one that it meets first. Within a
/// layer a triangle comes before a plane, which has no end and would hide it, then the lowest id; the others are never met. For
/// a ray that leaves one of them: the first in a later layer, met where the ray starts, or noPrimitive.
template <std::floating_point Real>
[[gnu::noinline]] PrimitiveId Scene<Real>::foremost(const Ray<Real>& ray, Real t, PrimitiveId found) const
{
    const auto index = sheetOfPrimitive(found);
    if (index < 0) return found;
    const auto& sheet = sheets[std::size_t(index)];
    const bool leaves = ray.from == found;
    const int left = leaves ? layerOf(found, ray.D) : -2;
    PrimitiveId best = noPrimitive;
    std::array<int, 3> order{};
    const auto consider = [&](PrimitiveId id) {
        const int layer = layerOf(id, ray.D);
        const std::array its{layer, int(id < firstTriangle), int(id)};
        if (layer <= left || (best != noPrimitive && order < its)) return;
        best = id;
        order = its;
    };
    consider(found);
    for (const auto id : sheet.planes) consider(id);
    // Which triangles lie there? A ray that arrives asks along itself, as the search does; one that leaves asks along the normal.
    Ray<Real> line = ray;
    if (leaves)
        line.D = found < firstTriangle ? planes[std::size_t(found - firstPlane)].N
                                       : triangles[std::size_t(found - firstTriangle)].N;
    const Vec3<Real> P = ray.O + t * ray.D;
    sheet.search.template visit<Instructions::baseline>(
        sheet.copies, line, infinity<Real>,
        [&](PrimitiveId k) -> std::optional<Real> {
            const auto& triangle = sheet.copies[std::size_t(k)];
            const typename Shapes<Real>::Crossing crossing(line, triangle);
            if (!crossing.isInside() || !Shapes<Real>::isNear(P, ray.O, triangle)) return std::nullopt;
            return t;
        },
        [&](PrimitiveId k, Real) {
            consider(sheet.triangles[std::size_t(k)]);
            return false;
        });
    return best;
}

/// Of a plane or triangle: the others of its sheet are where the ray starts, met there or not at all.
template <std::floating_point Real>
[[gnu::noinline]] auto Scene<Real>::startOn(const Vec3<Real>& O, const Vec3<Real>& D, PrimitiveId from) const -> Start
{
    const auto sheet = sheetOfPrimitive(from);
    if (sheet < 0) return {from, from};
    const auto next = foremost({.O = O, .D = D, .from = from}, 0, from);
    Start start{next, sheets[std::size_t(sheet)].plane};
    if (next != noPrimitive) start.t = std::numeric_limits<Real>::denorm_min();
    return start;
}

} // namespace rt
