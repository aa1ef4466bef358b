#include "bench_scenes.h"

#include <charconv>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "common/files/scene_file.h"
#include "common/program/program.h"

namespace rt::perf
{

namespace
{

/// In [0, 1). The distributions of the standard library differ from one to the next, its engines do not.
double uniform(std::mt19937& engine)
{
    return double(engine()) / 4294967296.0;
}

/// s5 with another number of spheres: one in each cell of a square grid, standing on the floor, none touching another.
SceneDescription scattered(int count)
{
    SceneDescription scene = benchScene("s5");
    scene.title = fmt::format("benchmark s5:{}", count);
    scene.spheres.clear();
    std::mt19937 engine(5);
    const auto floor = scene.materials[std::size_t(scene.planes[0].material)];
    scene.materials = {floor};
    scene.planes[0].material = 0;
    // As in s5, of ten spheres three are diffuse, three reflect half, two all, two are glass.
    constexpr int palette = 60;
    for (int i = 0; i < palette; ++i)
    {
        Material<double> mat{.name = fmt::format("M{}", i)};
        const int kind = i % 10;
        if (kind < 8)
            mat.color = {0.2 + 0.7 * uniform(engine), 0.2 + 0.7 * uniform(engine), 0.2 + 0.7 * uniform(engine)};
        mat.mirror = kind < 3 ? 0 : kind < 6 ? 0.5 : kind < 8 ? 1 : 0;
        mat.ior = kind < 8 ? 0 : 1.5;
        scene.materials.push_back(mat);
    }
    const int side = int(std::ceil(std::sqrt(double(count))));
    const double cell = 10.0 / side;
    for (int i = 0; i < count; ++i)
    {
        const double r = (0.28 + 0.17 * uniform(engine)) * cell, room = 0.45 * cell - r;
        const double x = -5 + (i % side + 0.5) * cell + (2 * uniform(engine) - 1) * room;
        const double z = -5 + (i / side + 0.5) * cell + (2 * uniform(engine) - 1) * room;
        scene.spheres.push_back({{x, r, z}, r, 1 + int(engine() % palette)});
    }
    return scene;
}

double rounded(double x)
{
    return std::round(x * 1e9) / 1e9 + 0.0;
}

/// Nine spheres of a third of the radius on each: six around the equator of the parent's frame, three above. (Haines, "A
/// Proposal for Standard Graphics Environments", IEEE CG&A 1987)
void grow(std::vector<SphereDescription>& spheres, const Vec3<double>& center, double radius, const Vec3<double>& up,
          int levels)
{
    spheres.push_back({{rounded(center.x), rounded(center.y), rounded(center.z)}, rounded(radius), 0});
    if (levels == 0) return;
    const Vec3<double> axis = std::abs(up.x) < 0.9 ? Vec3<double>(1, 0, 0) : Vec3<double>(0, 1, 0);
    const Vec3<double> x = unit(axis - dot(axis, up) * up), z = cross(x, up);
    using std::numbers::pi;
    for (int k = 0; k < 9; ++k)
    {
        const double angle = k < 6 ? k * pi / 3 : pi / 6 + (k - 6) * 2 * pi / 3;
        const double height = k < 6 ? 0 : std::sqrt(2.0 / 3), ring = k < 6 ? 1 : std::sqrt(1.0 / 3);
        const Vec3<double> way = ring * std::cos(angle) * x + height * up - ring * std::sin(angle) * z;
        grow(spheres, center + radius * 4 / 3 * way, radius / 3, way, levels - 1);
    }
}

SceneDescription sphereflake(int levels)
{
    SceneDescription scene;
    scene.title = levels == 4 ? "benchmark s6" : fmt::format("benchmark s6:{}", levels);
    scene.camera = {.eye = {2.1, 1.7, 1.3},
                    .target = {1.399610787, 1.133018256, 0.866425725},
                    .verticalFov = 45,
                    .width = 1024,
                    .height = 768};
    scene.materials = {{.name = "M0", .color = {1, 0.9, 0.7}, .mirror = 0.5},
                       {.name = "floor", .color = {0.8, 0.6, 0.3}}};
    scene.planes = {{.point = {0, -0.5, 0},
                     .normal = {0, 1, 0},
                     .material = 1,
                     .hasChecker = true,
                     .checkerColor = {0.4, 0.3, 0.15},
                     .checkerSize = 0.5}};
    scene.lights = {{{4, 2, -3}, {9, 9, 9}}, {{1, 4, 4}, {14, 14, 14}}};
    grow(scene.spheres, {0, 0, 0}, 0.5, {0, 1, 0}, levels);
    return scene;
}

/// The number after the colon.
int numberIn(const std::string& name, int least, int most)
{
    int number = 0;
    const char *first = name.data() + 3, *last = name.data() + name.size();
    const auto [end, error] = std::from_chars(first, last, number);
    if (error != std::errc() || end != last || number < least || number > most)
        throw SceneError(fmt::format("{}: expected a whole number from {} to {} after the colon", name, least, most));
    return number;
}

} // namespace

SceneDescription benchScene(const std::string& name)
{
    SceneDescription scene;
    if (name.rfind("s5:", 0) == 0)
        scene = scattered(numberIn(name, 1, 10'000'000));
    else if (name == "s6" || name.rfind("s6:", 0) == 0)
        scene = sphereflake(name == "s6" ? 4 : numberIn(name, 0, 7));
    else if (name.size() == 2 && name[0] == 's' && name[1] >= '1' && name[1] <= '5')
        return loadScene(projectFile("tests/perf/scenes/" + name + ".toml"));
    else if (name.size() > 5 && name.ends_with(".toml"))
        return loadScene(name);
    else
        throw SceneError(
            fmt::format("there is no scene \"{}\"; expected s1 to s6, s5:N, s6:LEVELS or a file .toml", name));
    scene.file = name;
    return scene;
}

void setLights(SceneDescription& scene, int count)
{
    Vec3<double> sum(0);
    for (const auto& light : scene.lights) sum += light.color;
    scene.lights.clear();
    for (int i = 0; i < count; ++i)
    {
        const double angle = 2 * std::numbers::pi * (i + 0.25) / count;
        scene.lights.push_back({{5 * std::cos(angle), 6.5, 3 + 5 * std::sin(angle)}, sum / double(count)});
    }
}

void setSize(SceneDescription& scene, int width, int height)
{
    scene.camera.width = width;
    scene.camera.height = height;
    scene.camera.pixelX = scene.camera.pixelY = -1;
}

} // namespace rt::perf
