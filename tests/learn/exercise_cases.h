// The public cases on a student's exercise: what is not written yet is skipped, by name.
#pragma once

#include <optional>

#include "common/scene/pixel.h"
#include "tests/cases/lesson00_cases.h"
#include "tests/cases/run_cases.h"

namespace rt::grade
{

/// A picture is magenta where the exercise is not attempted, and no case says so. Here it throws NotAttempted instead.
inline cases::Subject askingWhy(cases::Subject subject)
{
    subject.picture = [picture = subject.picture, color = subject.color](const SceneDescription& scene) {
        const Image image = picture(scene);
        const Camera<double> camera(scene.camera);
        for (int i = 0; i < image.width * image.height; ++i)
        {
            if (image.pixels[std::size_t(i)] != magenta) continue;
            const auto ray = camera.ray(i % image.width + 0.5, i / image.width + 0.5);
            color(scene, ray.O, ray.D); // throws, if that is why
            break;
        }
        return image;
    };
    return subject;
}

/// Runs one case and hands its failures to GoogleTest.
template <class OneCase, class Subject>
class ExerciseTest : public testing::Test
{
public:
    ExerciseTest(const OneCase& one, const Subject& of) : which(one), subject(of) {}

    void TestBody() override
    {
        try
        {
            const auto check = runCase(which, subject);
            EXPECT_GT(check.checked, 0) << "the case checks nothing";
            for (const auto& failure : check.failures)
                ADD_FAILURE() << "Slide: " << which.slide << "\n  " << failure.what << "\n  expected "
                              << failure.expected << "\n  got      " << failure.got;
        }
        catch (const NotAttempted& missing)
        {
            GTEST_SKIP() << missing.id << " has not been attempted";
        }
    }

private:
    OneCase which;
    Subject subject;
};

template <class OneCase, class Subject>
bool registerExercise(const std::string& suite, const Subject& subject, const std::vector<OneCase>& cases)
{
    for (const auto& which : cases)
        testing::RegisterTest(
            suite.c_str(), fmt::format("{}_{}", which.group, which.name).c_str(), nullptr, nullptr, __FILE__, __LINE__,
            [which, subject]() -> testing::Test* { return new ExerciseTest<OneCase, Subject>(which, subject); });
    return true;
}

} // namespace rt::grade
