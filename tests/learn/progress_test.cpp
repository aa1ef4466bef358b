#include "tests/learn/progress.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "common/files/text_file.h"
#include "tests/grade/box/temporary_folder.h"

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

struct ProgressFile : testing::Test
{
    TemporaryFolder folder;
    std::string path = folder.path + "/state.json", notice;
};

TEST_F(ProgressFile, ComesBackAsItWasSaved)
{
    saveProgress(path, {"02-reflect", {{"01-sphere", Standing::right}, {"02-reflect", Standing::wrong}}});
    const auto progress = loadProgress(path, notice);
    EXPECT_EQ(notice, "");
    EXPECT_EQ(progress.current, "02-reflect");
    EXPECT_EQ(progress.of("01-sphere"), Standing::right);
    EXPECT_EQ(progress.of("02-reflect"), Standing::wrong);
    EXPECT_EQ(progress.of("08-phong"), Standing::notAttempted);
    EXPECT_EQ(progress.exercises.size(), 2U);
}

TEST_F(ProgressFile, NeedNotExist)
{
    EXPECT_TRUE(loadProgress(path, notice).exercises.empty());
    EXPECT_EQ(notice, "");
}

TEST_F(ProgressFile, ThatIsBrokenIsKeptBesideAndProgressStartsAfresh)
{
    for (const std::string text : {"", "{", "[]", "{\"version\": 2, \"current\": \"\", \"exercises\": {}}",
                                   "{\"version\": 1, \"current\": \"\", \"exercises\": {\"01-sphere\": \"perfect\"}}",
                                   "{\"version\": 1, \"current\": 7, \"exercises\": {}}"})
    {
        writeTextFile(path, text);
        notice.clear();
        EXPECT_TRUE(loadProgress(path, notice).exercises.empty()) << text;
        EXPECT_NE(notice.find(path + ".broken"), std::string::npos) << text << ": " << notice;
        EXPECT_FALSE(fs::exists(path)) << text;
        EXPECT_EQ(fs::file_size(path + ".broken"), text.size());
    }
}

} // namespace

} // namespace rt::grade
