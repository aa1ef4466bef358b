// The same pictures with Embree's sphere geometry, one ray at a time: a peer to compare speed with, and not a second tracer
// of the course. It uses Embree's hits and our scene description; the formulas are those of lesson 06, in float, which is
// all that Embree has. Spheres and planes only, the policies of s1 to s6 only.
#include <chrono>

// Debian 12 has Embree 3, Debian 13 has Embree 4.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "bench_common.h"
#include "common/base/image.h"
#include "common/files/picture_file.h"
#include "common/files/scene_file.h"
#include "common/program/guarded_main.h"
#include "common/scene/camera.h"
#include "common/scene/scene.h"

namespace
{

#if RTC_VERSION_MAJOR >= 4
void findNearest(RTCScene scene, RTCRayHit& query)
{
    rtcIntersect1(scene, &query);
}

void findAny(RTCScene scene, RTCRay& ray)
{
    rtcOccluded1(scene, &ray);
}
#else
void findNearest(RTCScene scene, RTCRayHit& query)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &query);
}

void findAny(RTCScene scene, RTCRay& ray)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
}
#endif

using namespace rt;
using namespace rt::perf;
using vec3 = Vec3<float>;

/// Embree knows no ray's origin: it must start a little off the surface, by this share of the coordinates.
constexpr float offShare = 5e-6F;

struct Peer
{
    const Scene<float>& scene; // materials, planes, lights, camera; no ray asks its search
    RTCScene spheres;
    RayCounts counts = {};
    const int maxDepth = scene.settings.maxDepth;

    struct Found
    {
        vec3 I, N; // N faces the ray
        const Material<float>* mat;
        bool inside;
    };

    static float startOf(const vec3& O)
    {
        return offShare * (1 + std::max({std::abs(O.x), std::abs(O.y), std::abs(O.z)}));
    }

    /// Embree has no plane: ours, asked one after the other.
    const Plane<float>* nearestPlane(const vec3& O, const vec3& D, float start, float& end) const
    {
        const Plane<float>* nearest = nullptr;
        for (const auto& plane : scene.planes)
        {
            const float t = dot(plane.P - O, plane.N) / dot(D, plane.N);
            if (!(t > start && t < end)) continue;
            end = t;
            nearest = &plane;
        }
        return nearest;
    }

    static RTCRay rtcRay(const vec3& O, const vec3& D, float start, float end)
    {
        return {O.x, O.y, O.z, start, D.x, D.y, D.z, 0, end, ~0U, 0, 0};
    }

