// Numbers of a scene file that the tracer's scalar type cannot hold: refused at their place, and never rounded to 0 or infinity.
#include <gtest/gtest.h>

#include "common/files/scene_file.h"
#include "common/scene/scene.h"

namespace rt
{

namespace
{

// One field a line, so that each has a line of its own.
const std::string fits = R"([camera]
eye = [0, 0, 5]
vertical_fov = 40
[sky]
horizon = [1, 1, 1]
zenith = [0, 0, 1]
sun = { direction = [0, 1, 0], color = [9, 9, 9] }
[materials.grey]
color = [0.5, 0.5, 0.5]
[materials.shiny]
mirror = 0.5
[materials.glass]
ior = 1.5
ior_outside = 1
[[sphere]]
center = [0, 0, 0]
radius = 1
material = "grey"
[[sphere]]
center = [3, 0, 0]
radius = 2
material = "glass"
[[plane]]
point = [0, -1, 0]
normal = [0, 1, 0]
material = "grey"
checker = { color = [0.1, 0.1, 0.1], size = 1 }
[[triangle]]
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
material = "grey"
[[light]]
position = [0, 5, 0]
color = [7, 7, 7]
)";

struct Misfit
{
    std::string from, to, place, field;
};

// Each is within double, and beyond float. A line of text may stand more than once; the last one is changed.
const std::vector<Misfit> misfits = {
    {"eye = [0, 0, 5]", "eye = [0, 0, 1e39]", "2:7", "camera.eye = 1e+39"},
    {"vertical_fov = 40", "vertical_fov = 1e-46", "3:16", "camera.vertical_fov = 1e-46"},
    {"vertical_fov = 40", "vertical_fov = 179.9999999", "3:16", "camera.vertical_fov = 179.9999999"},
    {"horizon = [1, 1, 1]", "horizon = [1, 1, 2e39]", "5:11", "sky.horizon = 2e+39"},
    {"zenith = [0, 0, 1]", "zenith = [0, 1e-50, 1]", "6:10", "sky.zenith = 1e-50"},
    {"color = [9, 9, 9]", "color = [9, 1e60, 9]", "7:40", "sky.sun.color = 1e+60"},
    {"color = [0.5, 0.5, 0.5]", "color = [0.5, 0.5, 1e-60]", "9:9", "materials.grey.color = 1e-60"},
    {"mirror = 0.5", "mirror = 1e-99", "11:10", "materials.shiny.mirror = 1e-99"},
    {"ior = 1.5", "ior = 1e39", "13:7", "materials.glass.ior = 1e+39"},
    {"ior = 1.5", "ior = 1e20", "13:7", "the square of n1 / n2 in materials.glass = 1"},
    {"ior_outside = 1\n", "ior_outside = 1e-46\n", "14:15", "materials.glass.ior_outside = 1e-46"},
    {"center = [3, 0, 0]", "center = [3, 0, -1e40]", "20:10", "sphere1.center = -1e+40"},
    {"radius = 2", "radius = 1e-46", "21:10", "sphere1.radius = 1e-46"},
    {"point = [0, -1, 0]", "point = [0, 1e39, 0]", "24:9", "plane0.point = 1e+39"},
    {"size = 1", "size = 1e-47", "27:45", "plane0.checker.size = 1e-47"},
    {"color = [0.1, 0.1, 0.1]", "color = [0.1, 1e-47, 0.1]", "27:21", "plane0.checker.color = 1e-47"},
    {"[0, 1, 0]]", "[0, 1e39, 0]]", "29:12", "triangle0.vertices = 1e+39"},
    {"position = [0, 5, 0]", "position = [0, 5, 1e39]", "32:12", "light0.position = 1e+39"},
    {"color = [7, 7, 7]", "color = [7, 7, 1e-46]", "33:9", "light0.color = 1e-46"},
};

// What double cannot square or cube.
const std::vector<Misfit> misfitsOfDouble = {
    {"ior = 1.5", "ior = 1e155", "13:7", "the square of n1 / n2 in materials.glass = inf"},
    {"radius = 2", "radius = 1e200", "21:10", "the square of sphere1.radius = 1e+200"},
    {"radius = 2", "radius = 1e-200", "21:10", "the square of sphere1.radius = 1e-200"},
    {"[0, 1, 0]]", "[0, 1e150, 0]]", "29:12", "triangle0.vertices: the third power of 1e+150"},
};

SceneDescription changed(const Misfit& misfit)
{
    std::string text = fits;
    const auto found = text.rfind(misfit.from);
    EXPECT_NE(found, text.npos) << misfit.from;
    return parseScene(text.replace(found, misfit.from.size(), misfit.to), "scene.toml");
}

template <class Real>
void expectRefusal(const Misfit& misfit)
{
    try
    {
        const Scene<Real> narrowed(changed(misfit));
        ADD_FAILURE() << "accepted: " << misfit.to;
    }
    catch (const std::range_error& error)
    {
        const std::string said = error.what(), expected = "scene.toml:" + misfit.place + ": " + misfit.field;
        EXPECT_EQ(said.substr(0, expected.size()), expected) << said;
        EXPECT_NE(said.find(" does not fit the tracer's scalar type"), said.npos) << said;
    }
}

TEST(UnfitNumber, IsRefusedWithFileLineAndTheNumberAsItWasWritten)
{
    EXPECT_NO_THROW(Scene<float>(parseScene(fits, "scene.toml")));
    for (const auto& misfit : misfits)
    {
        EXPECT_NO_THROW(Scene<double>{changed(misfit)}) << misfit.to;
        expectRefusal<float>(misfit);
    }
    for (const auto& misfit : misfitsOfDouble) expectRefusal<double>(misfit);
}

TEST(UnfitNumber, OfASceneWithoutFileIsNamedOnly)
{
    SceneDescription scene;
    scene.camera.eye.x = 1e39;
    try
    {
        const Scene<float> narrowed(scene);
        ADD_FAILURE();
    }
    catch (const std::range_error& error)
    {
        EXPECT_STREQ(error.what(), "camera.eye = 1e+39 does not fit the tracer's scalar type");
    }
}

} // namespace

} // namespace rt
