#include "common/program/cli.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "common/files/picture_module.h"

namespace rt
{

namespace
{

TEST(RunMain, HasACodeOfItsOwnForWhatNeedsOpenImageIO)
{
    CommandLine app("a program", "program");
    unsetenv("RAYTREE_DOOR");
    char name[] = "program";
    char* argv[] = {name, nullptr};
    testing::internal::CaptureStderr();
    const int code = runMain(app, 1, argv, []() -> int { throw NeedsOpenImageIO("sky.hdr"); });
    EXPECT_TRUE(testing::internal::GetCapturedStderr().starts_with("sky.hdr: "));
    EXPECT_EQ(code, exitNeedsOpenImageIO);
    // What reads a scene makes a mistake in the scene of every runtime_error.
    static_assert(!std::is_base_of_v<std::runtime_error, NeedsOpenImageIO>);
}

/// What a command line makes of these words.
struct Words
{
    std::string out, kind = "one";
    std::vector<std::string> many;
    int number = 3;
    double share = 0.5;
    bool loud = false;

    void parse(std::vector<const char*> words)
    {
        CommandLine line("a program", "program");
        line.option("out", out, "a folder").required();
        line.option("many", many, "files");
        line.option("--number", number, "a number").range(1, 9);
        const auto ours = line.option("--share", share, "a share").range(0.0, 1.0);
        line.option("--kind", kind, "a kind").oneOf({"one", "two"}).excludes(ours);
        line.flag("--loud", loud, "louder");
        words.insert(words.begin(), "program");
        line.parse(int(words.size()), words.data());
    }
};

TEST(CommandLine, SetsWhatItIsGiven)
{
    Words words;
    words.parse({"marks", "a", "--number", "+7", "b", "--kind=two", "--loud", "c"});
    EXPECT_EQ(words.out, "marks");
    EXPECT_EQ(words.many, (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(words.number, 7);
    EXPECT_EQ(words.kind, "two");
    EXPECT_TRUE(words.loud);
    EXPECT_EQ(words.share, 0.5);
}

TEST(CommandLine, RefusesWhatMakesNoSense)
{
    EXPECT_THROW(Words().parse({}), UsageError);
    for (const std::vector<const char*>& wrong :
         std::vector<std::vector<const char*>>{{"--number", "0"},
                                               {"--number", "10"},
                                               {"--number", "3x"},
                                               {"--number", "1e9"},
                                               {"--share", "nan"},
                                               {"--share", "1.01"},
                                               {"--kind", "three"},
                                               {"--kind", "two", "--share", "1"},
                                               {"--quiet"}})
    {
        auto words = wrong;
        words.insert(words.begin(), "marks");
        EXPECT_THROW(Words().parse(words), UsageError) << wrong.back();
    }
}

} // namespace

} // namespace rt
