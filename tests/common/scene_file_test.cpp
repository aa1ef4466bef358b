#include <atomic>
#include <bit>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/base/nearest_word.h"
#include "common/files/picture_file.h"
#include "common/files/scene_file.h"
#include "common/files/scene_reader.h"
#include "tests/common/growth.h"
#include "tests/common/mutated.h"

namespace
{

using namespace rt;
namespace fs = std::filesystem;

/// Every section and every key once, but for those that exclude others or name files.
const std::string everything = R"(title = "One 50% specular, one glass sphere"

[camera]
eye = [0.0, 1.5, 6.0]
target = [0, 1, 0]
up = [0.0, 2.0, 0.0]
vertical_fov = 40
size = [320, 240]
pixel = [212, 115]

[trace]
max_depth = 5
cutoff = 0.001
at_cap = "direct"
fresnel = "schlick"
shadow_through_glass = "tint"

[sky]
color = [0.2, 0.3, 5]
sun = { direction = [3, 4, 0], color = [100, 90.5, 80], size = 0.53 }

[[sphere]]
center = [0.0, 1.0, 0.0]
radius = 1
material = "glass"

[[sphere]]
center = [3.0, 1.0, 0.0]
radius = 0.5
material = "half"

[materials.plastic]
color = [0.7, 0.1, 0.1]
glossy = 0.3
exponent = 50.0
[materials.half]
color = [1.0, 0.9, 0.8]
mirror = 0.5
[materials.glass]
ior = 1.5
ior_outside = 1.25

[[plane]]
point = [0.0, -1.0, 0.0]
normal = [0.0, 3.0, 0.0]
material = "plastic"
checker = { color = [0.1, 0.2, 0.3], size = 2.0 }

[[triangle]]
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
material = "half"

[[light]]
position = [4.0, 6.0, 3.0]
color = [60.0, 50.0, 40.0]
)";

/// The message of the error that the text gives, or "no error".
std::string errorOf(const std::string& text)
{
    try
    {
        parseScene(text, "scene.toml");
        return "no error";
    }
    catch (const SceneError& error)
    {
        return error.what();
    }
}

std::string loadErrorOf(const std::string& path)
{
    try
    {
        loadScene(path);
        return "no error";
    }
    catch (const SceneError& error)
    {
        return error.what();
    }
}

/// A folder that is gone after the test.
struct TemporaryFolder
{
    TemporaryFolder() { fs::create_directories(path); }
    ~TemporaryFolder() { fs::remove_all(path); }

    std::string file(const std::string& name, const std::string& text) const
    {
        std::ofstream(path / name, std::ios::binary) << text;
        return (path / name).string();
    }

    fs::path path = fs::path(testing::TempDir()) / fmt::format("raytree_scene_file_{}", getpid());
};

// ---- good scenes ---------------------------------------------------------------------------------------------------

TEST(SceneFile, ReadsEveryKey)
{
    const auto scene = parseScene(everything, "folder/scene.toml");

    EXPECT_EQ(scene.file, "folder/scene.toml");
    EXPECT_EQ(scene.title, "One 50% specular, one glass sphere");
    EXPECT_TRUE(scene.warnings.empty());

    EXPECT_EQ(scene.camera.eye, Vec3<double>(0, 1.5, 6));
    EXPECT_EQ(scene.camera.target, Vec3<double>(0, 1, 0));
    EXPECT_EQ(scene.camera.up, Vec3<double>(0, 2, 0));
    EXPECT_EQ(scene.camera.verticalFov, 40);
    EXPECT_EQ(scene.camera.width, 320);
    EXPECT_EQ(scene.camera.height, 240);
    EXPECT_EQ(scene.pixel(), (std::array<int, 2>{212, 115}));

    EXPECT_EQ(scene.trace.maxDepth, 5);
    EXPECT_EQ(scene.trace.cutoff, 0.001);
    EXPECT_EQ(scene.trace.atCap, AtCap::direct);
    EXPECT_EQ(scene.trace.fresnel, FresnelModel::schlick);
    EXPECT_EQ(scene.trace.shadowThroughGlass, ShadowThroughGlass::tint);

    EXPECT_TRUE(scene.sky.present);
    EXPECT_EQ(scene.sky.color, Vec3<double>(0.2, 0.3, 5));
    EXPECT_FALSE(scene.sky.zenith || scene.sky.image);
    ASSERT_TRUE(scene.sky.sun);
    EXPECT_EQ(scene.sky.sun->direction, Vec3<double>(3, 4, 0));
    EXPECT_EQ(scene.sky.sun->color, Vec3<double>(100, 90.5, 80));
    EXPECT_EQ(scene.sky.sun->size, 0.53);

    ASSERT_EQ(scene.spheres.size(), 2u);
    EXPECT_EQ(scene.spheres[0].center, Vec3<double>(0, 1, 0));
    EXPECT_EQ(scene.spheres[0].radius, 1);
    EXPECT_EQ(scene.spheres[0].material, 2);
    EXPECT_EQ(scene.spheres[1].center, Vec3<double>(3, 1, 0));
    EXPECT_EQ(scene.spheres[1].radius, 0.5);
    EXPECT_EQ(scene.spheres[1].material, 1);

    ASSERT_EQ(scene.planes.size(), 1u);
    EXPECT_EQ(scene.planes[0].point, Vec3<double>(0, -1, 0));
    EXPECT_EQ(scene.planes[0].normal, Vec3<double>(0, 3, 0));
    EXPECT_EQ(scene.planes[0].material, 0);
    EXPECT_TRUE(scene.planes[0].hasChecker);
    EXPECT_EQ(scene.planes[0].checkerColor, Vec3<double>(0.1, 0.2, 0.3));
    EXPECT_EQ(scene.planes[0].checkerSize, 2);

    ASSERT_EQ(scene.triangles.size(), 1u);
    EXPECT_EQ(scene.triangles[0].vertices[1], Vec3<double>(1, 0, 0));
    EXPECT_EQ(scene.triangles[0].vertices[2], Vec3<double>(0, 1, 0));
    EXPECT_EQ(scene.triangles[0].material, 1);

    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].position, Vec3<double>(4, 6, 3));
    EXPECT_EQ(scene.lights[0].color, Vec3<double>(60, 50, 40));
}

TEST(SceneFile, NumbersMaterialsInTheOrderOfTheFile)
{
    const auto scene = parseScene(everything, "scene.toml");
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_EQ(scene.materials[0].name, "plastic");
    EXPECT_EQ(scene.materials[0].color, Vec3<double>(0.7, 0.1, 0.1));
    EXPECT_EQ(scene.materials[0].glossy, 0.3);
    EXPECT_EQ(scene.materials[0].exponent, 50);
    EXPECT_EQ(scene.materials[1].name, "half");
    EXPECT_EQ(scene.materials[1].mirror, 0.5);
    EXPECT_EQ(scene.materials[2].name, "glass");
    EXPECT_EQ(scene.materials[2].color, Vec3<double>(1, 1, 1));
    EXPECT_EQ(scene.materials[2].ior, 1.5);
    EXPECT_EQ(scene.materials[2].iorOutside, 1.25);
}

TEST(SceneFile, AnEmptyFileIsAnEmptySceneWithTheDefaults)
{
    const auto scene = parseScene("", "scene.toml");
    const SceneDescription plain;
    EXPECT_TRUE(scene.spheres.empty() && scene.planes.empty() && scene.triangles.empty());
    EXPECT_TRUE(scene.lights.empty() && scene.materials.empty() && scene.warnings.empty());
    EXPECT_FALSE(scene.sky.present);
    EXPECT_EQ(scene.camera.eye, plain.camera.eye);
    EXPECT_EQ(scene.camera.width, plain.camera.width);
    EXPECT_EQ(scene.trace.maxDepth, plain.trace.maxDepth);
    EXPECT_EQ(scene.pixel(), (std::array<int, 2>{320, 240}));
}

TEST(SceneFile, AnEmptySkyIsBlackButPresent)
{
    const auto scene = parseScene("[sky]", "scene.toml");
    EXPECT_TRUE(scene.sky.present);
    EXPECT_EQ(scene.sky.color, Vec3<double>(0));
    EXPECT_FALSE(scene.sky.zenith || scene.sky.sun || scene.sky.image);
}

TEST(SceneFile, ReadsAGradient)
{
    const auto sky = parseScene("[sky]\nhorizon = [0.5, 0.25, 2]\nzenith = [0, 1, 3]", "scene.toml").sky;
    EXPECT_EQ(sky.color, Vec3<double>(0.5, 0.25, 2));
    ASSERT_TRUE(sky.zenith);
    EXPECT_EQ(*sky.zenith, Vec3<double>(0, 1, 3));
    EXPECT_FALSE(sky.sun || sky.image);
}

TEST(SceneFile, ReadsASunBesideAGradientOrAlone)
{
    const std::string sun = "sun = { direction = [0, 0, -2], color = [9, 8, 7] }";
    for (const std::string beside : {"", "color = [1, 1, 1]\n", "horizon = [0, 0, 0]\nzenith = [0, 0, 0]\n"})
    {
        const auto sky = parseScene("[sky]\n" + beside + sun, "scene.toml").sky;
        ASSERT_TRUE(sky.sun) << beside;
        EXPECT_EQ(sky.sun->color, Vec3<double>(9, 8, 7));
        EXPECT_EQ(sky.sun->size, 5) << "the default";
    }
    EXPECT_TRUE(parseScene("[sky.sun]\ndirection = [0, 1, 0]\ncolor = [1, 1, 1]", "scene.toml").sky.sun);
}

