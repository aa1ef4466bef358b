#include <iterator>

#include "common/files/scene_file.h"
#include "common/files/scene_reader.h"

namespace rt
{

namespace
{

using Out = std::back_insert_iterator<std::string>;

/// A TOML string in double quotes.
std::string tomlString(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text)
    {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F)
            result += fmt::format("\\u{:04x}", byte);
        else
        {
            if (c == '"' || c == '\\') result += '\\';
            result += c;
        }
    }
    return result + '"';
}

/// A name as a key: bare if TOML allows that, else in quotes.
std::string tomlKey(const std::string& name)
{
    constexpr auto bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return name.empty() || name.find_first_not_of(bare) != name.npos ? tomlString(name) : name;
}

std::string tomlTriple(const Vec3<double>& v)
{
    return fmt::format("[{}, {}, {}]", tomlNumber(v.x), tomlNumber(v.y), tomlNumber(v.z));
}

void write(Out out, const CameraDescription& camera)
{
    fmt::format_to(out, "\n[camera]\neye = {}\ntarget = {}\nup = {}\nvertical_fov = {}\nsize = [{}, {}]\n",
                   tomlTriple(camera.eye), tomlTriple(camera.target), tomlTriple(camera.up),
                   tomlNumber(camera.verticalFov), camera.width, camera.height);
    if (camera.pixelX >= 0 && camera.pixelY >= 0)
        fmt::format_to(out, "pixel = [{}, {}]\n", camera.pixelX, camera.pixelY);
}

void write(Out out, const TraceSettings& trace)
{
    fmt::format_to(out,
                   "\n[trace]\nmax_depth = {}\ncutoff = {}\nat_cap = \"{}\"\nfresnel = \"{}\"\n"
                   "shadow_through_glass = \"{}\"\n",
                   trace.maxDepth, tomlNumber(trace.cutoff), atCapWords[std::size_t(trace.atCap)],
                   fresnelWords[std::size_t(trace.fresnel)],
                   shadowThroughGlassWords[std::size_t(trace.shadowThroughGlass)]);
}

void write(Out out, const SkyDescription& sky)
{
    fmt::format_to(out, "\n[sky]\n");
    if (!sky.imageFile.empty())
        fmt::format_to(out, "image = {}\nmapping = \"{}\"\n", tomlString(sky.imageFile),
                       skyMappingWords[std::size_t(sky.mapping)]);
    else if (sky.zenith)
        fmt::format_to(out, "horizon = {}\nzenith = {}\n", tomlTriple(sky.color), tomlTriple(*sky.zenith));
    else
        fmt::format_to(out, "color = {}\n", tomlTriple(sky.color));
    if (sky.sun)
        fmt::format_to(out, "sun = {{ direction = {}, color = {}, size = {} }}\n", tomlTriple(sky.sun->direction),
                       tomlTriple(sky.sun->color), tomlNumber(sky.sun->size));
}

void write(Out out, const Material<double>& material)
{
    fmt::format_to(out, "\n[materials.{}]\ncolor = {}\n", tomlKey(material.name), tomlTriple(material.color));
    if (material.isDielectric())
        fmt::format_to(out, "ior = {}\nior_outside = {}\n", tomlNumber(material.ior), tomlNumber(material.iorOutside));
    else
        fmt::format_to(out, "mirror = {}\nglossy = {}\n", tomlNumber(material.mirror), tomlNumber(material.glossy));
    fmt::format_to(out, "exponent = {}\n", tomlNumber(material.exponent));
}

} // namespace

std::string sceneToToml(const SceneDescription& scene)
{
    std::string text;
    const Out out(text);
    const auto material = [&](int index) { return tomlString(scene.materials.at(std::size_t(index)).name); };

    fmt::format_to(out, "title = {}\n", tomlString(scene.title));
    write(out, scene.camera);
    write(out, scene.trace);
    if (scene.sky.present) write(out, scene.sky);
    for (const auto& m : scene.materials) write(out, m);
    for (const auto& s : scene.spheres)
        fmt::format_to(out, "\n[[sphere]]\ncenter = {}\nradius = {}\nmaterial = {}\n", tomlTriple(s.center),
                       tomlNumber(s.radius), material(s.material));
    for (const auto& p : scene.planes)
    {
        fmt::format_to(out, "\n[[plane]]\npoint = {}\nnormal = {}\nmaterial = {}\n", tomlTriple(p.point),
                       tomlTriple(p.normal), material(p.material));
        if (p.hasChecker)
            fmt::format_to(out, "checker = {{ color = {}, size = {} }}\n", tomlTriple(p.checkerColor),
                           tomlNumber(p.checkerSize));
    }
    for (const auto& t : scene.triangles)
        fmt::format_to(out, "\n[[triangle]]\nvertices = [{}, {}, {}]\nmaterial = {}\n", tomlTriple(t.vertices[0]),
                       tomlTriple(t.vertices[1]), tomlTriple(t.vertices[2]), material(t.material));
    for (const auto& m : scene.meshes)
        fmt::format_to(out, "\n[[mesh]]\nfile = {}\nmaterial = {}\n", tomlString(m.file), material(m.material));
    for (const auto& l : scene.lights)
        fmt::format_to(out, "\n[[light]]\nposition = {}\ncolor = {}\n", tomlTriple(l.position), tomlTriple(l.color));
    return text;
}

} // namespace rt
