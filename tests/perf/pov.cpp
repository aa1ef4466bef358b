#include "pov.h"

#include <fmt/format.h>

#include "common/files/scene_file.h"
#include "common/scene/camera.h"
#include "common/scene/scene.h"

namespace rt::perf
{

namespace
{

std::string vector(const Vec3<double>& v)
{
    return fmt::format("<{}, {}, {}>", v.x, v.y, v.z);
}

void refuseWhatDiffers(const SceneDescription& scene)
{
    const auto refuse = [&](const std::string& what) {
        throw SceneError(scene.file + ": no picture of POV-Ray can be compared, since it has no equal of " + what);
    };
    if (scene.sky.zenith || scene.sky.sun || scene.sky.image) refuse("a sky that is not one colour");
    if (scene.trace.cutoff != 0) refuse("cutoff");
    if (scene.trace.atCap != AtCap::black) refuse("at_cap other than \"black\"");
    if (scene.trace.fresnel != FresnelModel::exact) refuse("fresnel other than \"exact\"");
    if (scene.trace.shadowThroughGlass != ShadowThroughGlass::block)
        refuse("shadow_through_glass other than \"block\"");
    for (const auto& mat : scene.materials)
    {
        if (mat.glossy != 0) refuse("a glossy material, as materials." + mat.name);
        if (mat.isDielectric() && mat.color != Vec3<double>(1)) refuse("coloured glass, as materials." + mat.name);
    }
}

/// The block after a shape: pigment, finish, interior.
std::string surface(const Material<double>& mat, const std::string& pigment)
{
    if (mat.isDielectric())
        return fmt::format(
            "pigment {{ rgbt 1 }} finish {{ diffuse 0 reflection {{ 0, 1 fresnel on }} conserve_energy }} "
            "interior {{ ior {} }}",
            mat.ior / mat.iorOutside);
    std::string finish = fmt::format("diffuse {}", 1 - mat.mirror);
    if (mat.mirror > 0) finish += fmt::format(" reflection {{ rgb {} }}", vector(mat.mirror * mat.color));
    return fmt::format("pigment {{ {} }} finish {{ {} }}", pigment, finish);
}

std::string plainSurface(const Material<double>& mat)
{
    return surface(mat, "rgb " + vector(mat.color));
}

/// Light passes POV-Ray's clear materials. So what is seen casts no shadow, and what is opaque and stands in the same place
/// does nothing else.
std::string shape(const std::string& geometry, const Material<double>& mat, const std::string& looks)
{
    if (!mat.isDielectric()) return fmt::format("{} {} }}\n", geometry, looks);
    return fmt::format("{0} {1} no_shadow }}\n{0} pigment {{ rgb 0 }} no_image no_reflection }}\n", geometry, looks);
}

/// The plane's own axes come from Scene, which laid the checker into it. Half a huge cell below the plane, or rounding
/// would choose between two layers of cubes.
std::string planeText(const PlaneDescription& description, const Plane<double>& plane, const Material<double>& mat)
{
    const double d = dot(plane.P, plane.N), size = description.checkerSize, high = 1e6;
    std::string pigment = "rgb " + vector(mat.color);
    if (description.hasChecker)
        pigment =
            fmt::format("checker rgb {}, rgb {} scale <{}, {}, {}> translate <0, {}, 0> matrix <{}, {}, {}, {}, {}, "
                        "{}, {}, {}, {}, {}, {}, {}>",
                        vector(mat.color), vector(description.checkerColor), size, high, size, -high / 2, plane.U.x,
                        plane.U.y, plane.U.z, plane.N.x, plane.N.y, plane.N.z, plane.V.x, plane.V.y, plane.V.z,
                        d * plane.N.x, d * plane.N.y, d * plane.N.z);
    return shape(fmt::format("plane {{ {}, {}", vector(plane.N), d), mat, surface(mat, pigment));
}

std::string cameraText(const CameraDescription& camera)
{
    // Three vectors, so that it does not matter that POV-Ray is left-handed.
    const Vec3<double> f = unit(camera.target - camera.eye), r = unit(cross(f, unit(camera.up))), u = cross(r, f);
    const double high = 2 * std::tan(camera.verticalFov * SkyFormulas<double>::PI / 360);
    return fmt::format("camera {{ perspective location {} direction {} right {} up {} }}\n", vector(camera.eye),
                       vector(f), vector(r * (high * camera.width / camera.height)), vector(u * high));
}

} // namespace

std::string povScene(const SceneDescription& scene)
{
    refuseWhatDiffers(scene);
    const Scene<double> placed(scene);
    const auto material = [&](int index) -> const auto&
    {
        return scene.materials[std::size_t(index)];
    };
    // Its camera ray has level 1, ours depth 0.
    std::string text = fmt::format("// {}: {}\n#version 3.7;\n"
                                   "global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout 0 }}\n"
                                   "#default {{ finish {{ ambient 0 emission 0 }} }}\n"
                                   "background {{ rgb {} }}\n",
                                   scene.file, scene.title, scene.trace.maxDepth + 1, vector(scene.sky.color));
    text += cameraText(scene.camera);
    // It weakens light by 2 / (1 + (distance / f)²): with an f so small that the 1 does not count, that is 2 f² / distance².
    const double f = 1e-4;
    for (const auto& light : scene.lights)
        text += fmt::format("light_source {{ {} rgb {} fade_distance {} fade_power 2 }}\n", vector(light.position),
                            vector(light.color / (2 * f * f)), f);
    for (std::size_t i = 0; i < scene.planes.size(); ++i)
        text += planeText(scene.planes[i], placed.planes[i], material(scene.planes[i].material));
    for (const auto& s : scene.spheres)
        text += shape(fmt::format("sphere {{ {}, {}", vector(s.center), s.radius), material(s.material),
                      plainSurface(material(s.material)));
    const auto triangle = [&](const std::array<Vec3<double>, 3>& v, int index) {
        const auto& mat = material(index);
        text += shape(fmt::format("triangle {{ {}, {}, {}", vector(v[0]), vector(v[1]), vector(v[2])), mat,
                      plainSurface(mat));
    };
    for (const auto& t : scene.triangles) triangle(t.vertices, t.material);
    for (const auto& mesh : scene.meshes)
        for (const auto& vertices : *mesh.triangles) triangle(vertices, mesh.material);
    return text;
}

} // namespace rt::perf