TEST(SceneFile, ACheckerIsOneUnitWideUnlessItSaysOtherwise)
{
    const auto scene =
        parseScene("materials.m = {}\nplane = [{ point = [0, 0, 0], normal = [0, 1, 0], material = \"m\", "
                   "checker = { color = [0, 0, 0] } }]",
                   "scene.toml");
    ASSERT_EQ(scene.planes.size(), 1u);
    EXPECT_TRUE(scene.planes[0].hasChecker);
    EXPECT_EQ(scene.planes[0].checkerSize, 1);
}

TEST(SceneFile, TakesEveryWordOfEveryChoice)
{
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto text = fmt::format("[trace]\nat_cap = '{}'\nfresnel = '{}'\nshadow_through_glass = '{}'",
                                      atCapWords[i], fresnelWords[i], shadowThroughGlassWords[i % 2]);
        const auto trace = parseScene(text, "scene.toml").trace;
        EXPECT_EQ(std::size_t(trace.atCap), i);
        EXPECT_EQ(std::size_t(trace.fresnel), i);
        EXPECT_EQ(std::size_t(trace.shadowThroughGlass), i % 2);
    }
    EXPECT_EQ(skyMappingWords[std::size_t(SkyMapping::latlong)], "latlong");
    EXPECT_EQ(skyMappingWords[std::size_t(SkyMapping::angular)], "angular");
    EXPECT_EQ(parseScene("trace.at_cap = 'sky'", "scene.toml").trace.atCap, AtCap::sky);
    EXPECT_EQ(parseScene("trace.fresnel = 'none'", "scene.toml").trace.fresnel, FresnelModel::none);
}

TEST(SceneFile, AcceptsTheEndsOfEveryRange)
{
    EXPECT_EQ(errorOf("[camera]\nsize = [65536, 4096]\npixel = [65535, 4095]"), "no error");
    EXPECT_EQ(errorOf("[camera]\nsize = [1, 1]\npixel = [0, 0]\nvertical_fov = 179.999"), "no error");
    EXPECT_EQ(errorOf("[trace]\nmax_depth = 0\ncutoff = 0"), "no error");
    EXPECT_EQ(errorOf("[trace]\nmax_depth = 1024\ncutoff = 1e300"), "no error");
    EXPECT_EQ(errorOf("[materials.m]\ncolor = [0, 1, 0]\nmirror = 1\nglossy = 1\nexponent = 0"), "no error");
    EXPECT_EQ(errorOf("[[light]]\nposition = [0, 0, 0]\ncolor = [0, 0, 1e300]"), "no error");
    EXPECT_EQ(errorOf("[sky]\nhorizon = [0, 0, 0]\nzenith = [0, 0, 1e300]\n"
                      "sun = { direction = [0, 0, 1e-300], color = [0, 0, 1e300], size = 180 }"),
              "no error");
    EXPECT_EQ(errorOf("sky.sun = { direction = [1, 0, 0], color = [0, 0, 0], size = 5e-324 }"), "no error");
}

TEST(SceneFile, WindowsLineEndsAndAByteOrderMarkChangeNothing)
{
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : everything) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(sceneToToml(parseScene(windows, "scene.toml")), sceneToToml(parseScene(everything, "scene.toml")));
}

TEST(SceneFile, TakesLettersOfEveryLength)
{
    const std::string letters = "a\xC2\x80\xDF\xBF\xE0\xA0\x80\xED\x9F\xBF\xEF\xBF\xBD\xF0\x90\x80\x80\xF4\x8F\xBF\xBF";
    EXPECT_EQ(parseScene("title = '" + letters + "'", "scene.toml").title, letters);
}

TEST(SceneFile, LeavesOutATriangleWithoutAreaAndSaysSo)
{
    const std::string head = "materials.m = {}\n";
    const auto triangle = [](const char* vertices) {
        return fmt::format("[[triangle]]\nvertices = {}\nmaterial = 'm'\n", vertices);
    };

    const auto line = parseScene(head + triangle("[[0, 0, 0], [0.1, 0.1, 0.1], [0.3, 0.3, 0.3]]"), "scene.toml");
    EXPECT_TRUE(line.triangles.empty());
    ASSERT_EQ(line.warnings.size(), 1u);
    EXPECT_EQ(line.warnings[0], "scene.toml:3:12: this [[triangle]] has no area and is left out");

    const auto rounded = parseScene(head + triangle("[[0, 0, 0], [0.1, 0.2, 0.3], [0.7, 1.4, 2.1]]"), "scene.toml");
    EXPECT_TRUE(rounded.triangles.empty());

    const auto point = parseScene(head + triangle("[[1, 2, 3], [1, 2, 3], [1, 2, 4]]"), "scene.toml");
    EXPECT_TRUE(point.triangles.empty());
    EXPECT_EQ(point.warnings.size(), 1u);

    const auto tiny = parseScene(head + triangle("[[0, 0, 0], [1e-300, 0, 0], [0, 1e-300, 0]]") +
                                     triangle("[[0, 0, 0], [1e150, 1e140, 0], [1e150, 0, 0]]"),
                                 "scene.toml");
    EXPECT_EQ(tiny.triangles.size(), 2u);
    EXPECT_TRUE(tiny.warnings.empty());
}

TEST(SceneFile, ReadsManySpheresInLinearTime)
{
    const auto read = [](int spheres) {
        std::string text = "materials.m = {}\n";
        for (int i = 0; i < spheres; ++i)
            text += fmt::format("[[sphere]]\ncenter = [{}.25, 0.123456789, -3.0]\nradius = 0.5\nmaterial = 'm'\n", i);
        EXPECT_EQ(parseScene(text, "scene.toml").spheres.size(), unsigned(spheres));
    };
    EXPECT_LT(growthByEight(1250, read), aboutLinear);
}

// ---- bad scenes ----------------------------------------------------------------------------------------------------

struct BadScene
{
    const char* name;
    std::string text;
    int line, column;
    std::vector<std::string> words; ///< all stand in the message
};

BadScene bad(const char* name, const std::string& text, int line, int column, std::vector<std::string> words)
{
    return {name, text, line, column, std::move(words)};
}

void PrintTo(const BadScene& scene, std::ostream* out)
{
    *out << scene.name;
}

class BadSceneFile : public testing::TestWithParam<BadScene>
{
};

TEST_P(BadSceneFile, IsRefusedInOneSentenceWithItsPlace)
{
    const auto& [name, text, line, column, allWords] = GetParam();
    const auto message = errorOf(text);
    const auto place = fmt::format("scene.toml:{}:{}: ", line, column);
    EXPECT_EQ(message.substr(0, place.size()), place) << message;
    for (const auto& words : allWords) EXPECT_NE(message.find(words), message.npos) << message << "\nlacks: " << words;
    EXPECT_EQ(message.find('\n'), message.npos) << message;
    EXPECT_LT(message.size(), 600u);
}

std::string nameOf(const testing::TestParamInfo<BadScene>& info)
{
    return info.param.name;
}

const std::string bareSphere = "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n";
const std::string plainPlane = "materials.m = {}\n[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = 'm'\n";

INSTANTIATE_TEST_SUITE_P(
    Toml, BadSceneFile,
    testing::Values(
        bad("AnUnknownCharacter", "title = 'x'\n= 3", 2, 1, {"not valid TOML", "expected keys", "saw '='"}),
        bad("AnUnclosedArray", "[camera]\neye = [1, 2", 2, 12, {"not valid TOML", "while parsing array"}),
        bad("AnUnquotedWord", "[[sphere]]\nmaterial = glass", 2, 12, {"not valid TOML", "value"}),
        bad("AKeyTwice", "[sky]\ncolor = [0, 0, 0]\ncolor = [1, 1, 1]", 3, 9, {"cannot redefine", "'color'"}),
        bad("ATableTwice", "[sky]\n[camera]\n[sky]", 3, 1, {"cannot redefine existing table 'sky'"}),
        bad("TextThatIsNotUtf8", "title = 'x'\n\xFF = 1", 2, 1, {"byte 0xff is not UTF-8", "expected"}),
        bad("HalfALetter", "# \xC3\xA4\n# \xC3\xA4\xC3", 2, 4, {"byte 0xc3 is not UTF-8"}),
        bad("AByteAfterAByteOrderMark", "\xEF\xBB\xBF# \xFF", 1, 3, {"byte 0xff is not UTF-8"}),
        bad("AnOverlongLetter", "# \xC0\xAF", 1, 3, {"byte 0xc0 is not UTF-8"}),
        bad("AnOverlongLetterOfThreeBytes", "# \xE0\x80\xAF", 1, 3, {"byte 0xe0 is not UTF-8"}),
        bad("ASurrogate", "# \xED\xA0\x80", 1, 3, {"byte 0xed is not UTF-8"}),
        bad("ALetterBeyondUnicode", "# \xF4\x90\x80\x80", 1, 3, {"byte 0xf4 is not UTF-8"}),
        bad("Utf16", std::string("\xFF\xFE[\0s\0", 6), 1, 1, {"byte 0xff is not UTF-8"}),
        bad("AZeroByte", std::string("[sky]\n\0", 7), 2, 1, {"not valid TOML", "u0000"}),
        bad("ANumberTooLargeForADouble", "[trace]\ncutoff = 1e999", 2, 15, {"not valid TOML", "1e999"}),
        bad("AWholeNumberTooLargeForTheParser", "[trace]\ncutoff = 99999999999999999999", 2, 30, {"64 bits"}),
        bad("DeeplyNestedArrays", "title = " + std::string(100000, '['), 1, 265, {"nested", "256"}),
        bad("OpenBracketsOnly", std::string(100000, '['), 1, 3, {"not valid TOML"}),
        bad("CarriageReturnsAlone", "[sky]\rcolor = [0, 0, 0]", 1, 7, {"expected '\\n'"})),
    nameOf);

