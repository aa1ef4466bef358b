// Part of scene.h: how a scene is made of its description. Numbers are converted to the tracer's type once, here, and what does
// not fit it is refused.
#pragma once

#include "common/scene/scene.h"

namespace rt
{

template <std::floating_point Real>
Scene<Real>::Scene(const SceneDescription& description)
try : camera(description.camera), settings(description.trace), sky(description.sky)
{
    for (const auto& m : description.materials)
    {
        const std::string name = "materials." + m.name;
        materials.push_back({m.name, narrowColor<Real>(m.color, name + ".color"),
                             narrow<Real>(m.mirror, name + ".mirror"), narrow<Real>(m.ior, name + ".ior"),
                             narrow<Real>(m.iorOutside, name + ".ior_outside"),
                             narrow<Real>(m.glossy, name + ".glossy"), narrow<Real>(m.exponent, name + ".exponent")});
        // V.R is 1 up to some eps, and its power grows with the exponent. A highlight so narrow that directions cannot
        // resolve it is not made narrower, or it would get infinitely bright.
        auto& mat = materials.back();
        mat.exponent = std::min(mat.exponent, 1 / std::numeric_limits<Real>::epsilon());
        if (mat.isDielectric())
            for (const Real ratio : {mat.ior / mat.iorOutside, mat.iorOutside / mat.ior})
                if (const auto square = double(ratio * ratio); !std::isfinite(square) || square == 0)
                    throw UnfitNumber(name + ".ior", "the square of n1 / n2 in " + name + " = " +
                                                         shortestDigits(double(ratio) * double(ratio)) +
                                                         " does not fit the tracer's scalar type");
    }
    for (const auto& s : description.spheres)
    {
        const std::string name = "sphere" + std::to_string(spheres.size());
        spheres.push_back(
            {narrow<Real>(s.center, name + ".center"), narrow<Real>(s.radius, name + ".radius"), s.material});
        const Wide<Real> r = spheres.back().r;
        if (!isOrdinary(r * r))
            throw UnfitNumber(name + ".radius", "the square of " + name + ".radius = " + shortestDigits(s.radius) +
                                                    " does not fit the tracer's scalar type");
    }
    for (const auto& p : description.planes)
    {
        const std::string name = "plane" + std::to_string(planes.size());
        Plane<Real> plane{.P = narrow<Real>(p.point, name + ".point"),
                          .N = unit(Vec3<Real>(unit(Vec3<Wide<Real>>(p.normal)))),
                          .material = p.material};
        if (p.hasChecker)
        {
            plane.checkerMaterial = int(materials.size());
            plane.checkerSize = narrow<Real>(p.checkerSize, name + ".checker.size");
            materials.push_back(materials[std::size_t(p.material)]);
            materials.back().color = narrowColor<Real>(p.checkerColor, name + ".checker.color");

            // The axes are the two world axes that the plane faces least, laid into the plane: x and z for a floor.
            const Vec3<Real> N = plane.N, size = abs(N);
            const int main = size.y >= size.x && size.y >= size.z ? 1 : (size.x >= size.z ? 0 : 2);
            Vec3<Real> U(0), V(0);
            U[main == 0 ? 1 : 0] = 1;
            V[main == 2 ? 1 : 2] = 1;
            plane.U = unit(U - dot(U, N) * N);
            plane.V = unit(cross(N, plane.U));
            if (dot(plane.V, V) < 0) plane.V = -plane.V;
        }
        planes.push_back(plane);
    }
    const auto addTriangle = [&](const std::array<Vec3<double>, 3>& vertices, int material, const std::string& name) {
        // The normal is that of the rounded corners: those are what rays meet.
        const auto a = narrow<Real>(vertices[0], name), b = narrow<Real>(vertices[1], name),
                   c = narrow<Real>(vertices[2], name);
        using Vec = Vec3<Wide<Real>>;
        const auto N = unit(cross(unit(Vec(b) - Vec(a)), unit(Vec(c) - Vec(a))));
        const auto most = [](const Vec& v) { return largestChannel(abs(v)); };
        const auto size = std::max(most(Vec(b) - Vec(a)), most(Vec(c) - Vec(a))), far = std::max(most(Vec(a)), size);
        if (N != Vec(0) && !(isOrdinary(size * size * size) && isOrdinary(far * far * far)))
            throw UnfitNumber(name, name + ": the third power of " + shortestDigits(double(far > 1 ? far : size)) +
                                        " does not fit the tracer's scalar type");
        triangles.push_back({a, b, c, Vec3<Real>(N), material});
    };
    for (const auto& t : description.triangles)
        addTriangle(t.vertices, t.material, "triangle" + std::to_string(triangles.size()) + ".vertices");
    for (const auto& mesh : description.meshes)
    {
        meshes.push_back(PrimitiveId(triangles.size()));
        const auto name = "mesh" + std::to_string(meshes.size() - 1) + ".file";
        for (const auto& vertices : *mesh.triangles) addTriangle(vertices, mesh.material, name);
    }
    for (const auto& l : description.lights)
    {
        const std::string name = "light" + std::to_string(lights.size());
        lights.push_back({narrow<Real>(l.position, name + ".position"), narrowColor<Real>(l.color, name + ".color")});
    }
    // 64 is more than a highlight adds, even one of the largest exponent.
    for (const auto& light : lights)
        nearestLamp = std::max(nearestLamp, largestChannel(light.color) / std::numeric_limits<Real>::max() * 64 *
                                                Real(lights.size()));
    firstPlane = PrimitiveId(spheres.size());
    firstTriangle = PrimitiveId(spheres.size() + planes.size());
    if (settings.cutoff > 0) brightest = brightestReturn();
    firstOfSpheres = firstOfEqualSpheres(description.spheres);
    findSheets(description);
    sphereSearch = SphereSearch<Real>(spheres, SphereSearch<Real>::mostScanned, firstOfSpheres);
    triangleSearch = TriangleSearch<Real>(triangles);
    isScanned = spheres.size() <= SphereSearch<Real>::mostScanned && triangles.empty() && sheets.empty();
}
catch (const UnfitNumber& error)
{
    throw UnfitNumber(error.field, description.placeOf(error.field) + error.what());
}

} // namespace rt
