// Exercises as students get them: nothing of theirs is right before they have written it.
#include <gtest/gtest.h>

#include <map>

#include "lessons/exercises.h"
#include "lessons/list.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

/// No group of the lesson's own cases may pass, and some of each must say which exercise is missing.
void expectNotAttempted(const Subject& subject, int lesson)
{
    std::map<std::string, int> attempted, notAttempted;
    for (const auto& which : ownCases(lesson))
    {
        if (which.kind == Kind::picture) continue; // those are magenta instead
        try
        {
            runCase(which, subject);
            ++attempted[which.group];
        }
        catch (const NotAttempted& mark)
        {
            EXPECT_EQ(std::stoi(mark.id.substr(0, 2)), lesson);
            ++notAttempted[which.group];
        }
    }
    EXPECT_FALSE(notAttempted.empty());
    for (const auto& [group, count] : attempted) EXPECT_GT(notAttempted[group], count) << group;
}

TEST(Exercises, AreNotAttemptedBeforeTheyAreWritten)
{
#define RAYTREE_EXPECT(number, NN) expectNotAttempted(exerciseSubject<exercise##NN::Tracer>(), number);
    RAYTREE_FOR_EACH_LESSON(RAYTREE_EXPECT)
#undef RAYTREE_EXPECT
}

TEST(Exercises, HaveMagentaPixels)
{
    const auto subject = exerciseSubject<exercise01::Tracer>();
    const Image picture = subject.picture(smallScene("lessons/01_direct_illumination/scenes/behind.toml"));
    for (const auto& pixel : picture.pixels) ASSERT_EQ(pixel, magenta);
}

} // namespace

} // namespace rt::cases