/// "a.a.a" and so on, with `count` names.
std::string chain(const std::string& segment, int count)
{
    std::string key = segment;
    for (int i = 1; i < count; ++i) key += "." + segment;
    return key;
}

INSTANTIATE_TEST_SUITE_P(
    LongKey, BadSceneFile,
    testing::Values(bad("OfBareNames", chain("a", 100000) + " = 1", 1, 2, {"more than 16 names", "at most 3"}),
                    bad("InAHeader", "[sky]\n[" + chain("a", 100000) + "]", 2, 3, {"more than 16 names"}),
                    bad("InAnArrayHeader", "[[" + chain("a", 100000) + "]]", 1, 4, {"more than 16 names"}),
                    bad("InAnInlineTable", "a = { " + chain("a", 100000) + " = 1 }", 1, 8, {"more than 16 names"}),
                    bad("OfQuotedNames", chain("\",=\\\".\"", 100000) + " = 1", 1, 8, {"more than 16 names"}),
                    bad("OfLiteralNames", chain("',.'", 100000) + " = 1", 1, 5, {"more than 16 names"}),
                    bad("WithBlanks", chain(" a\t", 100000) + " = 1", 1, 4, {"more than 16 names"}),
                    bad("OfSeventeenNames", chain("a", 17) + " = 1", 1, 2, {"more than 16 names"}),
                    bad("OfSixteenNames", chain("a", 16) + " = 1", 1, 1, {"unknown table 'a'"})),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    UnknownKey, BadSceneFile,
    testing::Values(
        bad("Misspelled", "[materials.floor]\n  colour = [1, 1, 1]", 2, 3,
            {"unknown key 'colour' in [materials.floor], did you mean 'color'?"}),
        bad("Shortened", "[camera]\nfov = 40", 2, 1, {"unknown key 'fov' in [camera]", "did you mean 'vertical_fov'?"}),
        bad("InCapitals", "[camera]\nEYE = [1, 1, 1]", 2, 1, {"did you mean 'eye'?"}),
        bad("Foreign", "[camera]\nzzzzz = 1", 2, 1,
            {"unknown key 'zzzzz' in [camera], expected 'eye', 'target', 'up', 'vertical_fov', 'size' or 'pixel'"}),
        bad("InTrace", "[trace]\nmaxdepth = 1", 2, 1, {"did you mean 'max_depth'?"}),
        bad("InSky", "[sky]\ngradient = 1", 2, 1,
            {"unknown key 'gradient' in [sky], expected 'color', 'horizon', 'zenith', 'image', 'mapping' or 'sun'"}),
        bad("InTheSun", "[sky]\nsun = { sizes = 1 }", 2, 9, {"'sizes' in the sun of [sky], did you mean 'size'?"}),
        bad("InMesh", "[[mesh]]\nfiles = 1", 2, 1, {"unknown key 'files' in [[mesh]], did you mean 'file'?"}),
        bad("InSphere", "[[sphere]]\nradus = 1", 2, 1, {"unknown key 'radus' in [[sphere]], did you mean 'radius'?"}),
        bad("InPlane", "[[plane]]\ncheckers = 1", 2, 1, {"did you mean 'checker'?"}),
        bad("InChecker", plainPlane + "checker = { colr = 1 }", 6, 13, {"in the checker of a [[plane]]", "'color'"}),
        bad("InTriangle", "[[triangle]]\nvertexes = 1", 2, 1, {"did you mean 'vertices'?"}),
        bad("InLight", "[[light]]\nradius = 1", 2, 1, {"unknown key 'radius' in [[light]], expected 'position' or"}),
        bad("AtTheTop", "titel = 'x'", 1, 1, {"unknown key 'titel' in the scene, did you mean 'title'?"}),
        bad("ATable", "[material.floor]", 1, 2, {"unknown table 'material'", "did you mean 'materials'?"}),
        bad("AnArrayOfTables", "[[spheres]]", 1, 3, {"unknown table 'spheres'", "did you mean 'sphere'?"}),
        bad("ATableInATable", "[camera.lens]", 1, 9, {"unknown table 'lens' in [camera]"}),
        bad("TheFirstOfTwo", "[sky]\nzoo = 1\nabc = 1", 2, 1, {"unknown key 'zoo'"}),
        bad("WithALineBreak", "\"a\\nb\" = 1", 1, 1, {"unknown key 'a\\x0ab'"}),
        bad("VeryLong", std::string(100000, 'x') + " = 1", 1, 1, {"unknown key 'xxx", "xxx...' in the scene"})),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    WrongType, BadSceneFile,
    testing::Values(
        bad("AStringForNumbers", "[camera]\neye = 'here'", 2, 7,
            {"'eye' in [camera]: expected an array of 3 numbers, got a string"}),
        bad("ANumberForNumbers", "[camera]\nup = 1", 2, 6, {"expected an array of 3 numbers, got 1"}),
        bad("TooFewNumbers", "[camera]\neye = [1, 2]", 2, 7, {"an array of 3 numbers, got an array of 2"}),
        bad("TooManyNumbers", "[camera]\neye = [1, 2, 3, 4]", 2, 7, {"an array of 3 numbers, got an array of 4"}),
        bad("NoNumbers", "[camera]\neye = []", 2, 7, {"an array of 3 numbers, got an empty array"}),
        bad("AStringAmongNumbers", "[camera]\neye = [1, '2', 3]", 2, 11,
            {"expected an array of 3 numbers, got a string as the second"}),
        bad("ABooleanForANumber", "[camera]\nvertical_fov = true", 2, 16, {"expected a number between", "got true"}),
        bad("ADateForANumber", "[camera]\nvertical_fov = 2001-01-01", 2, 16, {"got a date or time"}),
        bad("ANumberForAString", "title = 3.0", 1, 9, {"'title' in the scene: expected a string, got 3.0"}),
        bad("ATableForAString", "[title]", 1, 1, {"expected a string, got a table"}),
        bad("AFloatForASize", "[camera]\nsize = [640, 480.0]", 2, 14,
            {"'size' in [camera]: expected a whole number from 1 to 65536 as the second of 2, got 480.0"}),
        bad("ANumberForASize", "[camera]\nsize = 640", 2, 8, {"expected an array of 2 whole numbers, got 640"}),
        bad("AFloatForAPixel", "[camera]\npixel = [1.5, 2]", 2, 10, {"whole number from 0 to 639", "first", "1.5"}),
        bad("AFloatForADepth", "[trace]\nmax_depth = 8.0", 2, 13, {"a whole number from 0 to 1024, got 8.0"}),
        bad("ANumberForATable", "camera = 3", 1, 10, {"'camera' in the scene: expected a table, [camera], got 3"}),
        bad("TablesForATable", "[[camera]]", 1, 1, {"a table, [camera], got an array of tables"}),
        bad("ATableForTables", "[sphere]", 1, 1, {"expected tables, each headed [[sphere]], got a table"}),
        bad("NumbersForTables", "light = [3]", 1, 10, {"expected tables, each headed [[light]], got 3"}),
        bad("ANumberForAMaterial", "[materials]\nfloor = 3", 2, 9, {"'floor' in [materials]", "[materials.floor]"}),
        bad("TablesForMaterials", "[[materials]]", 1, 1, {"[materials.NAME]", "got an array of tables"}),
        bad("ANumberForAMaterialsName", bareSphere + "material = 3", 4, 12,
            {"'material' in [[sphere]]: expected a string"}),
        bad("ANumberForAChecker", plainPlane + "checker = 1", 6, 11, {"'checker' in [[plane]]: expected a table"}),
        bad("AStringForAZenith", "[sky]\nzenith = 'blue'", 2, 10,
            {"expected an array of 3 numbers, each of", "a string"}),
        bad("ANumberForAPicture", "[sky]\nimage = 1", 2, 9, {"'image' in [sky]: expected a string, got 1"}),
        bad("ANumberForAMapping", "[sky]\nmapping = 1", 2, 11, {"'mapping' in [sky]: expected a string, got 1"}),
        bad("AColorForASun", "[sky]\nsun = [1, 1, 1]", 2, 7,
            {"'sun' in [sky]: expected a table, { direction = [x, y, z], color = [r, g, b], size = 5.0 }, got an "
             "array"}),
        bad("AStringForASunsSize", "sky.sun = { size = '1' }", 1, 20, {"at most 180, got a string"}),
        bad("ANumberForAMeshFile", "[[mesh]]\nfile = 1", 2, 8, {"'file' in [[mesh]]: expected a string, got 1"}),
        bad("ATableForMeshes", "[mesh]", 1, 1, {"expected tables, each headed [[mesh]], got a table"}),
        bad("TwoVertices", "[[triangle]]\nvertices = [[0, 0, 0], [0, 0, 1]]", 2, 12,
            {"expected an array of 3 points, each an array of 3 numbers, got an array of 2"}),
        bad("AFlatVertex", "[[triangle]]\nvertices = [[0, 0, 0], [0, 1], [0, 0, 1]]", 2, 24,
            {"'vertices' in [[triangle]]: expected an array of 3 numbers, got an array of 2"})),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    OutOfRange, BadSceneFile,
    testing::Values(
        bad("AZeroRadius", "[[sphere]]\nradius = 0", 2, 10,
            {"'radius' in [[sphere]]: expected a number greater than 0, got 0"}),
        bad("ANegativeRadius", "[[sphere]]\nradius = -1.5", 2, 10, {"greater than 0, got -1.5"}),
        bad("AZeroIor", "[materials.m]\nior = 0.0", 2, 7, {"'ior' in [materials.m]", "greater than 0, got 0.0"}),
        bad("AZeroIorOutside", "[materials.m]\nior_outside = 0", 2, 15, {"greater than 0"}),
        bad("AZeroFieldOfView", "[camera]\nvertical_fov = 0", 2, 16,
            {"expected a number between 0 and 180, neither included, got 0"}),
        bad("AFieldOfViewOf180Degrees", "[camera]\nvertical_fov = 180", 2, 16, {"between 0 and 180", "got 180"}),
        bad("AZeroSize", "[camera]\nsize = [0, 480]", 2, 9, {"from 1 to 65536", "got 0"}),
        bad("AHugeSize", "[camera]\nsize = [640, 65537]", 2, 14, {"from 1 to 65536", "got 65537"}),
        bad("TooManyPixels", "[camera]\nsize = [65536, 4097]", 2, 8, {"at most 268435456 pixels", "65536 x 4097"}),
        bad("APixelRightOfThePicture", "[camera]\npixel = [640, 0]", 2, 10, {"0 to 639", "first of 2, got 640"}),
        bad("APixelBelowThePicture", "[camera]\npixel = [0, 2]\nsize = [2, 2]", 2, 13, {"0 to 1", "second"}),
        bad("ANegativePixel", "[camera]\npixel = [0, -1]", 2, 13, {"0 to 479", "got -1"}),
        bad("ANegativeDepth", "[trace]\nmax_depth = -1", 2, 13, {"from 0 to 1024, got -1"}),
        bad("ADeepDepth", "[trace]\nmax_depth = 1025", 2, 13, {"from 0 to 1024, got 1025"}),
        bad("AnOverflowingDepth", "[trace]\nmax_depth = 4294967297", 2, 13, {"got 4294967297"}),
        bad("ANegativeCutoff", "[trace]\ncutoff = -0.1", 2, 10, {"a number of at least 0, got -0.1"}),
        bad("AMaterialBrighterThanItsLight", "[materials.m]\ncolor = [0, 0, 1.5]", 2, 16,
            {"expected an array of 3 numbers, each from 0 to 1, got 1.5 as the third"}),
        bad("ANegativeMaterialColor", "[materials.m]\ncolor = [-0.5, 0, 1]", 2, 10, {"got -0.5 as the first"}),
        bad("ANegativeLight", "[[light]]\ncolor = [-1, 0, 0]", 2, 10, {"each of at least 0, got -1 as the first"}),
        bad("ANegativeSky", "[sky]\ncolor = [0, -1, 0]", 2, 13, {"each of at least 0, got -1 as the second"}),
        bad("ANegativeHorizon", "[sky]\nhorizon = [0, 0, -2]", 2, 18, {"each of at least 0, got -2 as the third"}),
        bad("ANegativeZenith", "[sky]\nzenith = [-0.5, 0, 0]", 2, 11, {"each of at least 0, got -0.5 as the first"}),
        bad("AnInfiniteZenith", "[sky]\nzenith = [inf, 0, 0]", 2, 11, {"each of at least 0, got inf as the first"}),
        bad("ANegativeSun", "sky.sun = { color = [0, 0, -1] }", 1, 28,
            {"'color' in the sun of [sky]: expected an array of 3 numbers, each of at least 0, got -1 as the third"}),
        bad("AnInfiniteSunDirection", "sky.sun = { direction = [0, inf, 0] }", 1, 29, {"got inf as the second"}),
        bad("ASunWithoutSize", "sky.sun = { size = 0 }", 1, 20,
            {"'size' in the sun of [sky]: expected a number greater than 0 and at most 180, got 0"}),
        bad("ASunOfNegativeSize", "sky.sun = { size = -5.0 }", 1, 20, {"at most 180, got -5.0"}),
        bad("ASunBeyondHalfTheSky", "sky.sun = { size = 180.001 }", 1, 20, {"at most 180, got 180.001"}),
        bad("ASunWhoseSizeIsNotANumber", "sky.sun = { size = nan }", 1, 20, {"at most 180, got nan"}),
        bad("AnUnknownMapping", "[sky]\nmapping = 'anguler'", 2, 11,
            {"'mapping' in [sky]: expected 'latlong' or 'angular', got 'anguler', did you mean 'angular'?"}),
        bad("AMirrorAboveOne", "[materials.m]\nmirror = 1.1", 2, 10, {"from 0 to 1, got 1.1"}),
        bad("AMirrorBelowZero", "[materials.m]\nmirror = -0.1", 2, 10, {"from 0 to 1, got -0.1"}),
        bad("AGlossyAboveOne", "[materials.m]\nglossy = 2", 2, 10, {"from 0 to 1, got 2"}),
        bad("ANegativeExponent", "[materials.m]\nexponent = -1", 2, 12, {"at least 0, got -1"}),
        bad("AZeroCheckerSize", plainPlane + "checker = { color = [0, 0, 0], size = 0 }", 6, 39, {"greater than 0"}),
        bad("ABrightChecker", plainPlane + "checker = { color = [0, 0, 2] }", 6, 28, {"each from 0 to 1, got 2"}),
        bad("ANumberThatIsNotOne", "[camera]\neye = [0, nan, 0]", 2, 11, {"3 numbers, got nan as the second"}),
        bad("InfinityInAPoint", "[[light]]\nposition = [0, 0, -inf]", 2, 19, {"got -inf as the third"}),
        bad("InfinityAsARadius", "[[sphere]]\nradius = inf", 2, 10, {"greater than 0, got inf"}),
        bad("InfinityInAVertex", "[[triangle]]\nvertices = [[0, 0, 0], [inf, 0, 0], [0, 1, 0]]", 2, 25, {"got inf"}),
        bad("AnUnknownWord", "[trace]\nat_cap = 'blak'", 2, 10,
            {"'at_cap' in [trace]: expected 'black', 'sky' or 'direct', got 'blak', did you mean 'black'?"}),
        bad("AnUnknownFresnel", "[trace]\nfresnel = 'on'", 2, 11, {"expected 'exact', 'schlick' or 'none', got 'on'"}),
        bad("AnUnknownShadow", "[trace]\nshadow_through_glass = ''", 2, 24, {"expected 'block' or 'tint', got ''"})),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    MissingKey, BadSceneFile,
    testing::Values(
        bad("CenterOfASphere", "\n[[sphere]]\nradius = 1\nmaterial = 'm'", 2, 1,
            {"missing key 'center' in [[sphere]], expected 'center', 'radius' and 'material'"}),
        bad("RadiusOfASphere", "[[sphere]]\ncenter = [0, 0, 0]\nmaterial = 'm'", 1, 1, {"missing key 'radius'"}),
        bad("MaterialOfASphere", "\n\n  " + bareSphere, 3, 3, {"missing key 'material' in [[sphere]]"}),
        bad("PointOfAPlane", "[[plane]]\nnormal = [0, 1, 0]\nmaterial = 'm'", 1, 1, {"missing key 'point'"}),
        bad("NormalOfAPlane", "[[plane]]\npoint = [0, 1, 0]\nmaterial = 'm'", 1, 1, {"missing key 'normal'"}),
        bad("MaterialOfAPlane", "[[plane]]\npoint = [0, 1, 0]\nnormal = [0, 1, 0]", 1, 1, {"missing key 'material'"}),
        bad("ColorOfAChecker", plainPlane + "checker = { size = 2 }", 6, 11, {"missing key 'color' in the checker"}),
        bad("VerticesOfATriangle", "[[triangle]]\nmaterial = 'm'", 1, 1, {"missing key 'vertices'"}),
        bad("MaterialOfATriangle", "[[triangle]]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]", 1, 1,
            {"missing key 'material' in [[triangle]], expected 'vertices' and 'material'"}),
        bad("FileOfAMesh", "[[mesh]]\nmaterial = 'm'", 1, 1, {"missing key 'file' in [[mesh]], expected 'file' and"}),
        bad("MaterialOfAMesh", "[[mesh]]\nfile = 'm.obj'", 1, 1, {"missing key 'material' in [[mesh]]"}),
        bad("DirectionOfASun", "[sky]\nsun = { color = [1, 1, 1] }", 2, 7,
            {"missing key 'direction' in the sun of [sky], expected 'direction' and 'color'"}),
        bad("ColorOfASun", "[sky]\nsun = { direction = [1, 1, 1] }", 2, 7, {"missing key 'color' in the sun of"}),
        bad("PositionOfALight", "[[light]]\ncolor = [0, 0, 0]", 1, 1, {"missing key 'position' in [[light]]"}),
        bad("ColorOfALight", "[[light]]\nposition = [0, 0, 0]", 1, 1, {"missing key 'color' in [[light]]"}),
        bad("OfTheSecondOfTwo", "materials.m = {}\n" + bareSphere + "material = 'm'\n[[sphere]]", 6, 1,
            {"missing key"})),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Nonsense, BadSceneFile,
    testing::Values(
        bad("AnUndefinedMaterial", "[materials.floor]\n" + bareSphere + "material = 'flor'", 5, 12,
            {"material 'flor' is not defined, did you mean 'floor'?"}),
        bad("AForeignMaterial", "[materials.b]\n[materials.a]\n" + bareSphere + "material = 'xyz'", 6, 12,
            {"material 'xyz' is not defined, expected 'b' or 'a'"}),
        bad("NoMaterialAtAll", bareSphere + "material = 'glass'", 4, 12,
            {"not defined, expected a table [materials.NAME]"}),
        bad("AZeroNormal", "[materials.m]\n[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 0, -0.0]\nmaterial = 'm'", 4, 10,
            {"'normal' in [[plane]]: expected a direction, got the zero vector"}),
        bad("AnEyeAtItsTarget", "[camera]\ntarget = [1, 2, 3]\neye = [1, 2, 3]", 2, 10, {"the same point"}),
        bad("AnEyeAtTheDefaultTarget", "[camera]\neye = [0, 0, -1]", 2, 7, {"the same point"}),
        bad("AZeroUp", "[camera]\nup = [0, 0, 0]", 2, 6, {"'up' in [camera]", "got the zero vector"}),
        bad("AnUpAlongTheView", "[camera]\neye = [1, 1, 1]\ntarget = [0, 0, 0]\nup = [-2, -2, -2]", 4, 6,
            {"'up' in [camera]", "not parallel to the view", "[-2.0, -2.0, -2.0]"}),
        bad("AViewAlongTheDefaultUp", "[camera]\neye = [0, 5, 0]\ntarget = [0, 0, 0]", 3, 10, {"[0.0, 1.0, 0.0]"}),
        bad("AnEndlessView", "[camera]\neye = [-1e308, 0, 0]\ntarget = [1e308, 0, 0]", 3, 10, {"too far apart"}),
        bad("AMirrorOfGlass", "[materials.m]\nior = 1.5\nmirror = 0.5", 3, 1,
            {"'mirror' in [materials.m] beside 'ior'", "a dielectric's reflected share follows from Fresnel"}),
        bad("GlossyGlass", "[materials.m]\nglossy = 0.5\nior = 1.5", 2, 1, {"'glossy' in [materials.m] beside 'ior'"}),
        bad("AnOutsideWithoutAnInside", "[materials.m]\nior_outside = 1.5", 2, 1,
            {"'ior_outside' in [materials.m] without 'ior'"}),
        bad("AMeshWithoutItsFile", "materials.m = {}\n[[mesh]]\nfile = 'no such folder/bunny.obj'\nmaterial = 'm'", 3,
            8, {"no such folder/bunny.obj: no such file"}),
        bad("AMeshWithoutAName", "materials.m = {}\n[[mesh]]\nfile = ''\nmaterial = 'm'", 3, 8,
            {"'file' in [[mesh]]: expected the name of a file, got ''"}),
        bad("AMeshOfAnUndefinedMaterial", "[[mesh]]\nfile = 'bunny.obj'\nmaterial = 'm'", 3, 12,
            {"material 'm' is not defined"})),
    nameOf);

