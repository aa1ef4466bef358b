#include "tests/grade/box/compile.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tests/grade/box/child.h"
#include "tests/grade/box/compiler_messages.h"
#include "tests/grade/box/machine.h"
#include "tests/grade/box/source_text.h"
#include "tests/grade/box/temporary_folder.h"
#include "tests/grade/questions/manifest.h"

namespace rt::grade
{

namespace
{

std::string exerciseOf(int lesson)
{
    for (const auto& folder : std::filesystem::directory_iterator(RAYTREE_SOURCE_DIR "/lessons"))
        if (folder.path().filename().string().rfind(fmt::format("{:02}_", lesson), 0) == 0)
        {
            std::ostringstream text;
            text << std::ifstream(folder.path() / "exercise.h").rdbuf();
            return text.str();
        }
    throw std::runtime_error("no such lesson");
}

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    const auto place = text.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    return place == std::string::npos ? text : text.replace(place, what.size(), with);
}

class Compiling : public testing::Test
{
protected:
    TemporaryFolder folder;

    void SetUp() override
    {
        if (!noBubblewrap().empty()) GTEST_SKIP() << noBubblewrap();
    }

    Compiled compiled(int lesson, const std::string& text, Sandbox sandbox = Sandbox::bubblewrap)
    {
        return compileSubmission({sandbox, 3}, lesson, text, folder.path);
    }
};

std::string all(const Compiled& result)
{
    std::string text = result.reason;
    for (const auto& error : result.errors) text += "\n" + error;
    return text;
}

} // namespace

TEST_F(Compiling, MakesAProgramOfEachExercise)
{
    for (const int lesson : exerciseLessons())
    {
        const auto result = compiled(lesson, exerciseOf(lesson));
        ASSERT_TRUE(result.ok) << lesson << ": " << all(result);
        EXPECT_GT(result.cpuSeconds, 0.01);
        EXPECT_TRUE(result.remarks.empty());
        Child child({Sandbox::bubblewrap, 3}, result.program, {});
        EXPECT_EQ(child.finish().exitCode, 0) << "no questions are no fault";
    }
}

TEST_F(Compiling, WorksInEverySandbox)
{
    for (const auto sandbox : sandboxesHere())
    {
        const auto result = compiled(6, exerciseOf(6), sandbox);
        EXPECT_TRUE(result.ok) << name(sandbox) << ": " << all(result);
        const auto broken = compiled(6, replaced(exerciseOf(6), "const auto hit", "const auto hot"), sandbox);
        EXPECT_FALSE(broken.ok);
        ASSERT_FALSE(broken.errors.empty());
        EXPECT_EQ(broken.errors[0].rfind("exercise.h:", 0), 0U) << all(broken);
        EXPECT_EQ(all(broken).find("/tmp/"), std::string::npos) << all(broken);
    }
}

TEST_F(Compiling, TellsErrorsWithoutOurPaths)
{
    const auto result = compiled(6, replaced(exerciseOf(6), "const auto hit", "const auto hot"));
    EXPECT_FALSE(result.ok);
    EXPECT_EQ(result.reason, "exercise.h does not compile");
    ASSERT_FALSE(result.errors.empty());
    EXPECT_EQ(result.errors[0].rfind("exercise.h:35:22", 0), 0U) << all(result);
    EXPECT_NE(result.errors[0].find("error: 'hit' was not declared"), std::string::npos) << all(result);
    EXPECT_EQ(all(result).find("/kit"), std::string::npos) << all(result);
    EXPECT_EQ(all(result).find("/source"), std::string::npos) << all(result);
}

TEST_F(Compiling, TellsInWordsWhatIsMissing)
{
    EXPECT_EQ(compiled(6, "#pragma once\n").reason, "exercise.h has no namespace rt::exercise06");
    EXPECT_EQ(compiled(6, replaced(exerciseOf(6), "struct Tracer", "struct MyTracer")).reason,
              "exercise.h defines no struct Tracer in namespace rt::exercise06");
    auto renamed = exerciseOf(0);
    renamed = replaced(renamed, "struct Geometry", "struct MyGeometry");
    EXPECT_EQ(compiled(0, renamed).reason, "exercise.h defines no struct Geometry in namespace rt::exercise00");
    const auto main = compiled(6, exerciseOf(6) + "\nint main() { return 0; }\n");
    EXPECT_EQ(main.reason, "exercise.h defines main, which is ours") << all(main);
    const auto nowhere = compiled(6, exerciseOf(6) + "\nint nowhere();\nstatic const int used = nowhere();\n");
    EXPECT_EQ(nowhere.reason, "nowhere() is declared, but defined nowhere") << all(nowhere);
}

