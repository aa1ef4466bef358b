#include <gtest/gtest.h>

#include "common/program/program.h"
#include "lessons/programs/registry.h"
#include "viz/state/listing.h"
#include "viz/state/node_text.h"

namespace rt::viz
{

namespace
{

std::string textOf(const CodeRow& row)
{
    std::string text(row.column, ' ');
    for (const auto& piece : row.pieces) text += piece.text;
    return text;
}

std::vector<std::string> texts(const std::vector<CodeRow>& rows)
{
    std::vector<std::string> all;
    for (const auto& row : rows) all.push_back(textOf(row));
    return all;
}

std::string withoutBlanks(std::string text)
{
    std::erase(text, ' ');
    return text;
}

TEST(CodeRows, BreakLongLinesAndGoOnFurtherIn)
{
    const auto rows = codeRows(listingOf("    aa bb cc dd ee ff gg hh\nx\n"), 20);
    EXPECT_EQ(texts(rows), (std::vector<std::string>{"    aa bb cc dd ee", "          ff gg hh", "x"}));
    EXPECT_EQ(rows[0].line, 1);
    EXPECT_FALSE(rows[0].isContinued);
    EXPECT_EQ(rows[1].line, 1);
    EXPECT_TRUE(rows[1].isContinued);
    EXPECT_EQ(rows[2].line, 2);
}

TEST(CodeRows, BreakWhatHasNoBlanks)
{
    const auto rows = codeRows(listingOf(std::string(50, 'x') + "\n" + std::string(60, ' ') + "θθ"), 16);
    std::string all;
    for (const auto& row : rows)
    {
        EXPECT_LE(characters(textOf(row)), 16U);
        all += withoutBlanks(textOf(row));
    }
    EXPECT_EQ(all, std::string(50, 'x') + "θθ");
}

TEST(CodeRows, HideMarksOfExercisesAndKeepTheNumbersOfTheFile)
{
    const auto rows = codeRows(
        listingOf("a;\n// SOLUTION 01-x\nb;\n    // END\n// EXERCISE: c\n// EXERCISE-FROM d\ne; // END\n// ENDING\n"),
        40);
    EXPECT_EQ(texts(rows), (std::vector<std::string>{"a;", "b;", "e; // END", "// ENDING"}));
    EXPECT_EQ(rows[1].line, 3);
    EXPECT_EQ(rows[2].line, 7);
}

TEST(CodeRows, ShowEachLessonsWholeTextInAnyWidth)
{
    for (const auto* lesson : lessons())
    {
        const auto listing = readListing(lesson->source, projectFile(""));
        std::string expected;
        for (const auto& line : listing.lines)
            if (!isExerciseMark(line)) expected += withoutBlanks(line);
        for (const std::size_t columns : {16U, 40U, 70U, 200U})
        {
            const auto rows = codeRows(listing, columns, 4);
            std::string all;
            for (const auto& row : rows)
            {
                ASSERT_LE(characters(textOf(row)), columns) << textOf(row);
                ASSERT_EQ(textOf(row).find("// SOLUTION"), std::string::npos);
                ASSERT_EQ(textOf(row).find("// EXERCISE"), std::string::npos);
                all += withoutBlanks(textOf(row));
            }
            EXPECT_EQ(all, expected) << lesson->source << ", " << columns << " columns";
        }
    }
}

constexpr const char* longCode = R"(int a;
int b;

// SOLUTION x
int f()
{
    one;
    two which is a very long line in three rows
    three;
}
int c;
)";

TEST(CodeRows, AreShownWithTheWholeFunctionWhereItFits)
{
    const auto listing = listingOf(longCode);
    const auto rows = codeRows(listing, 20);
    ASSERT_EQ(rows.size(), 13U);
    const auto function = functionAround(listing, 8);
    EXPECT_EQ(firstShown(rows, function, 8, 9), 3);
    EXPECT_EQ(firstShown(rows, function, 8, 11), 2);
    for (int count = 1; count < 20; ++count)
        for (int line = 1; line <= int(listing.lines.size()); ++line)
        {
            const int first = firstShown(rows, functionAround(listing, line), line, count);
            EXPECT_GE(first, 0);
            EXPECT_LE(first, std::max(0, int(rows.size()) - count));
            bool isSeen = isExerciseMark(listing.lines[std::size_t(line) - 1]);
            int seen = 0, has = 0;
            for (int i = 0; i < int(rows.size()); ++i)
                if (rows[std::size_t(i)].line == line)
                {
                    ++has;
                    if (i >= first && i < first + count) ++seen;
                }
            if (seen > 0) isSeen = true;
            EXPECT_TRUE(isSeen) << line << " in " << count;
            EXPECT_GE(seen, std::min(has, count)) << line << " in " << count;
        }
    for (const int line : {-7, 0, 5000}) EXPECT_GE(firstShown(rows, {}, line, 5), 0);
}

TEST(CodeRows, AreShownWithTheOtherLineWhereItFits)
{
    std::string text = "int f()\n{\n";
    for (int i = 0; i < 60; ++i) text += "    x;\n";
    const auto listing = listingOf(text + "}\n");
    const auto rows = codeRows(listing, 40);
    const auto function = functionAround(listing, 20);
    const int first = firstShown(rows, function, 20, 16, 33);
    EXPECT_LE(first + 1, 19);
    EXPECT_GE(first + 1 + 16, 35);
    EXPECT_EQ(firstShown(rows, function, 20, 10, 33), firstShown(rows, function, 20, 10));
}

} // namespace

} // namespace rt::viz
