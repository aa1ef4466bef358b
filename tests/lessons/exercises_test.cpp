// Exercises as students get them: nothing of theirs is right before they have written it.
#include <gtest/gtest.h>

#include <map>

#include "lessons/01_direct_illumination/exercise.h"
#include "lessons/02_mirrors/exercise.h"
#include "lessons/03_partial_reflection/exercise.h"
#include "lessons/04_hdr_sky/exercise.h"
#include "lessons/05_refraction/exercise.h"
#include "lessons/06_fresnel/exercise.h"
#include "lessons/07_recursion_caps/exercise.h"
#include "lessons/08_phong/exercise.h"
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
    expectNotAttempted(exerciseSubject<exercise01::Tracer>(), 1);
    expectNotAttempted(exerciseSubject<exercise02::Tracer>(), 2);
    expectNotAttempted(exerciseSubject<exercise03::Tracer>(), 3);
    expectNotAttempted(exerciseSubject<exercise04::Tracer>(), 4);
    expectNotAttempted(exerciseSubject<exercise05::Tracer>(), 5);
    expectNotAttempted(exerciseSubject<exercise06::Tracer>(), 6);
    expectNotAttempted(exerciseSubject<exercise07::Tracer>(), 7);
    expectNotAttempted(exerciseSubject<exercise08::Tracer>(), 8);
}

TEST(Exercises, HaveMagentaPixels)
{
    const auto subject = exerciseSubject<exercise01::Tracer>();
    const Image picture = subject.picture(smallScene("lessons/01_direct_illumination/scenes/behind.toml"));
    for (const auto& pixel : picture.pixels) ASSERT_EQ(pixel, magenta);
}

} // namespace

} // namespace rt::cases
