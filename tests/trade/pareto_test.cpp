#include "lessons/10_speed_and_accuracy/study/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rt::lesson10
{

namespace
{

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
using Indices = std::vector<std::size_t>;

TEST(Pareto, TheFrontOfHandMadePointsIsInTheOrderOfTime)
{
    //                          slow, exact   fast, poor  beaten by 3   middle      as fast as 3, worse
    const std::vector<Cost> all{{9, inf}, {1, 10}, {5, 30}, {4, 40}, {4, 35}};
    EXPECT_EQ(paretoFront(all), (Indices{1, 3, 0}));
}

TEST(Pareto, OfEqualPointsTheFirstStandsForAll)
{
    EXPECT_EQ(paretoFront({{2, 5}, {2, 5}, {3, 5}}), (Indices{0}));
}

TEST(Pareto, NothingIsItsOwnDominator)
{
    EXPECT_FALSE(dominates({1, 2}, {1, 2}));
    EXPECT_TRUE(dominates({1, 2}, {1, 1}));
    EXPECT_TRUE(dominates({1, 2}, {2, 2}));
    EXPECT_FALSE(dominates({1, 2}, {0.5, 1}));
    EXPECT_FALSE(dominates({1, inf}, {1, inf}));
}

TEST(Pareto, PointsWithoutATimeOrAnAccuracyAreNeverOnTheFront)
{
    EXPECT_EQ(paretoFront({{nan, 99}, {1, nan}, {2, 3}}), (Indices{2}));
    EXPECT_TRUE(paretoFront({}).empty());
}

TEST(Pareto, NoPointOfTheFrontIsDominatedAndEveryOtherIsDominatedOrEqual)
{
    EXPECT_TRUE(rc::check([](const std::vector<std::pair<short, short>>& numbers) {
        std::vector<Cost> points;
        for (const auto& [time, accuracy] : numbers)
            points.push_back({double(time % 16), accuracy % 7 == 0 ? inf : double(accuracy % 16)});
        const auto front = paretoFront(points);
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const bool chosen = std::find(front.begin(), front.end(), i) != front.end();
            bool beaten = false, equal = false;
            for (std::size_t j = 0; j < points.size(); ++j) beaten = beaten || dominates(points[j], points[i]);
            for (const auto j : front)
                equal = equal || (points[j].time == points[i].time && points[j].accuracy == points[i].accuracy);
            RC_ASSERT(!(chosen && beaten));
            RC_ASSERT(chosen || beaten || equal);
        }
    }));
}

} // namespace

} // namespace rt::lesson10