const std::string white = " = [1, 1, 1]\n", sunny = "sun = { direction = [1, 0, 0], color = [1, 1, 1] }\n";
const std::string oneOfThree = "expected either 'color', or 'horizon' and 'zenith', or 'image'";

INSTANTIATE_TEST_SUITE_P(
    SkyOfTwoKinds, BadSceneFile,
    testing::Values(bad("AHorizonAfterAColor", "[sky]\ncolor" + white + "horizon" + white, 3, 1,
                        {"'horizon' in [sky] beside 'color', " + oneOfThree}),
                    bad("AColorAfterAHorizon", "[sky]\nhorizon" + white + "color" + white, 3, 1,
                        {"'color' in [sky] beside 'horizon', " + oneOfThree}),
                    bad("AZenithAfterAColor", "[sky]\ncolor" + white + "zenith" + white, 3, 1,
                        {"'zenith' in [sky] beside 'color', "}),
                    bad("AColorAfterAGradient", "[sky]\nhorizon" + white + "zenith" + white + "color" + white, 4, 1,
                        {"'color' in [sky] beside 'horizon', " + oneOfThree}),
                    bad("APictureAfterAColor", "[sky]\ncolor" + white + "image = 'a.hdr'", 3, 1,
                        {"'image' in [sky] beside 'color', " + oneOfThree}),
                    bad("AColorAfterAPicture", "[sky]\nimage = 'a.hdr'\n  color" + white, 3, 3,
                        {"'color' in [sky] beside 'image', " + oneOfThree}),
                    bad("APictureAfterAGradient", "[sky]\nhorizon" + white + "zenith" + white + "image = 'a.hdr'", 4, 1,
                        {"'image' in [sky] beside 'horizon', " + oneOfThree}),
                    bad("AZenithAfterAPicture", "[sky]\nimage = 'a.hdr'\nzenith" + white, 3, 1,
                        {"'zenith' in [sky] beside 'image'"}),
                    bad("ASunAfterAPicture", "[sky]\nimage = 'a.hdr'\n" + sunny, 3, 1,
                        {"'sun' in [sky] beside 'image', expected no 'sun', since a picture shows its own"}),
                    bad("APictureAfterASun", "[sky]\n" + sunny + "image = 'a.hdr'", 3, 1,
                        {"'image' in [sky] beside 'sun', expected no"}),
                    bad("AHorizonAlone", "[sky]\nhorizon" + white, 2, 1,
                        {"'horizon' in [sky] without 'zenith', expected 'zenith' as well"}),
                    bad("AZenithAlone", "[sky]\n" + sunny + "zenith" + white, 3, 1,
                        {"'zenith' in [sky] without 'horizon', expected 'horizon' as well"}),
                    bad("AMappingAlone", "[sky]\nmapping = 'angular'", 2, 1,
                        {"'mapping' in [sky] without 'image', expected 'image' as well"}),
                    bad("AMappingOfAColor", "[sky]\ncolor" + white + "mapping = 'latlong'", 3, 1,
                        {"'mapping' in [sky] without"}),
                    bad("ASunNowhere", "[sky]\nsun = { direction = [0, 0.0, -0.0], color = [1, 1, 1] }", 2, 21,
                        {"'direction' in the sun of [sky]: expected a direction, got the zero vector"}),
                    bad("APictureWithoutItsFile", "[sky]\nimage = 'no such folder/a.hdr'", 2, 9,
                        {"no such folder/a.hdr: no such file"}),
                    bad("APictureWithoutAName", "[sky]\nimage = ''", 2, 9,
                        {"'image' in [sky]: expected the name of a file, got ''"})),
    nameOf);