    bool intersect(const vec3& O, const vec3& D, float start, Found& found) const
    {
        float t = infinity<float>;
        const Plane<float>* plane = nearestPlane(O, D, start, t);
        RTCRayHit query{rtcRay(O, D, start, t), {}};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        findNearest(spheres, query);
        if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID)
        {
            const auto& sphere = scene.spheres[query.hit.primID];
            found.N = unit(O + query.ray.tfar * D - sphere.C);
            found.I = sphere.C + sphere.r * found.N;
            found.mat = &scene.materials[std::size_t(sphere.material)];
        }
        else if (plane)
        {
            found.I = O + t * D;
            found.I -= dot(found.I - plane->P, plane->N) * plane->N;
            found.N = plane->N;
            found.mat = &scene.materials[std::size_t(plane->materialAt(found.I))];
        }
        else
            return false;
        found.inside = dot(D, found.N) > 0;
        if (found.inside) found.N = -found.N;
        return true;
    }

    bool occluded(const vec3& O, const vec3& L, float start, float distance) const
    {
        float end = distance;
        if (nearestPlane(O, L, start, end)) return true;
        RTCRay ray = rtcRay(O, L, start, distance);
        findAny(spheres, ray);
        return ray.tfar < 0;
    }

    vec3 direct(const vec3& I, const vec3& N)
    {
        vec3 sum(0);
        for (const auto& light : scene.lights)
        {
            vec3 L = light.position - I;
            const float distance = length(L), cosine = dot(N, L) / distance;
            L *= 1 / distance;
            ++counts.shadow;
            if (occluded(I, L, startOf(I), distance)) continue;
            sum += light.color * (std::max(0.0F, cosine) / (distance * distance));
        }
        return sum;
    }

    vec3 trace(const vec3& O, const vec3& D, RayKind kind, int depth)
    {
        if (depth > maxDepth) return vec3(0);
        counts.add(kind);
        Found hit;
        if (!intersect(O, D, depth == 0 ? 0 : startOf(O), hit)) return scene.sky.color(D);
        const auto& mat = *hit.mat;
        const vec3 R = unit(D - 2 * dot(D, hit.N) * hit.N);
        if (!mat.isDielectric())
        {
            const float s = mat.mirror;
            vec3 color(0);
            if (s < 1) color = (1 - s) * mat.color * direct(hit.I, hit.N);
            if (s > 0) color += s * mat.color * trace(hit.I, R, reflected, depth + 1);
            return color;
        }
        const float n1 = hit.inside ? mat.ior : mat.iorOutside, n2 = hit.inside ? mat.iorOutside : mat.ior;
        const float eta = n1 / n2, cos1 = -dot(D, hit.N), k = 1 - eta * eta * (1 - cos1 * cos1);
        if (k < 0) return mat.color * trace(hit.I, R, reflected, depth + 1);
        const float cos2 = std::sqrt(k), rs = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2),
                    rp = (n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1), Fr = (rs * rs + rp * rp) / 2;
        const vec3 T = unit(eta * D + (eta * cos1 - cos2) * hit.N);
        vec3 color(0);
        if (Fr > 0) color += Fr * mat.color * trace(hit.I, R, reflected, depth + 1);
        return color + (1 - Fr) * mat.color * trace(hit.I, T, transmitted, depth + 1);
    }
};

RTCScene embreeScene(RTCDevice device, const Scene<float>& scene)
{
    RTCScene all = rtcNewScene(device);
    if (!scene.spheres.empty())
    {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* data = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                                 4 * sizeof(float), scene.spheres.size()));
        for (const auto& sphere : scene.spheres)
        {
            for (int axis = 0; axis < 3; ++axis) *data++ = sphere.C[axis];
            *data++ = sphere.r;
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(all, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(all);
    return all;
}

Measured measure(const SceneDescription& description, const SceneOptions& options)
{
    if (!description.triangles.empty() || !description.meshes.empty())
        throw SceneError(description.file + ": expected spheres and planes only");
    Measured measured{.program = "embree", .real = "float", .instructions = "embree"};
    const Scene<float> scene(description);
    RTCDevice device = rtcNewDevice("threads=1");
    const double bytes = allocatedBytes(), start = cpuSeconds();
    Peer peer{scene, embreeScene(device, scene)};
    measured.buildCpu = cpuSeconds() - start;
    measured.bytes = allocatedBytes() - bytes;
    const int width = description.camera.width, height = description.camera.height;
    Image image(width, height);
    for (int i = 0; i < options.repeat; ++i)
    {
        peer.counts = {};
        const double cpu = cpuSeconds();
        const auto wall = std::chrono::steady_clock::now();
        for (int y = 0; y < height && !interrupted(); ++y)
            for (int x = 0; x < width; ++x)
            {
                const auto ray = scene.camera.ray(float(x) + 0.5F, float(y) + 0.5F);
                image.at(x, y) = Vec3<double>(peer.trace(ray.O, ray.D, RayKind::camera, 0));
            }
        measured.cpu.push_back(cpuSeconds() - cpu);
        measured.wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count());
    }
    measured.rays = peer.counts;
    rtcReleaseScene(peer.spheres);
    rtcReleaseDevice(device);
    if (!options.out.empty() && !interrupted()) writeImage(image, options.out);
    return measured;
}

int run(int argc, char** argv)
{
    CommandLine app("Measures one picture with Embree's sphere geometry; prints one line of JSON.", "bench_embree");
    SceneOptions options;
    return runBench(app, argc, argv, options, [&](const SceneDescription& scene) { return measure(scene, options); });
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