TEST_F(Compiling, StopsWhatExhaustsTheCompiler)
{
    const auto deep = compiled(6, exerciseOf(6) + "\ntemplate <int n> struct Deep { Deep<n + 1> d; }; Deep<0> deep;\n");
    EXPECT_EQ(deep.reason, "templates in exercise.h are nested too deeply") << all(deep);
    const auto wide = compiled(6, exerciseOf(6) + "\nconstexpr int spin() { int n = 0; for (;;) ++n; return n; }"
                                                  "\nconstexpr int spun = spin();\n");
    EXPECT_EQ(wide.reason, "exercise.h makes the compiler compute too long") << all(wide);
    const auto itself = compiled(6, "#include \"exercise.h\"\n");
    EXPECT_FALSE(itself.ok);
}

TEST_F(Compiling, SeesNoFilesOfTheGrader)
{
    for (const char* path :
         {"/etc/passwd", "/etc/hostname", "/proc/self/environ", "/dev/stdin", RAYTREE_SOURCE_DIR "/README.md",
          RAYTREE_SOURCE_DIR "/lessons/06_fresnel/trace.h", "lessons/06_fresnel/trace.h"})
    {
        const auto result = compiled(6, fmt::format("#include \"{}\"\n", path) + exerciseOf(6));
        EXPECT_FALSE(result.ok) << path;
        EXPECT_NE(all(result).find("No such file"), std::string::npos) << path << ": " << all(result);
        const auto inside = compiled(6, exerciseOf(6) + fmt::format("\nasm(\".incbin \\\"{}\\\"\");\n", path));
        EXPECT_FALSE(inside.ok) << path;
    }
}

TEST_F(Compiling, HasNoReferenceOfWhatIsGraded)
{
    // A static constructor calls it. What is not there, throws, and nobody catches; or finds nothing.
    const std::string sphere = "Shapes<double>::intersectSphere({{0, 0, 0}, {0, 0, -1}}, {{0, 0, -5}, 1})",
                      plane = "Shapes<double>::intersectPlane({{0, 1, 0}, {0, -1, 0}}, {})",
                      latLong = "SkyFormulas<double>::latLong({0, 0, 1})[0] >= 0";
    const auto endOf = [&](int lesson, const std::string& called) {
        const auto result = compiled(lesson, exerciseOf(lesson) + "\nstatic const int stolen = rt::" + called +
                                                 " ? (throw 1, 1) : 0;\n");
        EXPECT_TRUE(result.ok) << all(result);
        if (!result.ok) return std::string("not compiled");
        Child child({Sandbox::bubblewrap, 3}, result.program, {});
        child.finish();
        return child.finish().sentence;
    };
    const std::string found = "it crashed (nobody caught an exception of type int)",
                      isNotThere = "it crashed (nobody caught an exception of type rt::NotAttempted)";
    EXPECT_EQ(endOf(1, sphere), "");
    EXPECT_EQ(endOf(1, plane), "");
    EXPECT_EQ(endOf(1, latLong), isNotThere);
    EXPECT_EQ(endOf(4, latLong), isNotThere);
    // Where they are not graded, they are there.
    EXPECT_EQ(endOf(6, sphere), found);
    EXPECT_EQ(endOf(6, plane), found);
    EXPECT_EQ(endOf(6, latLong), found);
}

TEST_F(Compiling, RemarksThatGlmIsUsed)
{
    const auto result = compiled(6, replaced(exerciseOf(6), "todo(\"06-split\");", "(void)glm::reflect(ray.D, N);"));
    EXPECT_TRUE(result.ok) << all(result);
    EXPECT_EQ(result.remarks, std::vector<std::string>{"glm::reflect is used"});
}

/// The tricks by which a file could get into a program while it is compiled, each of which must fail for this path.
void expectUnread(Sandbox sandbox, const std::string& path)
{
    const TemporaryFolder folder;
    const auto compiled = [&](const std::string& more) {
        return compileSubmission({sandbox, 3}, 6, exerciseOf(6) + "\n" + more + "\n", folder.path);
    };
    for (const std::string trick :
         {"#include \"{}\"", "asm(\".incbin \\\"{}\\\"\");", "asm(\".include \\\"{}\\\"\");",
          "__attribute__((section(\".text,\\\"ax\\\",@progbits\\n.incbin \\\"{}\\\"\\n#\"))) void hidden() {{}}",
          "#if !__has_include(\"{}\")\n#error it is not there\n#endif"})
    {
        const auto result = compiled(fmt::format(fmt::runtime(trick), path));
        EXPECT_FALSE(result.ok) << name(sandbox) << ": " << trick << " reads " << path;
        EXPECT_EQ(all(result).find("root:"), std::string::npos) << all(result);
    }
}

