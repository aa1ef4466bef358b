// OBJ files: what is read, what is refused with its line, and meshes in a scene.
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/files/obj_file.h"
#include "common/files/scene_file.h"
#include "common/scene/scene.h"
#include "tests/common/mutated.h"

namespace rt
{

namespace
{

namespace fs = std::filesystem;
using V = Vec3<double>;
using Triangles = std::vector<MeshTriangle>;

class ObjFile : public testing::Test
{
protected:
    fs::path folder = fs::path(testing::TempDir()) / fmt::format("raytree_obj_file_{}", getpid());
    std::vector<std::string> warnings;

    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    std::string in(const std::string& name) const { return (folder / name).string(); }

    std::string file(const std::string& name, const std::string& text) const
    {
        fs::remove(in(name)); // quicker than to overwrite it
        std::ofstream(in(name), std::ios::binary) << text;
        return in(name);
    }

    Triangles read(const std::string& text) { return readObj(file("m.obj", text), warnings); }

    /// What readObj says after the file's name, or "no error".
    std::string errorFor(const std::string& path)
    {
        try
        {
            readObj(path, warnings);
            return "no error";
        }
        catch (const std::runtime_error& error)
        {
            const std::string message = error.what();
            EXPECT_EQ(message.substr(0, path.size() + 1), path + ":");
            return message.substr(path.size() + 1);
        }
    }
};

const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const V a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);

/// Unit cube around (0.5, 0.5, 0.5), faces counterclockwise from outside.
const std::string cube = "# a cube\no cube\n"
                         "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

// ---- good files ----------------------------------------------------------------------------------------------------

TEST_F(ObjFile, ACubeIsTwelveTrianglesThatFaceOutwards)
{
    const auto triangles = read(cube);
    ASSERT_EQ(triangles.size(), 12u);
    double area = 0, volume = 0;
    for (const auto& [p, q, r] : triangles)
    {
        const V twiceArea = cross(q - p, r - p);
        area += length(twiceArea) / 2;
        volume += dot(p, twiceArea) / 6;
        EXPECT_GT(dot(twiceArea, (p + q + r) / 3.0 - V(0.5)), 0);
    }
    EXPECT_DOUBLE_EQ(area, 6);
    EXPECT_DOUBLE_EQ(volume, 1);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(ObjFile, FacesBecomeFansAroundTheirFirstCorner)
{
    EXPECT_EQ(read(corners + "f 1 2 3"), (Triangles{{a, b, c}}));
    EXPECT_EQ(read(corners + "f 1 2 3 4"), (Triangles{{a, b, c}, {a, c, d}}));
    EXPECT_EQ(read(corners + "f 3 4 1 2\nf 1 2 3"), (Triangles{{c, d, a}, {c, a, b}, {a, b, c}}));
    const V e(-1, 0.5, 0);
    EXPECT_EQ(read(corners + "v -1 .5 0\nf 1 2 3 4 5"), (Triangles{{a, b, c}, {a, c, d}, {a, d, e}}));
}

TEST_F(ObjFile, NegativeNumbersCountBackFromTheLastVertexAbove)
{
    EXPECT_EQ(read(corners + "f -4 -3 -2 -1"), (Triangles{{a, b, c}, {a, c, d}}));
    EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 2 -1\n"), (Triangles{{a, b, c}, {a, b, d}}));
}

TEST_F(ObjFile, ACornerMayHaveTextureAndNormal)
{
    const std::string more = corners + "vt 0 0\nvn 0 0 -1\n";
    for (const char* face : {"f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f -4/-1/-1 2//-1 3/1",
                             "f 1/ 2// 3/1/", "f\t1  2 \t3  "})
        EXPECT_EQ(read(more + face), (Triangles{{a, b, c}})) << face << ": its own normal, whatever the file says";
}

TEST_F(ObjFile, WhatIsNoPositionAndNoFaceIsPassedOver)
{
    EXPECT_EQ(read("\xEF\xBB\xBF# comment\nmtllib a b.mtl\no thing\n\n   \n" + corners +
                   "vt 1\nvn 0 0 1\nvp 1 2\ng left upper\ns off\ns 1\nusemtl #1\n"
                   "  # C:\\models\\\nf 1 2 3 # the only one\nl 1 2\np 1\n#f 1 2 4\nend"),
              (Triangles{{a, b, c}}));
}

TEST_F(ObjFile, LineEndsAndBlanksAreFree)
{
    std::string windows;
    for (const char letter : cube) windows += letter == '\n' ? "\r\n" : std::string(1, letter);
    EXPECT_EQ(read(windows), read(cube));
    EXPECT_EQ(read("  v   0 0\t0 \nv 1 0 0\n\tv 1 1 0\n f 1 2 3"), (Triangles{{a, b, c}})) << "no line end at the end";
}

TEST_F(ObjFile, ABackslashJoinsLines)
{
    EXPECT_EQ(read(corners + "f 1 \\\n 2\\\n3\\\r\n\\\n4\n"), (Triangles{{a, b, c}, {a, c, d}}));
    EXPECT_EQ(errorFor(file("m.obj", "v 0 \\\n0 0\nv 1\\\n 0\nf 1 2 x")),
              "3: a vertex of 2 numbers, expected 3: 'v x y z'");
    EXPECT_EQ(errorFor(file("m.obj", corners + "f 1 2 3\\\n4 \\\n\nf")).substr(0, 2), "8:");
    EXPECT_EQ(errorFor(file("m.obj", "# no \\\n" + corners + "f")).substr(0, 2), "6:");
}

TEST_F(ObjFile, ABackslashThatEndsANameOrACommentJoinsNothing)
{
    const Triangles both{{a, b, c}, {a, c, d}};
    for (const std::string name : {"g some\\", "o C:\\scans\\", "usemtl m \\", "# C:\\scans\\", "s off\\ "})
        EXPECT_EQ(read(corners + name + "\nf 1 2 3\n" + name + "\nf 1 3 4\n" + name), both) << name;
    EXPECT_EQ(read(corners + "f 1 2 3 # from C:\\scans\\\nf 1 3 4\n"), both);
    EXPECT_EQ(read(corners + "f 1 2 3 \\\nf 1 3 4 \\\n"), both);
    EXPECT_EQ(read(corners + "f 1 2 \\ \n3 4\n"), both) << "a blank behind it";
    EXPECT_EQ(read(corners + "f 1 2 \\\t\r\n3 \\  \r\n4\r\n"), both);
    EXPECT_EQ(read("g some\\\n" + corners + "f 1 2 3\nf 1 3 4\n"), both);
}

TEST_F(ObjFile, OldLineEndsEndsAndWordsAreRead)
{
    const Triangles both{{a, b, c}, {a, c, d}};
    std::string old = "# made on an old machine\n" + corners + "f 1 2 3\n\nf 1 3 \\\n4\n";
    std::replace(old.begin(), old.end(), '\n', '\r');
    EXPECT_EQ(read(old), both);
    EXPECT_EQ(errorFor(file("m.obj", "v 0 0 0\rv x 0 0\r")), "2: 'x' is not a finite number, expected 'v x y z'");
    for (const char* end : {"\x1A", "\n\x1A", "\r\n\x1A\r\n", "\n\x1A\x1A\n"})
        EXPECT_EQ(read(corners + "f 1 2 3 4" + end), both);
    EXPECT_EQ(read(corners + "fo 1 2 3\nfo 1/1 3/1 4/1\n"), both);
}

TEST_F(ObjFile, FacesOfFewerThanThreeCornersHaveNoArea)
{
    EXPECT_EQ(read(corners + "f 1 2\nf 1 2 3\nf 4\n"), (Triangles{{a, b, c}}));
    EXPECT_EQ(warnings,
              std::vector{in("m.obj") + ":5: 2 triangles have no area and are left out, the first of them here"});
}

TEST_F(ObjFile, ConcavePolygonsAreCutAlongTheirEdges)
{
    const auto doorway = read("v -1 -1 0\nv -.4 -1 0\nv -.4 .3 0\nv .4 .3 0\nv .4 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                              "f 1 2 3 4 5 6 7 8\n");
    EXPECT_EQ(warnings, std::vector<std::string>{});
    double area = 0;
    for (const auto& [p, q, r] : doorway)
    {
        EXPECT_GT(cross(q - p, r - p).z, 0) << "cut triangles face as the polygon does";
        area += cross(q - p, r - p).z / 2;
    }
    EXPECT_NEAR(area, 4 - 0.8 * 1.3, 1e-12) << "the wall without its door";
}

TEST_F(ObjFile, APolygonThatCrossesItselfIsTold)
{
    read("v 0 0 0\nv 3 0 0\nv 0 2 0\nv 3 2 0\nf 1 2 3 4\nf 1 2 4\n");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0], in("m.obj") + ":5: a face is no polygon that could be cut into triangles, since it crosses "
                                         "itself; it is filled by a fan");
    warnings.clear();
    read("v 0 1 0\nv -.59 -.81 0\nv .95 .31 0\nv -.95 .31 0\nv .59 -.81 0\nf 1 2 3 4 5\n"); // a star drawn in one go
    EXPECT_EQ(warnings.size(), 1u);
}

TEST_F(ObjFile, NumbersKeepAllTheirBits)
{
    const auto triangles =
        read("v +0.1 1e-300 -1.7976931348623157e308\nv 0.30000000000000004 5e-324 -0\nv 1. .5E+2 1e2\n"
             "v 1 2 3 0.5\nv 4 5 6 0.1 0.2 0.3\nv 7 8 10 1 1 1 1\nf 1 2 3\nf 4 5 6\n");
    ASSERT_EQ(warnings.size(), 1u) << "beyond the range of double there is no area";
    EXPECT_EQ(triangles, (Triangles{{V(1, 2, 3), V(4, 5, 6), V(7, 8, 10)}}));
    EXPECT_EQ(read("v +0.1 1e-300 -1.5\nv 0.30000000000000004 5e-324 -0\nv 1. .5E+2 1e2\nf 1 2 3\n"),
              (Triangles{{V(0.1, 1e-300, -1.5), V(0.30000000000000004, 5e-324, 0), V(1, 50, 100)}}));
}

TEST_F(ObjFile, TrianglesWithoutAreaAreLeftOutWithOneWarning)
{
    EXPECT_EQ(read(corners + "f 1 2 3\nf 1 2 2\n"), (Triangles{{a, b, c}}));
    EXPECT_EQ(warnings, std::vector{in("m.obj") + ":6: a triangle has no area and is left out"});

    warnings.clear();
    EXPECT_EQ(read(corners + "v 2 2 0\nf 1 3 5\nf 1 2 3 3\nf 1 1 1\n"), (Triangles{{a, b, c}}));
    EXPECT_EQ(warnings,
              std::vector{in("m.obj") + ":6: 3 triangles have no area and are left out, the first of them here"});

    warnings.clear();
    EXPECT_TRUE(read(corners + "f 1 1 2").empty());
    EXPECT_EQ(warnings.size(), 1u);
}

TEST_F(ObjFile, MayHaveTwoToThe24Triangles)
{
    static_assert(mostMeshTriangles == 16777216);
    std::string face = "v 0 0 0\nf";
    for (std::size_t i = 0; i < mostMeshTriangles + 2; ++i) face += " 1";
    EXPECT_TRUE(read(face).empty());
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find(":2: 16777216 triangles have no area"), std::string::npos) << warnings[0];
    EXPECT_EQ(errorFor(file("m.obj", face + " 1")), "2: too many triangles, expected at most 16777216");
}