TEST(NearestWord, CountsASwapAsOneChange)
{
    EXPECT_EQ(editDistance("center", "centre", 9), 1u);
    EXPECT_EQ(editDistance("colour", "color", 9), 1u);
    EXPECT_EQ(editDistance("SKY", "sky", 9), 0u);
    EXPECT_EQ(editDistance("kitten", "sitting", 9), 3u);
    EXPECT_EQ(editDistance("kitten", "sitting", 2), 3u);
    EXPECT_EQ(editDistance("", "abc", 9), 3u);
}

TEST(NearestWord, IsEmptyIfNothingIsNear)
{
    EXPECT_EQ(nearestWord("zzz", {"eye", "target"}), "");
    EXPECT_EQ(nearestWord("", {"eye", "target"}), "");
    EXPECT_EQ(nearestWord("eye", {}), "");
    EXPECT_EQ(nearestWord("taget", {"eye", "target"}), "target");
    EXPECT_EQ(nearestWord("ab", {"xb", "ay"}), "xb");
}

// ---- files ---------------------------------------------------------------------------------------------------------

TEST(SceneFileOnDisk, IsReadWhole)
{
    const TemporaryFolder folder;
    std::string padded = everything;
    while (padded.size() < 3 << 20) padded += "# " + std::string(1000, 'x') + "\n";
    const auto path = folder.file("a.toml", padded + "[[light]]\nposition = [1, 2, 3]\ncolor = [1, 1, 1]\n");
    const auto scene = loadScene(path);
    EXPECT_EQ(scene.file, path);
    EXPECT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(loadScene(folder.file("empty.toml", "")).spheres.size(), 0u);
}

TEST(SceneFileOnDisk, ThatIsMissingBringsTheNearestName)
{
    const TemporaryFolder folder;
    folder.file("glass.toml", "");
    folder.file("mirror.toml", "");
    folder.file("glas.txt", "");
    const auto prefix = (folder.path / "").string();
    EXPECT_EQ(loadErrorOf(prefix + "glas.toml"), prefix + "glas.toml: no such file, did you mean 'glass.toml'?");
    EXPECT_EQ(loadErrorOf(prefix + "glass"), prefix + "glass: no such file, did you mean 'glass.toml'?");
    EXPECT_EQ(loadErrorOf(prefix + "unlike"), prefix + "unlike: no such file");
    EXPECT_EQ(loadErrorOf(prefix + "none/glas.toml"), prefix + "none/glas.toml: no such file");
}

