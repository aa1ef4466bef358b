// Known mistakes by name, also from a stored file.
#include "tests/grade/questions/known_mistakes.h"

#include <gtest/gtest.h>

#include "common/files/text_file.h"
#include "tests/grade/questions/manifest.h"

namespace rt::grade
{

namespace
{

TEST(Mistakes, AreFoundFromTheStoredFileAlone)
{
    for (const int lesson : exerciseLessons())
    {
        const auto known = mistakesFromJson(mistakesJson(lesson));
        int found = 0, all = 0;
        for (const auto& mutant : mutantCandidates(lesson))
        {
            if (mutant.endless) continue;
            ++all;
            found += !likelyMistakes(ownCasesAnswers(mutant.candidate, lesson), known).empty();
        }
        // A mistake that fails in one or two of the lesson's own checks, with round numbers, is not named from these alone.
        EXPECT_GE(found, all / 2) << "lesson " << lesson << ": " << found << " of " << all;
    }
}

std::string named(const Evidence& evidence, const std::vector<KnownMistake>& known)
{
    const auto sentences = likelyMistakes({{{"e", evidence}}, {}}, known);
    return sentences.empty() ? "" : sentences.begin()->second;
}

TEST(Mistakes, AreNotNamedOnThinEvidence)
{
    const Evidence evidence{{"q1", "1"}, {"q2", "2"}, {"q3", "(3, nan)"}, {"q4", "inf"}};
    const std::vector<KnownMistake> known{{"a", "this", {{"e", evidence}}}};
    EXPECT_EQ(named({{"q1", "1"}, {"q2", "2.000001"}, {"q3", "(3, -nan)"}, {"q4", "inf"}}, known), "this");
    EXPECT_EQ(named({{"q1", "1"}, {"q2", "2"}}, known), "") << "only half of what it would fail";
    EXPECT_EQ(named({{"q1", "1"}, {"q2", "2"}, {"q3", "(3, nan)"}, {"q4", "5"}}, known), "") << "another number";
    EXPECT_EQ(named({{"q1", "1"}, {"q2", "2.001"}, {"q3", "(3, nan)"}, {"q4", "inf"}}, known), "") << "another number";
    EXPECT_EQ(named({{"q1", "1"}, {"q2", "2"}, {"q3", "(3, nan)"}, {"q4", "inf"}, {"q5", "5"}}, known), "")
        << "more is wrong";
    EXPECT_EQ(named({{"q1", "1"}}, {{"a", "this", {{"e", {{"q1", "1"}}}}}}), "") << "one wrong answer";
    const Evidence odd{{"q1", "Fr at 40 degrees: 0.0406728807"}};
    EXPECT_EQ(named({{"q1", "Fr at 40 degrees: 0.0406728"}}, {{"a", "this", {{"e", odd}}}}), "this") << "by chance?";
    EXPECT_EQ(named({{"q1", "Fr at 40 degrees: 0.0406728"}, {"q2", "1"}}, {{"a", "this", {{"e", odd}}}}), "");
    const Evidence round{{"q1", "at 12345 degrees: (0.25, 1000, 0)"}};
    EXPECT_EQ(named(round, {{"a", "this", {{"e", round}}}}), "") << "the digits are the question's";
    EXPECT_EQ(named(evidence, {{"a", "this", {{"e", evidence}, {"f", {{"q", "1"}}}}}}), "") << "f would fail too";
    EXPECT_EQ(
        likelyMistakes({{{"e", evidence}}, {"f"}}, {{"a", "this", {{"e", evidence}, {"f", {{"q", "1"}}}}}}).size(), 1u)
        << "f is not written yet";
    EXPECT_EQ(likelyMistakes({{{"e", evidence}}, {"e"}}, known).size(), 0u) << "e asks what is not written yet";
}

TEST(Mistakes, OfTwoThatExplainAnExerciseTheOneThatExplainsMoreIsNamed)
{
    const Evidence evidence{{"q1", "1"}, {"q2", "2"}, {"q3", "3"}};
    const std::vector<KnownMistake> known{{"a", "little", {{"e", evidence}}},
                                          {"b", "all", {{"e", evidence}, {"f", evidence}}}};
    EXPECT_EQ(likelyMistakes({{{"e", evidence}, {"f", evidence}}, {}}, known),
              (std::map<std::string, std::string>{{"e", "all"}, {"f", "all"}}));
    EXPECT_EQ(likelyMistakes({{{"e", evidence}}, {}}, known), (std::map<std::string, std::string>{{"e", "little"}}));
}

TEST(Mistakes, AreStoredAsTheyAnswer)
{
    for (const int lesson : exerciseLessons())
    {
        const auto stored = fmt::format("tests/grade/mistakes/{:02}.json", lesson);
        EXPECT_TRUE(readTextFile(std::string(RAYTREE_SOURCE_DIR) + "/" + stored) == mistakesJson(lesson))
            << stored << " is not what known mistakes answer; to write it anew: grade_mistakes tests/grade/mistakes";
    }
}

TEST(Mistakes, InABrokenFileAreRefusedWithOneSentence)
{
    for (const char* text :
         {"", "{", "[]", R"({"version": 2, "mistakes": []})", R"({"version": 1, "mistakes": [{"id": 1}]})"})
    {
        try
        {
            mistakesFromJson(text);
            FAIL() << text;
        }
        catch (const std::runtime_error& error)
        {
            EXPECT_TRUE(std::string(error.what()).starts_with("the file of known mistakes cannot be read: "))
                << error.what();
        }
    }
}

std::string refusal(const std::string& text)
{
    try
    {
        parseManifest(text, "x.toml");
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "";
}

TEST(Manifest, IsRefusedWithAPlaceAndAReason)
{
    const std::string good =
        "[[exercise]]\nid = \"05-k\"\nlesson = 5\npoints = 2\ntitle = \"t\"\nslide = \"s\"\nhint = \"h\"\n";
    EXPECT_EQ(refusal(good + "cases = [\"K\"]\n"), "");
    EXPECT_TRUE(refusal(good).starts_with("x.toml:1:1: an exercise without `cases`")) << refusal(good);
    EXPECT_EQ(refusal(good + "cases = []\n"), "x.toml:8:9: `cases` is not a list, expected at least one text");
    EXPECT_EQ(refusal(good + "cases = [1]\n"),
              "x.toml:8:10: an entry of `cases` is not a text, expected one in quotes");
    EXPECT_TRUE(refusal(good + "case = [\"K\"]\n").starts_with("x.toml:8:8: unknown key 'case', did you mean 'cases'?"))
        << refusal(good + "case = [\"K\"]\n");
    EXPECT_TRUE(refusal("a = ").starts_with("x.toml:1:")) << refusal("a = ");
    EXPECT_EQ(refusal(""), "x.toml:1:1: no exercises, expected [[exercise]]");
    EXPECT_NE(refusal(good + "cases = [\"K\"]\n" + good + "cases = [\"K\"]\n").find("two exercises have the id 05-k"),
              std::string::npos);
    EXPECT_NE(refusal("[[exercise]]\nid = \"06-k\"\nlesson = 5\npoints = 2\ntitle = \"t\"\nslide = \"s\"\nhint = "
                      "\"h\"\ncases = [\"K\"]\n")
                  .find("x.toml:2:6: the id 06-k does not begin with its lesson, expected 05-..."),
              std::string::npos);
}

} // namespace

} // namespace rt::grade