// ---- bad files -----------------------------------------------------------------------------------------------------

TEST_F(ObjFile, ThatIsBrokenIsRefusedInOneSentenceWithItsLine)
{
    struct Broken
    {
        std::string text;
        int line; ///< 0: no line
        std::string words;
    };
    const std::string noFinite = " is not a finite number, expected 'v x y z'";
    const std::string noCorner = " is not a corner, expected a vertex's number, as in 7, 7/1, 7//2 or 7/1/2";
    for (const auto& [text, line, words] : {
             Broken{"", 0, "the file is empty, expected at least one line such as 'f 1 2 3'"},
             Broken{"\n\n", 0, "there are no faces, expected at least one line such as 'f 1 2 3'"},
             Broken{corners, 0, "there are no faces"},
             Broken{"# f 1 2 3\n" + corners + "l 1 2\n", 0, "there are no faces"},
             Broken{"v 0 0 abc\n", 1, "'abc'" + noFinite},
             Broken{corners + "v 0 nan 0\n", 5, "'nan'" + noFinite},
             Broken{"v inf 0 0\n", 1, "'inf'" + noFinite},
             Broken{"v 0 0 -infinity\n", 1, "'-infinity'" + noFinite},
             Broken{"v 0 1,5 0\n", 1, "'1,5'" + noFinite},
             Broken{"v 0 0x10 0\n", 1, "'0x10'" + noFinite},
             Broken{"v 0 1e 0\n", 1, "'1e'" + noFinite},
             Broken{"v 0 +-1 0\n", 1, "'+-1'" + noFinite},
             Broken{"v 0 + 0\n", 1, "'+'" + noFinite},
             Broken{"v 0 1.5.5 0\n", 1, "'1.5.5'" + noFinite},
             Broken{"v 0 0 0 x\n", 1, "'x'" + noFinite},
             Broken{"v 0 0 0\rv 1 0 0\n", 1, "'v'" + noFinite},
             Broken{"v 0 0 1e999\n", 1, "'1e999' is beyond the range of double"},
             Broken{"v 0 0 -1e-400\n", 1, "'-1e-400' is beyond the range of double"},
             Broken{"\nv\n", 2, "a vertex of 0 numbers, expected 3: 'v x y z'"},
             Broken{"v 1 2 # 3\n", 1, "a vertex of 2 numbers, expected 3"},
             Broken{"v 1 2 3 4 5 6 7 8\n", 1, "a vertex of 8 numbers, expected 3"},
             Broken{corners + "f 0 1 2\n", 5, "there is no vertex '0' above this line, expected 1 to 4 or -4 to -1"},
             Broken{corners + "\r\nf 1 2 5\n", 6,
                    "there is no vertex '5' above this line, expected 1 to 4 or -4 to -1"},
             Broken{corners + "f 1 2 -5/1\n", 5, "there is no vertex '-5/1' above this line"},
             Broken{corners + "f 1 2 -0\n", 5, "there is no vertex '-0' above this line"},
             Broken{corners + "f 1 2 99999999999\n", 5, "there is no vertex '99999999999' above this line"},
             Broken{corners + "f 1 2 99999999999999999999\n", 5, "there is no vertex '99999999999999999999' above"},
             Broken{corners + "f 1 2 -9223372036854775808\n", 5, "there is no vertex '-9223372036854775808' above"},
             Broken{corners + "f 1 2 5\nv 1 1 1\n", 5, "there is no vertex '5' above this line"},
             Broken{"f 1 2 3\n" + corners, 1, "there is no vertex '1' above this line, expected 'v x y z' first"},
             Broken{corners + "f 1.5 2 3\n", 5, "'1.5'" + noCorner},
             Broken{corners + "f 1 2 3x\n", 5, "'3x'" + noCorner},
             Broken{corners + "f 1 2 x\n", 5, "'x'" + noCorner},
             Broken{corners + "f 1 2 /3\n", 5, "'/3'" + noCorner},
             Broken{corners + "f 1/2/3/4 2 3\n", 5, "'1/2/3/4'" + noCorner},
             Broken{corners + "f 1/a 2 3\n", 5, "'1/a'" + noCorner},
             Broken{corners + "f 1 2 +3\n", 5, "'+3'" + noCorner},
             Broken{corners + "f 1 2 3 4,\n", 5, "'4,'" + noCorner},
             Broken{corners + "f\n", 5, "a face of 0 corners, expected at least 3"},
             Broken{corners + "F 1 2 3\n", 5, "unknown keyword 'F', expected 'v', 'f' or another one of OBJ"},
             Broken{"hello world\n", 1, "unknown keyword 'hello'"},
             Broken{"solid cube\n", 1, "unknown keyword 'solid'"},
             Broken{"v1 2 3\n", 1, "unknown keyword 'v1'"},
             Broken{"\xFF\xFEv\x01\n", 1, "unknown keyword '\\xff\\xfev\\x01'"},
             Broken{std::string(100000, 'x'), 1, "unknown keyword 'xxx"},
             Broken{"v 0 0 " + std::string(100000, '1') + "x\n", 1, "...'" + noFinite},
         })
    {
        const auto message = errorFor(file("m.obj", text));
        const auto place = line == 0 ? " " : fmt::format("{}: ", line);
        EXPECT_EQ(message.substr(0, place.size()), place) << message << "\nfor: " << text.substr(0, 60);
        EXPECT_NE(message.find(words), message.npos) << message << "\nlacks: " << words;
        EXPECT_EQ(message.find('\n'), message.npos) << message;
        EXPECT_LT(message.size(), 250u);
    }
}

