// Exercises as students get them: nothing of theirs is right before they have written it.
#include <gtest/gtest.h>

#include "lessons/01_direct_illumination/exercise.h"
#include "lessons/02_mirrors/exercise.h"
#include "tests/lessons/run_cases.h"

namespace rt::cases
{

namespace
{

void expectNotAttempted(const Subject& subject, std::vector<Case> cases)
{
    std::erase_if(cases, [](const auto& which) { return which.kind == Kind::picture; }); // those are magenta instead
    for (const auto& which : cases)
        EXPECT_THROW(runCase(which, subject), NotAttempted) << which.group << " " << which.name;
}

TEST(Exercise01, IsNotAttemptedInAnyCase)
{
    expectNotAttempted(exerciseSubject<exercise01::Tracer>(), ownCases(1));
}

TEST(Exercise01, HasMagentaPixels)
{
    const auto subject = exerciseSubject<exercise01::Tracer>();
    const Image picture = subject.picture(smallScene("lessons/01_direct_illumination/scenes/behind.toml"));
    for (const auto& pixel : picture.pixels) ASSERT_EQ(pixel, magenta);
}

TEST(Exercise02, IsNotAttemptedInAnyCaseOfItsLesson)
{
    expectNotAttempted(exerciseSubject<exercise02::Tracer>(), ownCases(2));
}

} // namespace

} // namespace rt::cases
