#include "tests/grade/report/text.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/grade/report/sample_results.h"

namespace rt::grade
{

TEST(CleanText, KeepsWhatIsHarmless)
{
    for (const std::string text : {"", "a\n\tb", "Zoë & Søren <x>", "\xe0\xa4\x95\xe2\x80\x8d", "\xf0\x9f\x98\x80"})
        EXPECT_EQ(cleanText(text), text);
}

TEST(CleanText, RepairsUtf8)
{
    EXPECT_EQ(cleanText("a\xff"
                        "b"),
              "a\xef\xbf\xbd"
              "b");
    EXPECT_EQ(cleanText("caf\xe9"), "caf\xef\xbf\xbd");
    EXPECT_EQ(cleanText("\xc0\xaf").find('/'), std::string::npos) << "an overlong slash is none";
}

TEST(CleanText, RemovesControlCharactersAndTerminalSequences)
{
    EXPECT_EQ(cleanText(std::string("a\0b\x07\x7f\xc2\x9b", 7)), "ab");
    EXPECT_EQ(cleanText("\x1b[1;31mred\x1b[0m, \x1b]0;title\x07text, \x1b]8;;http://x\x1b\\link\x1b]8;;\x1b\\"),
              "red, text, link");
    EXPECT_EQ(cleanText("\x1b]0;never ends\nnext"), "0;never ends\nnext");
    EXPECT_EQ(cleanText("end\x1b"), "end");
    EXPECT_EQ(cleanText("end\x1b["), "end");
}

TEST(CleanText, RemovesWhatTurnsTextAroundOrIsNotSeen)
{
    EXPECT_EQ(cleanText("a\u202eb\u2066c\u200fd\ufeffe\u200bf\U000e0041"), "abcdef");
}

TEST(CleanText, MakesAllEndsOfLinesTheSame)
{
    EXPECT_EQ(cleanText("a\r\nb\rc\u2028d"), "a\nb\nc\nd");
    EXPECT_EQ(cleanLine("a\r\nb\tc\n"), "a b c ");
}

TEST(CleanText, CutsWithANote)
{
    const auto text = cleanText(std::string(1 << 20, 'x'));
    EXPECT_LE(text.size(), textLimit);
    EXPECT_GT(text.size(), textLimit - 100);
    EXPECT_NE(text.find("\n[cut here, of 1048576 bytes]"), std::string::npos);
    EXPECT_EQ(cleanText(std::string(textLimit, 'x')).size(), textLimit);
}

TEST(CleanText, IsHarmlessAndTheSameAgain)
{
    EXPECT_TRUE(rc::check("whatever the bytes are", [](const std::string& bytes, unsigned char limit) {
        const auto text = cleanText(bytes, 80U + limit), line = cleanLine(bytes);
        RC_ASSERT(text.size() <= 80U + limit);
        RC_ASSERT(cleanText(text, 80U + limit) == text);
        RC_ASSERT(cleanLine(line) == line);
        RC_ASSERT(repaired(text) == text);
        for (const char c : text) RC_ASSERT(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t');
        RC_ASSERT(line.find_first_of("\n\t") == std::string::npos);
    }));
    const auto text = cleanText(samples::hostileText());
    EXPECT_EQ(cleanText(text), text);
}

TEST(PageName, IsThePlainNameWhereItCan)
{
    EXPECT_EQ(pageName("ada-lovelace_42.b"), "ada-lovelace_42.b");
    EXPECT_EQ(pageName("Jürgen"), "Jürgen");
    EXPECT_EQ(pageName("../x"), "=2E.=2Fx");
    EXPECT_EQ(pageName("a b"), "a=20b");
    EXPECT_EQ(pageName(""), "=");
    EXPECT_EQ(pageName("\u202etxt"), "=E2=80=AEtxt");
}

TEST(PageName, IsOneOfItsOwnForEachStudent)
{
    EXPECT_TRUE(rc::check("whatever the names are", [] {
        // Few letters, so that names are often nearly the same.
        const auto name =
            rc::gen::container<std::string>(rc::gen::element('a', '=', '2', 'F', '/', '.', '\xc3', '\xbc', '\xff'));
        const auto a = *name, b = *name;
        RC_ASSERT((pageName(a) == pageName(b)) == (a == b));
        const auto page = pageName(a);
        RC_ASSERT(page.size() <= 200U && !page.empty() && page[0] != '.' && page.find('/') == page.npos);
        RC_ASSERT(repaired(page) == page);
    }));
    const std::string longName(300, 'x');
    EXPECT_LE(pageName(longName).size(), 200U);
    EXPECT_NE(pageName(longName), pageName(longName + "x"));
}

} // namespace rt::grade