TEST_F(Compiling, ReadsNoFileButTheKits)
{
    expectUnread(Sandbox::bubblewrap, "/etc/passwd");
}

TEST(CompilingInAnEmptyRoot, ReadsNoFileButTheKits)
{
    if (!isRoot()) return;        // others get no such root
    const TemporaryFolder others; // another student's file, that others may read
    std::ofstream(others.path + "/exercise.h") << "static const int mine = 1;\n";
    for (const auto& path : {std::string("/etc/passwd"), std::string(RAYTREE_SOURCE_DIR "/lessons/06_fresnel/trace.h"),
                             others.path + "/exercise.h"})
        expectUnread(Sandbox::chroot, path);
    // What needs no file is fine, as it is in the other sandboxes.
    const auto odd = compileSubmission({Sandbox::chroot, 3}, 6,
                                       "#pragma GCC diagnostic push\n#include <regex>\n#include <thread>\n" +
                                           exerciseOf(6) + "\n#define JOINED(a, b) a##b\nint JOINED(to, gether) = 1;\n",
                                       others.path);
    EXPECT_TRUE(odd.ok) << all(odd);
}

TEST(SourceText, KnowsCommentsAndLiterals)
{
    EXPECT_EQ(codeOnly("a // b\nc"), "a     \nc");
    EXPECT_EQ(codeOnly("a /* b\n */ c"), "a     \n    c");
    EXPECT_EQ(codeOnly("x = \"a\\\"//b\"; y"), "x = \"      \"; y");
    EXPECT_EQ(codeOnly("1'000 /*x*/ 2'000"), "1'000       2'000");
    EXPECT_EQ(codeOnly("R\"q(a)\" // )q\" b"), "R\"           \" b");
    EXPECT_EQ(codeOnly("// a\\\nb\nc"), "     \nc");
}

TEST(SourceText, RemarksOnCodeOnly)
{
    EXPECT_TRUE(remarksOn("// glm::reflect\nreflect(a)").empty());
    EXPECT_EQ(remarksOn("namespace g = glm; g :: refract(a)"), std::vector<std::string>{"glm::refract is used"});
    EXPECT_EQ(remarksOn("using glm::reflect;"), std::vector<std::string>{"glm::reflect is used"});
    EXPECT_EQ(remarksOn("b = !scene.occluded(I, L, dist);", 1).size(), 1U);
    EXPECT_TRUE(remarksOn("b = !scene.occluded(I, L, dist, *this);", 1).empty());
    EXPECT_TRUE(remarksOn("b = !scene.occluded(I, L, dist);", 2).empty());
}

TEST(SourceText, TellsWhereCodeStandsBesideATodo)
{
    const auto out = exerciseOf(6);
    const std::string todo = "todo(\"06-schlick\");";
    EXPECT_EQ(todosLeft(out, out), std::vector<std::string>{});
    EXPECT_EQ(todosLeft(replaced(out, todo, "// mine\n\t" + todo + " /* how? */"), out), std::vector<std::string>{});
    for (const std::string& with : {"return 0;" + todo, todo + "\n        return 0;", "Real a = 1; { " + todo + " }"})
        EXPECT_EQ(todosLeft(replaced(out, todo, with), out), std::vector<std::string>{"06-schlick"}) << with;
    EXPECT_EQ(todosLeft(replaced(out, todo, "return 0; // " + todo), out), std::vector<std::string>{});
}

TEST(SourceText, NothingInATextExhaustsUs)
{
    constexpr std::size_t most = 250'000;
    for (const auto& text :
         {"namespace g =" + std::string(most, ' ') + "glm", "namespace " + std::string(most, 'g') + " = glm;",
          "# include" + std::string(most, ' ') + "\"x\"", "glm" + std::string(most, '\n') + "::reflect",
          "#" + std::string(most, 'a'), std::string(most, '#')})
    {
        EXPECT_LE(remarksOn(text).size(), 1U);
        EXPECT_EQ(reasonIn(text, 6), "exercise.h does not compile");
    }
}

} // namespace rt::grade