TEST_F(ObjFile, ThatCannotBeReadIsRefused)
{
    file("bunny.obj", cube);
    file("bunn.txt", "");
    EXPECT_EQ(errorFor(in("buny.obj")), " no such file, did you mean 'bunny.obj'?");
    EXPECT_EQ(errorFor(in("unlike.obj")), " no such file");
    EXPECT_EQ(errorFor(folder.string()), " this is a folder, expected an OBJ file (.obj)");
    ASSERT_EQ(mkfifo(in("pipe.obj").c_str(), 0600), 0);
    EXPECT_EQ(errorFor(in("pipe.obj")), " not a regular file, expected an OBJ file (.obj)");
    EXPECT_EQ(errorFor("/dev/zero"), " not a regular file, expected an OBJ file (.obj)");
    EXPECT_EQ(errorFor(file("z.obj", cube + std::string(1, '\0'))),
              fmt::format(" not a text file, byte {} is zero; expected an OBJ file (.obj), at most 256 MiB",
                          cube.size() + 1));
    fs::resize_file(file("large.obj", ""), largestSceneFile + 1); // sparse: takes no room
    EXPECT_EQ(errorFor(in("large.obj")), " too large, expected at most 256 MiB");
}

TEST_F(ObjFile, MeetsNoiseWithAMeshOrARuntimeError)
{
    const std::vector<std::string> tokens{"v ",   "f ", "/", "//", "-",   "\n",    "\r",
                                          "\\\n", "#",  " ", "0",  "nan", "1e999", "99999999999"};
    std::mt19937 random(20240118);
    int meshes = 0, errors = 0;
    for (int i = 0; i < 5000; ++i)
    {
        const auto text = mutated(cube, random, tokens, 3, 20);
        try
        {
            for (const auto& triangle : readObj(file("m.obj", text), warnings))
            {
                for (const auto& vertex : triangle) ASSERT_TRUE(isFinite(vertex)) << text;
                ASSERT_FALSE(isDegenerate(triangle)) << text;
            }
            ++meshes;
        }
        catch (const std::runtime_error& error)
        {
            const std::string message = error.what();
            ASSERT_TRUE(message.starts_with(in("m.obj") + ":")) << message;
            ASSERT_EQ(message.find('\n'), message.npos) << message;
            ++errors;
        }
        catch (...)
        {
            FAIL() << "not a runtime_error, for:\n" << text;
        }
    }
    EXPECT_GT(meshes, 500);
    EXPECT_GT(errors, 500);
}