TEST(SceneFileOnDisk, ThatCannotBeReadIsRefused)
{
    const TemporaryFolder folder;
    EXPECT_NE(loadErrorOf("").find("no such file"), std::string::npos);
    EXPECT_NE(loadErrorOf(folder.path.string()).find("this is a folder, expected a scene file"), std::string::npos);
    EXPECT_NE(loadErrorOf("/proc/self/mem").find("cannot be read"), std::string::npos);
    EXPECT_NE(loadErrorOf(std::string(10000, 'x')).find("cannot be opened"), std::string::npos);
    if (geteuid() == 0) return; // root may read everything
    const auto secret = folder.file("secret.toml", "");
    fs::permissions(secret, fs::perms::none);
    EXPECT_NE(loadErrorOf(secret).find("cannot be opened"), std::string::npos);
}

TEST(SceneFileOnDisk, KeepsTheNameInItsErrors)
{
    const TemporaryFolder folder;
    const auto path = folder.file("bad.toml", "[sky]\ncolor = 1");
    EXPECT_EQ(loadErrorOf(path),
              path + ":2:9: 'color' in [sky]: expected an array of 3 numbers, each of at least 0, got 1");
}

TEST(SceneFileOnDisk, BeyondTheLimitIsRefused)
{
    const TemporaryFolder folder;
    const auto large = folder.file("large.toml", "");
    fs::resize_file(large, largestSceneFile + 1); // sparse: takes no room
    EXPECT_NE(loadErrorOf(large).find("too large, expected at most 256 MiB"), std::string::npos);
    EXPECT_NE(loadErrorOf("/dev/zero").find("not a text file, byte 1 is zero"), std::string::npos);
}

TEST(SceneFileOnDisk, IsNotReadBeyondTheLimit)
{
    const TemporaryFolder folder;
    const auto pipe = (folder.path / "endless.toml").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const auto before = std::signal(SIGPIPE, SIG_IGN); // the writer finds out by an error instead

    std::atomic<std::size_t> written = 0;
    std::thread writer([&] {
        const std::string comment = "#" + std::string(65535, '\n');
        const int file = open(pipe.c_str(), O_WRONLY);
        for (ssize_t n = 0; written < 2 * largestSceneFile; written += std::size_t(n))
            if ((n = write(file, comment.data(), comment.size())) < 0) break;
        close(file);
    });
    const auto message = loadErrorOf(pipe);
    writer.join();
    std::signal(SIGPIPE, before);

    EXPECT_EQ(message, pipe + ": too large, expected at most 256 MiB");
    EXPECT_GT(written, largestSceneFile);
    EXPECT_LE(written, largestSceneFile + (1 << 20)); // what waits in the pipe counts as written
}

// ---- pictures of the sky -------------------------------------------------------------------------------------------

Image smallPicture()
{
    Image image(4, 2);
    for (std::size_t i = 0; i < 8; ++i) image.pixels[i] = {double(i), 100.0 - double(i), 0.25};
    return image;
}

TEST(SkyPicture, IsReadFromTheScenesFolderLinearAndUnclamped)
{
    const TemporaryFolder folder;
    fs::create_directories(folder.path / "skies");
    for (const char* name : {"sky.exr", "skies/sky.hdr"})
    {
        writeImage(smallPicture(), (folder.path / name).string());
        const auto path = folder.file("scene.toml", fmt::format("[sky]\nimage = '{}'", name));
        const auto sky = loadScene(path).sky;
        EXPECT_TRUE(sky.present);
        EXPECT_EQ(sky.imageFile, name);
        EXPECT_EQ(sky.mapping, SkyMapping::latlong) << "the default";
        ASSERT_TRUE(sky.image);
        EXPECT_TRUE(compare(*sky.image, smallPicture(), 0.5, 0).equal()) << name; // .hdr shares an exponent
    }
    EXPECT_EQ(loadScene(folder.file("exr.toml", "[sky]\nimage = 'sky.exr'")).sky.image->pixels, smallPicture().pixels);

    writeImage(Image(1, 1), (folder.path / "black.png").string());
    const auto sky = loadScene(folder.file("scene.toml", "[sky]\nimage = 'black.png'\nmapping = 'angular'")).sky;
    EXPECT_EQ(sky.mapping, SkyMapping::angular);
    EXPECT_EQ(sky.image->pixels, Image(1, 1).pixels);

    const auto elsewhere = (folder.path / "sky.exr").string();
    EXPECT_TRUE(parseScene(fmt::format("[sky]\nimage = '{}'", elsewhere), "no such folder/scene.toml").sky.image)
        << "an absolute name stays";
}

TEST(SkyPicture, ThatCannotBeUsedIsRefusedAtItsKey)
{
    const TemporaryFolder folder;
    const auto in = [&](const std::string& name) { return (folder.path / name).string(); };
    const auto errorFor = [&](const std::string& name) {
        const auto scene = folder.file("scene.toml", fmt::format("title = ''\n[sky]\nimage = '{}'\n", name));
        const auto message = loadErrorOf(scene), place = scene + ":3:9: " + in(name) + ": ";
        EXPECT_EQ(message.substr(0, place.size()), place) << message;
        EXPECT_EQ(message.find('\n'), message.npos) << message;
        return message.substr(std::min(message.size(), place.size()));
    };
    writeImage(smallPicture(), in("probe.exr"));
    folder.file("prob.ex", ""); // as near, but no picture
    EXPECT_EQ(errorFor("prob.exr"), "no such file, did you mean 'probe.exr'?");
    EXPECT_EQ(errorFor("unlike"), "no such file");
    EXPECT_EQ(errorFor("."), "this is a folder, expected a picture (.hdr, .exr, .png)");
    ASSERT_EQ(mkfifo(in("pipe.hdr").c_str(), 0600), 0);
    EXPECT_EQ(errorFor("pipe.hdr"), "not a regular file, expected a picture (.hdr, .exr, .png)");
    fs::resize_file(folder.file("large.hdr", ""), largestSceneFile + 1);
    EXPECT_EQ(errorFor("large.hdr"), "too large, expected at most 256 MiB");
    folder.file("text.png", "hello\n");
    EXPECT_NE(errorFor("text.png").find("cannot be read as a picture"), std::string::npos);
    folder.file("empty.exr", "");
    EXPECT_NE(errorFor("empty.exr").find("cannot be read as a picture"), std::string::npos);
    fs::resize_file(in("probe.exr"), fs::file_size(in("probe.exr")) - 40);
    EXPECT_NE(errorFor("probe.exr").find("cannot be read"), std::string::npos);

    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double wrong : {nan, infinity<double>, -infinity<double>, -0.5})
        for (int channel = 0; channel < 3; ++channel)
        {
            auto image = smallPicture();
            image.at(3, 1)[channel] = wrong;
            image.at(2, 1)[channel] = -0.0; // as good as 0
            writeImage(image, in("wrong.exr"));
            EXPECT_EQ(errorFor("wrong.exr"), "pixel (3, 1) is not a finite number of at least 0") << wrong;
        }
}

TEST(SkyPicture, ALittleBelowZeroIsZeroWithAWord)
{
    const TemporaryFolder folder;
    auto image = smallPicture();
    image.at(3, 1).x = -1e-8;
    image.at(0, 1).y = -0.01;
    writeImage(image, (folder.path / "lossy.exr").string());
    const auto path = folder.file("scene.toml", "[sky]\nimage = 'lossy.exr'");
    const auto scene = loadScene(path);
    EXPECT_EQ(scene.sky.image->at(3, 1).x, 0);
    EXPECT_EQ(scene.sky.image->at(0, 1).y, 0);
    EXPECT_EQ(scene.warnings,
              std::vector{fmt::format("{}:2:9: {}: 2 pixels are a little below 0 and taken as 0, the first "
                                      "of them (0, 1)",
                                      path, (folder.path / "lossy.exr").string())});
}

TEST(SkyPicture, OfAnotherShapeThanItsMappingIsTold)
{
    const TemporaryFolder folder;
    const auto warningsOf = [&](int width, int height, const char* mapping) {
        writeImage(Image(width, height), (folder.path / "sky.png").string());
        return loadScene(folder.file("scene.toml", fmt::format("[sky]\nimage = 'sky.png'\nmapping = '{}'", mapping)))
            .warnings;
    };
    EXPECT_TRUE(warningsOf(16, 8, "latlong").empty());
    EXPECT_TRUE(warningsOf(15, 8, "latlong").empty());
    EXPECT_TRUE(warningsOf(8, 8, "angular").empty());
    ASSERT_EQ(warningsOf(8, 8, "latlong").size(), 1u);
    EXPECT_NE(
        warningsOf(8, 8, "latlong")[0].find("sky.png is 8x8; a lat-long picture is twice as wide as high; is it an "
                                            "angular probe, mapping = \"angular\"?"),
        std::string::npos);
    EXPECT_NE(warningsOf(16, 8, "angular").at(0).find("an angular probe is square; is it lat-long?"),
              std::string::npos);
}

// ---- glass ---------------------------------------------------------------------------------------------------------

