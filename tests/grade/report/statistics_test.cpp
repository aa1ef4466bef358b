#include "tests/grade/report/statistics.h"

#include <gtest/gtest.h>

#include "tests/grade/report/feedback.h"
#include "tests/grade/report/sample_results.h"

namespace rt::grade
{

TEST(ClassStatistics, HaveTheHardestFirst)
{
    const std::vector<SubmissionResult> results = {samples::partial("ada"), samples::full("alan"),
                                                   samples::missing("grace")};
    const auto all = classStatistics(results);
    ASSERT_EQ(all.size(), 7U);
    EXPECT_EQ(all[0].name, "out of glass");
    EXPECT_EQ(all[0].students, 2) << "who has no result is not counted";
    EXPECT_EQ(all[0].full, 1);
    EXPECT_DOUBLE_EQ(all[0].share, 0.5);
    EXPECT_EQ(all[0].outcomes.at(Outcome::wrong), 1);
    EXPECT_EQ(all[6].full, 2);
    EXPECT_TRUE(classStatistics({}).empty());
}

TEST(ClassStatistics, KeepHiddenAndPublicCasesApart)
{
    const std::vector<SubmissionResult> results = {samples::partial("ada")};
    int hidden = 0;
    for (const auto& one : classStatistics(results)) hidden += one.hidden ? 1 : 0;
    EXPECT_EQ(hidden, 2);
}

TEST(CommonMistakes, CountAStudentOnce)
{
    // The same mistake shows in the public and in the hidden cases.
    const std::vector<SubmissionResult> results = {samples::partial("ada"), samples::partial("alan"),
                                                   samples::full("tony")};
    const auto all = commonMistakes(results);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].students, 2);
}

TEST(Histogram, HasFullMarksInTheLastBinAndExactTenthsInTheirOwn)
{
    std::vector<SubmissionResult> results = {samples::full("a"), samples::missing("b"), samples::full("c")};
    auto& third = results[2].criteria;
    third.resize(2);
    third[0].points = 0.7;
    third[1].points = 0.1; // together eight tenths, which the sum of the two doubles is just below
    const auto bins = histogram(results, 1.0);
    EXPECT_EQ(bins[9], 1);
    EXPECT_EQ(bins[8], 1);
    EXPECT_EQ(histogram(results, 0), (std::array<int, 10>{})) << "of nothing there is no share";
}

TEST(MostPoints, AreThoseOfWhoeverWasGraded)
{
    const std::vector<SubmissionResult> results = {samples::missing("grace"), samples::partial("ada")};
    EXPECT_DOUBLE_EQ(mostOf(results), 11);
    EXPECT_EQ(mostOf({}), 0);
}

TEST(PointsText, HasAtMostTwoDecimals)
{
    EXPECT_EQ(pointsText(0.1 + 0.2), "0.3");
    EXPECT_EQ(pointsText(10), "10");
    EXPECT_EQ(pointsText(2.5), "2.5");
    EXPECT_EQ(pointsText(1.0 / 3), "0.33");
    EXPECT_EQ(pointsText(-0.001), "0");
    EXPECT_EQ(pointsText(0), "0");
}

} // namespace rt::grade