// ---- meshes in a scene ---------------------------------------------------------------------------------------------

class MeshInAScene : public ObjFile
{
};

const std::string twoMaterials = "[materials.m]\ncolor = [1, 0, 0]\n[materials.n]\nior = 1.5\n";

TEST_F(MeshInAScene, IsFoundInTheScenesFolderAndNamesItsTriangles)
{
    fs::create_directories(folder / "meshes");
    file("meshes/cube.obj", cube);
    file("square.obj", corners + "f 1 2 3 4\n");
    const auto scene = loadScene(
        file("scene.toml", twoMaterials + "[[sphere]]\ncenter = [9, 0, 0]\nradius = 1\nmaterial = 'm'\n"
                                          "[[mesh]]\nfile = 'meshes/cube.obj'\nmaterial = 'n'\n"
                                          "[[triangle]]\nvertices = [[0, 0, 5], [1, 0, 5], [0, 1, 5]]\nmaterial = 'm'\n"
                                          "[[mesh]]\nfile = 'square.obj'\nmaterial = 'm'\n"));
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].file, "meshes/cube.obj");
    EXPECT_EQ(scene.meshes[0].material, 1);
    EXPECT_EQ(scene.meshes[0].triangles->size(), 12u);
    EXPECT_EQ(scene.meshes[1].material, 0);
    EXPECT_EQ(*scene.meshes[1].triangles, (Triangles{{a, b, c}, {a, c, d}}));
    EXPECT_TRUE(scene.warnings.empty());

    const Scene<double> traced(scene);
    EXPECT_EQ(traced.primitiveName(0), "sphere0");
    EXPECT_EQ(traced.primitiveName(1), "triangle0");
    EXPECT_EQ(traced.primitiveName(2), "mesh0.triangle0");
    EXPECT_EQ(traced.primitiveName(5), "mesh0.triangle3");
    EXPECT_EQ(traced.primitiveName(13), "mesh0.triangle11");
    EXPECT_EQ(traced.primitiveName(14), "mesh1.triangle0");
    EXPECT_EQ(traced.primitiveName(15), "mesh1.triangle1");

    // The second face of the cube is its front, z = 1; right of the diagonal lies its first half.
    const auto hit = traced.intersect({.O = {0.75, 0.25, 3}, .D = {0, 0, -1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(traced.primitiveName(hit->I.on), "mesh0.triangle2");
    EXPECT_EQ(hit->N, V(0, 0, 1));
    EXPECT_EQ(hit->n2, 1.5);
}

TEST_F(MeshInAScene, MeetsRaysAsTheSameTrianglesDo)
{
    std::mt19937 random(11);
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    std::string obj;
    for (int i = 0; i < 40; ++i)
    {
        const V middle(number(-3, 3), number(-3, 3), number(-3, 3));
        for (int k = 0; k < 3; ++k)
            obj += fmt::format("v {} {} {}\n", middle.x + number(-2, 2), middle.y + number(-2, 2),
                               middle.z + number(-2, 2));
        obj += "f -3 -2 -1\n";
    }
    file("m.obj", obj);
    const auto mesh = loadScene(file("mesh.toml", twoMaterials + "[[mesh]]\nfile = 'm.obj'\nmaterial = 'n'\n"));
    auto loose = mesh;
    loose.meshes.clear();
    for (const auto& triangle : *mesh.meshes[0].triangles) loose.triangles.push_back({triangle, 1});
    const Scene<double> one(mesh), other(parseScene(sceneToToml(loose), "loose.toml"));
    int hits = 0;
    for (int i = 0; i < 5000; ++i)
    {
        const V O(number(-5, 5), number(-5, 5), number(-5, 5)),
            D = unit(V(number(-1, 1), number(-1, 1), number(-1, 1)));
        const auto p = one.intersect({.O = O, .D = D}), q = other.intersect({.O = O, .D = D});
        ASSERT_EQ(p.has_value(), q.has_value());
        EXPECT_EQ(one.occluded({O, noPrimitive}, D, 4), other.occluded({O, noPrimitive}, D, 4));
        if (!p) continue;
        ++hits;
        EXPECT_EQ(p->t, q->t);
        EXPECT_EQ(V(p->I), V(q->I));
        EXPECT_EQ(p->N, q->N);
        EXPECT_EQ(p->mat.name, q->mat.name);
        EXPECT_EQ(one.primitiveName(p->I.on), "mesh0." + other.primitiveName(q->I.on));
    }
    EXPECT_GT(hits, 500);
}

TEST_F(MeshInAScene, TellsItsErrorsAtTheKey)
{
    const auto errorOf = [&](const std::string& obj) {
        file("bunny.obj", obj);
        try
        {
            loadScene(file("scene.toml", twoMaterials + "[[mesh]]\nmaterial = 'm'\n  file = 'bunny.obj'\n"));
            return std::string("no error");
        }
        catch (const SceneError& error)
        {
            return std::string(error.what());
        }
    };
    const std::string place = in("scene.toml") + ":7:10: " + in("bunny.obj");
    EXPECT_EQ(errorOf(corners + "f 1 2 x\n"),
              place + ":5: 'x' is not a corner, expected a vertex's number, as in 7, 7/1, 7//2 or 7/1/2");
    EXPECT_EQ(errorOf(""), place + ": the file is empty, expected at least one line such as 'f 1 2 3'");
    EXPECT_EQ(errorOf(cube), "no error");
}

TEST_F(MeshInAScene, TellsItsWarningsAtTheKey)
{
    file("m.obj", corners + "f 1 2 3\nf 1 2 2 1\n");
    const auto scene = loadScene(file("scene.toml", twoMaterials + "[[mesh]]\nfile = 'm.obj'\nmaterial = 'm'\n"));
    EXPECT_EQ(scene.meshes.at(0).triangles->size(), 1u);
    EXPECT_EQ(scene.warnings,
              std::vector{fmt::format("{}:6:8: {}:6: 2 triangles have no area and are left out, the first of them here",
                                      in("scene.toml"), in("m.obj"))});
}

} // namespace

} // namespace rt