TEST(Glass, ThatIsOpenMixedOrInwardsIsTold)
{
    const TemporaryFolder folder;
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const auto warningOf = [&](const std::string& faces, const char* material = "ior = 1.5") {
        folder.file("m.obj", vertices + faces);
        const auto scene = loadScene(folder.file(
            "scene.toml", fmt::format("[materials.m]\n{}\n[[mesh]]\nmaterial = 'm'\nfile = 'm.obj'\n", material)));
        EXPECT_LE(scene.warnings.size(), 1u);
        return scene.warnings.empty() ? "" : scene.warnings[0];
    };
    const auto tells = [&](const std::string& warning, const char* words) {
        return warning.starts_with((folder.path / "scene.toml").string() + ":5:8: m.obj: ") &&
               warning.find(words) != warning.npos;
    };
    EXPECT_EQ(warningOf("f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"), "");
    EXPECT_TRUE(tells(warningOf("f 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n"), "face inwards"));
    EXPECT_TRUE(tells(warningOf("f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 3 4\n"), "face both inwards and outwards"));
    EXPECT_TRUE(tells(warningOf("f 1 3 2\nf 1 2 4\nf 2 3 4\n"), "is open"));
    EXPECT_EQ(warningOf("f 1 3 2\n", "mirror = 1"), "") << "no glass";
}

TEST(Glass, WithinGlassMustSayWhatIsAroundIt)
{
    const auto warnings = [](double outside, double x) {
        return parseScene(fmt::format("[materials.water]\nior = 1.33\n[materials.air]\nior = 1.0\nior_outside = {}\n"
                                      "[[sphere]]\ncenter = [0, 0, 0]\nradius = 2\nmaterial = 'water'\n"
                                      "[[sphere]]\ncenter = [{}, 0, 0]\nradius = 1\nmaterial = 'air'\n",
                                      outside, x),
                          "nest.toml")
            .warnings;
    };
    EXPECT_TRUE(warnings(1.33, 0.5).empty());
    EXPECT_TRUE(warnings(1.5, 5).empty());
    EXPECT_EQ(warnings(1.5, 0.5),
              std::vector<std::string>{"nest.toml: sphere1 lies in sphere0, which has ior 1.33, but its "
                                       "material 'air' has ior_outside 1.5"});
}

TEST(SceneFile, WarnsOfASphereThatIsThereTwice)
{
    const auto warnings = [](double x) {
        return parseScene(fmt::format("[materials.m]\n[[sphere]]\ncenter = [1, 0, 0]\nradius = 2\nmaterial = 'm'\n"
                                      "[[sphere]]\ncenter = [{}, 0, 0]\nradius = 2\nmaterial = 'm'\n",
                                      x),
                          "twice.toml")
            .warnings;
    };
    EXPECT_TRUE(warnings(1.5).empty());
    EXPECT_EQ(warnings(1), std::vector<std::string>{
                               "twice.toml: sphere1 has the centre and the radius of sphere0, and is never met"});
}

TEST(SceneFile, ANameWithAnEscapeByMistakeIsRefused)
{
    EXPECT_EQ(errorOf("[materials.m]\n[[mesh]]\nfile = \"models\\bunny.obj\"\nmaterial = 'm'\n"),
              "scene.toml:3:8: 'file' in [[mesh]]: within \"\" a backslash begins an escape, and '\\x08' came of it, "
              "expected / between folders, or the name within ''");
}

// ---- the reference -------------------------------------------------------------------------------------------------

