// What no installed font has is seen as "□" and not left out in silence.
#include "viz/window/fonts.h"

#include <gtest/gtest.h>

namespace rt::viz
{

namespace
{

std::string shown(const std::string& text)
{
    std::string all;
    for (const auto& run : fontRuns(text, Font::sans)) all += run.text;
    return all;
}

TEST(Fonts, ShowWhatTheyHave)
{
    EXPECT_EQ(shown("n1 sin θ₁ = n2 sin θ₂"), "n1 sin θ₁ = n2 sin θ₂");
    EXPECT_EQ(fontRuns("Größe", Font::sans), (std::vector<FontRun>{{-1, "Größe"}}));
    EXPECT_TRUE(fontRuns("", Font::sans).empty());
}

TEST(Fonts, LeaveNothingOutInSilence)
{
    // A sign of the private use area, which no font of these packages has.
    EXPECT_EQ(shown("a\xF4\x8F\xBF\xBD"
                    "b"),
              "a□b");
    for (const std::string sign : {"球", "Ж", "😀"})
    {
        const auto got = shown("x" + sign + "y");
        EXPECT_TRUE(got == "x" + sign + "y" || got == "x□y") << got;
    }
    // Blanks, and what has no ink by nature, are no signs.
    EXPECT_EQ(shown("a\u00A0b\u200Dc\uFE0F"), "a\u00A0bc");
}

TEST(Fonts, SurviveTextThatIsCutWithinASign)
{
    EXPECT_EQ(shown("ab\xE7\x90"), "ab□");
    EXPECT_EQ(shown("\x90\x90 c"), "□ c");
}

} // namespace

} // namespace rt::viz