std::string reference()
{
    std::ifstream file(fs::path(RAYTREE_SOURCE_DIR) / "common/SCENES.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(SceneReference, StartsWithASceneThatLoads)
{
    const auto text = reference();
    const std::string fence = "```toml\n";
    const auto start = text.find(fence) + fence.size();
    ASSERT_GT(start, fence.size());
    const auto scene = parseScene(text.substr(start, text.find("```", start) - start), "SCENES.md");
    EXPECT_EQ(scene.spheres.size(), 1u);
    EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(SceneReference, NamesEveryKey)
{
    const auto page = reference();
    int keys = 0;
    for (const std::string& text :
         {std::string("[camera]\nzzzz = 1"), std::string("[trace]\nzzzz = 1"), std::string("[sky]\nzzzz = 1"),
          std::string("[sky]\nsun = { zzzz = 1 }"), std::string("[materials.m]\nzzzz = 1"),
          std::string("[[mesh]]\nzzzz = 1"), std::string("[[sphere]]\nzzzz = 1"), std::string("[[plane]]\nzzzz = 1"),
          plainPlane + "checker = { zzzz = 1 }", std::string("[[triangle]]\nzzzz = 1"),
          std::string("[[light]]\nzzzz = 1")})
    {
        // "unknown key 'zzzz' in ..., expected 'eye', 'target' or 'up'": the known keys stand between quotes.
        const auto message = errorOf(text);
        auto quote = message.find("expected");
        ASSERT_NE(quote, message.npos) << message;
        while ((quote = message.find('\'', quote)) != message.npos)
        {
            const auto end = message.find('\'', quote + 1);
            const auto key = message.substr(quote + 1, end - quote - 1);
            EXPECT_NE(page.find("`" + key + "`"), page.npos) << key << " of " << text;
            quote = end + 1;
            ++keys;
        }
    }
    EXPECT_EQ(keys, 6 + 5 + 6 + 3 + 6 + 2 + 3 + 4 + 2 + 2 + 2);
}

// ---- round trip ----------------------------------------------------------------------------------------------------

std::uint64_t bits(double x)
{
    return std::bit_cast<std::uint64_t>(x);
}

bool same(double a, double b)
{
    return bits(a) == bits(b);
}

bool same(const Vec3<double>& a, const Vec3<double>& b)
{
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

void requireSame(const SceneDescription& a, const SceneDescription& b)
{
    RC_ASSERT(a.title == b.title);
    RC_ASSERT(same(a.camera.eye, b.camera.eye));
    RC_ASSERT(same(a.camera.target, b.camera.target));
    RC_ASSERT(same(a.camera.up, b.camera.up));
    RC_ASSERT(same(a.camera.verticalFov, b.camera.verticalFov));
    RC_ASSERT(a.camera.width == b.camera.width && a.camera.height == b.camera.height);
    RC_ASSERT(a.camera.pixelX == b.camera.pixelX && a.camera.pixelY == b.camera.pixelY);
    RC_ASSERT(a.trace.maxDepth == b.trace.maxDepth && same(a.trace.cutoff, b.trace.cutoff));
    RC_ASSERT(a.trace.atCap == b.trace.atCap && a.trace.fresnel == b.trace.fresnel);
    RC_ASSERT(a.trace.shadowThroughGlass == b.trace.shadowThroughGlass);
    RC_ASSERT(a.sky.present == b.sky.present && same(a.sky.color, b.sky.color));
    RC_ASSERT(a.sky.zenith.has_value() == b.sky.zenith.has_value());
    if (a.sky.zenith) RC_ASSERT(same(*a.sky.zenith, *b.sky.zenith));
    RC_ASSERT(a.sky.sun.has_value() == b.sky.sun.has_value());
    if (a.sky.sun)
        RC_ASSERT(same(a.sky.sun->direction, b.sky.sun->direction) && same(a.sky.sun->color, b.sky.sun->color) &&
                  same(a.sky.sun->size, b.sky.sun->size));
    RC_ASSERT(a.sky.imageFile == b.sky.imageFile && a.sky.mapping == b.sky.mapping);
    RC_ASSERT((a.sky.image != nullptr) == (b.sky.image != nullptr));
    if (a.sky.image) RC_ASSERT(a.sky.image->width == b.sky.image->width && a.sky.image->pixels == b.sky.image->pixels);
    RC_ASSERT(a.materials.size() == b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i)
    {
        const auto &m = a.materials[i], &n = b.materials[i];
        RC_ASSERT(m.name == n.name && same(m.color, n.color) && same(m.exponent, n.exponent));
        RC_ASSERT(same(m.mirror, n.mirror) && same(m.glossy, n.glossy));
        RC_ASSERT(same(m.ior, n.ior) && same(m.iorOutside, n.iorOutside));
    }
    RC_ASSERT(a.spheres.size() == b.spheres.size());
    for (std::size_t i = 0; i < a.spheres.size(); ++i)
    {
        const auto &s = a.spheres[i], &t = b.spheres[i];
        RC_ASSERT(same(s.center, t.center) && same(s.radius, t.radius) && s.material == t.material);
    }
    RC_ASSERT(a.planes.size() == b.planes.size());
    for (std::size_t i = 0; i < a.planes.size(); ++i)
    {
        const auto &p = a.planes[i], &q = b.planes[i];
        RC_ASSERT(same(p.point, q.point) && same(p.normal, q.normal) && p.material == q.material);
        RC_ASSERT(p.hasChecker == q.hasChecker && same(p.checkerColor, q.checkerColor));
        RC_ASSERT(same(p.checkerSize, q.checkerSize));
    }
    RC_ASSERT(a.triangles.size() == b.triangles.size());
    for (std::size_t i = 0; i < a.triangles.size(); ++i)
    {
        for (std::size_t j = 0; j < 3; ++j) RC_ASSERT(same(a.triangles[i].vertices[j], b.triangles[i].vertices[j]));
        RC_ASSERT(a.triangles[i].material == b.triangles[i].material);
    }
    RC_ASSERT(a.meshes.size() == b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i)
    {
        const auto &m = a.meshes[i], &n = b.meshes[i];
        RC_ASSERT(m.file == n.file && m.material == n.material && *m.triangles == *n.triangles);
    }
    RC_ASSERT(a.lights.size() == b.lights.size());
    for (std::size_t i = 0; i < a.lights.size(); ++i)
        RC_ASSERT(same(a.lights[i].position, b.lights[i].position) && same(a.lights[i].color, b.lights[i].color));
    for (const auto& warning : b.warnings) RC_ASSERT(warning.find("left out") == warning.npos);
}

int whole(int least, int most)
{
    return *rc::gen::inRange(least, most + 1);
}

/// Any finite double, each pattern of bits alike, with the ends of the format more often.
double anyDouble()
{
    constexpr double ends[] = {0.0, -0.0, 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 1e16, 0.1, -1e-5, 3};
    if (whole(0, 3) == 0) return ends[whole(0, int(std::size(ends)) - 1)];
    const auto pattern =
        (std::uint64_t(std::uint32_t(*rc::gen::inRange<std::int64_t>(0, std::int64_t(1) << 32))) << 32) |
        std::uint32_t(*rc::gen::inRange<std::int64_t>(0, std::int64_t(1) << 32));
    const double x = std::bit_cast<double>(pattern);
    return std::isfinite(x) ? x : 1.5;
}

double notNegative()
{
    const double x = std::abs(anyDouble());
    return x;
}

double positive()
{
    const double x = std::abs(anyDouble());
    return x > 0 ? x : 1;
}

/// In [0, 1]: the mantissa of any double.
double share()
{
    int exponent = 0;
    const double x = std::abs(std::frexp(anyDouble(), &exponent));
    return whole(0, 5) == 0 ? double(whole(0, 1)) : x;
}

template <class Number>
Vec3<double> triple(Number&& number)
{
    const double x = number(), y = number(), z = number();
    return {x, y, z};
}

std::string anyText()
{
    constexpr const char* pieces[] = {"a", "B", "7",  "_",  "-",    " ",    ".", "\"", "\\",
                                      "'", "#", "\n", "\t", "\x7f", "\x01", "é", "日", "]"};
    std::string text;
    for (int n = whole(0, 8); n > 0; --n) text += pieces[whole(0, int(std::size(pieces)) - 1)];
    return text;
}

SceneDescription anyScene()
{
    const auto any = [] { return triple(anyDouble); };
    // Points from which differences and directions stay well defined.
    const auto point = [] { return triple([] { return double(whole(-1000000, 1000000)) / 1024 * 0.1; }); };

    SceneDescription scene;
    scene.title = anyText();
    scene.camera.eye = point();
    scene.camera.target = scene.camera.eye + Vec3<double>(whole(1, 9), whole(-9, 9), 0.3);
    scene.camera.up = {0, 1e-3 * whole(-99, 99), positive() < 1 ? 0.7 : -1e200};
    scene.camera.verticalFov = std::max(share() * 179, 5e-324);
    scene.camera.width = whole(1, 65536);
    scene.camera.height = whole(1, 4096);
    if (whole(0, 1)) scene.camera.pixelX = whole(0, scene.camera.width - 1);
    if (scene.camera.pixelX >= 0) scene.camera.pixelY = whole(0, scene.camera.height - 1);
    scene.trace = {whole(0, 1024), notNegative(), AtCap(whole(0, 2)), FresnelModel(whole(0, 2)),
                   ShadowThroughGlass(whole(0, 1))};
    scene.sky.present = whole(0, 1);
    if (scene.sky.present) scene.sky.color = triple(notNegative);
    if (scene.sky.present && whole(0, 1)) scene.sky.zenith = triple(notNegative);
    if (scene.sky.present && whole(0, 1))
        scene.sky.sun =
            Sun{{anyDouble(), positive(), anyDouble()}, triple(notNegative), std::max(share() * 180, 5e-324)};

    const int materials = whole(1, 4);
    for (int i = 0; i < materials; ++i)
    {
        Material<double> material{.name = anyText() + std::to_string(9 - i), .color = triple(share)};
        material.exponent = notNegative();
        if (whole(0, 1))
        {
            material.ior = positive();
            material.iorOutside = positive();
        }
        else
        {
            material.mirror = share();
            material.glossy = share();
        }
        scene.materials.push_back(material);
    }
    const auto material = [&] { return whole(0, materials - 1); };
    for (int n = whole(0, 3); n > 0; --n) scene.spheres.push_back({any(), positive(), material()});
    for (int n = whole(0, 3); n > 0; --n)
    {
        scene.planes.push_back({any(), {anyDouble(), positive(), anyDouble()}, material()});
        auto& plane = scene.planes.back();
        plane.hasChecker = whole(0, 1);
        if (plane.hasChecker) plane.checkerColor = triple(share);
        if (plane.hasChecker) plane.checkerSize = positive();
    }
    for (int n = whole(0, 3); n > 0; --n)
    {
        const auto a = point();
        scene.triangles.push_back(
            {{a, a + Vec3<double>(whole(1, 9), 0, 0.1), a + Vec3<double>(0.1, whole(1, 9), 0)}, material()});
    }
    for (int n = whole(0, 3); n > 0; --n) scene.lights.push_back({any(), triple(notNegative)});
    return scene;
}

RC_GTEST_PROP(SceneToToml, ReadsBackToTheSameNumbers, ())
{
    const auto scene = anyScene();
    const auto text = sceneToToml(scene);
    requireSame(scene, parseScene(text, "scene.toml"));
    RC_ASSERT(sceneToToml(parseScene(text, "scene.toml")) == text);
}

TEST(SceneToToml, KeepsEverything)
{
    const auto scene = parseScene(everything, "scene.toml");
    const auto again = parseScene(sceneToToml(scene), "scene.toml");
    EXPECT_TRUE(rc::check([&] { requireSame(scene, again); }));
}

/// A scene with files: a picture of the sky and a mesh, whose names need care.
std::string withFiles(const TemporaryFolder& folder)
{
    fs::create_directories(folder.path / "with \"quotes\"");
    writeImage(smallPicture(), (folder.path / "with \"quotes\"/s\\y.exr").string());
    folder.file("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1\nf 1 2 3 4\n");
    return "[materials.m]\n[materials.n]\n[sky]\nimage = 'with \"quotes\"/s\\y.exr'\nmapping = 'angular'\n"
           "[[mesh]]\nfile = 'm.obj'\nmaterial = 'n'\n[[mesh]]\nfile = './m.obj'\nmaterial = 'm'\n";
}

TEST(SceneToToml, KeepsTheNamesOfFiles)
{
    const TemporaryFolder folder;
    const auto name = (folder.path / "scene.toml").string();
    const auto scene = parseScene(withFiles(folder), name);
    ASSERT_TRUE(scene.sky.image);
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].triangles->size(), 2u);
    EXPECT_EQ(scene.meshes[0].material, 1);
    const auto again = parseScene(sceneToToml(scene), name);
    EXPECT_TRUE(rc::check([&] { requireSame(scene, again); }));
}

// ---- noise ---------------------------------------------------------------------------------------------------------

const std::vector<std::string> tokens{"[",
                                      "]",
                                      "[[",
                                      "]]",
                                      "{",
                                      "}",
                                      "=",
                                      ",",
                                      ".",
                                      "\"",
                                      "'",
                                      "\"\"\"",
                                      "#",
                                      "\n",
                                      "\r",
                                      "-",
                                      "+",
                                      "e",
                                      "nan",
                                      "inf",
                                      "1e308",
                                      "0x",
                                      "true",
                                      "1979-05-27T07:32:00Z",
                                      "9223372036854775807",
                                      "\xEF\xBB\xBF",
                                      "\xF0\x9F",
                                      "[sky]",
                                      "[[mesh]]",
                                      "zenith = [0, 0, 1]\n",
                                      "sun = { direction = [0, 1, 0], color = [1, 1, 1] }\n",
                                      "m.obj",
                                      "[materials]",
                                      "ior = 1\n",
                                      "a.b.c"};

/// How many of the mutated texts are scenes; the others give a SceneError.
int scenesAmongNoise(const std::string& text, const std::string& name, int count)
{
    std::mt19937 random(20240117);
    int scenes = 0;
    for (int i = 0; i < count; ++i)
    {
        const auto noise = mutated(text, random, tokens, 2, 40);
        try
        {
            const auto scene = parseScene(noise, name);
            parseScene(sceneToToml(scene), name); // what was read can be written
            ++scenes;
        }
        catch (const SceneError& error)
        {
            const std::string message = error.what();
            EXPECT_TRUE(message.starts_with(name + ":")) << message;
            EXPECT_EQ(message.find('\n'), message.npos) << message;
        }
        catch (...)
        {
            ADD_FAILURE() << "not a SceneError, for:\n" << noise;
        }
    }
    return scenes;
}

TEST(SceneFile, MeetsNoiseWithASceneOrASceneError)
{
    const int scenes = scenesAmongNoise(everything, "scene.toml", 10000);
    EXPECT_GT(scenes, 300);
    EXPECT_LT(scenes, 9000);
}

TEST(SceneFileOnDisk, MeetsNoiseWithASceneOrASceneError)
{
    const TemporaryFolder folder;
    const int scenes = scenesAmongNoise(withFiles(folder), (folder.path / "scene.toml").string(), 2000);
    EXPECT_GT(scenes, 20);
    EXPECT_LT(scenes, 1800);
}

} // namespace
