#include "tests/learn/attempt.h"

#include <gtest/gtest.h>

#include "common/base/image.h"
#include "common/files/scene_file.h"
#include "lessons/00_geometry/geometry.h"
#include "tests/grade/exercises.h"
#include "tests/learn/pictures.h"
#include "tests/learn/session.h"
#include "tests/learn/show.h"

namespace rt::grade
{

namespace
{

TEST(Attempt, OfASolvedExerciseIsRight)
{
    const auto attempts = runCases(solved(2), exercisesOf(2), "02-reflect");
    ASSERT_EQ(attempts.size(), 2U);
    for (const auto& [id, attempt] : attempts)
    {
        EXPECT_EQ(attempt.outcome, Outcome::passed) << id << ": " << attempt.name;
        EXPECT_GT(attempt.cases, 1) << id;
        EXPECT_EQ(attempt.passed, attempt.cases) << id;
    }
    const auto zero =
        runCases({.tracer = {}, .geometry = cases::geometrySubject<lesson00::Geometry<double>>(), .fingerprint = {}},
                 exercisesOf(0), "00-circle");
    ASSERT_EQ(zero.size(), exercisesOf(0).size());
    for (const auto& [id, attempt] : zero) EXPECT_EQ(attempt.outcome, Outcome::passed) << id << ": " << attempt.name;
}

TEST(Attempt, OfTheExerciseAsHandedOutIsNotAttempted)
{
    for (const auto& [id, attempt] : runCases(untouched(2), exercisesOf(2), ""))
    {
        EXPECT_EQ(attempt.outcome, Outcome::notAttempted) << id;
        EXPECT_TRUE(attempt.missing.starts_with("02-")) << attempt.missing;
        EXPECT_FALSE(attempt.pictures) << "a magenta picture is no mistake";
    }
}

TEST(Attempt, NamesTheExerciseThatItWaitsFor)
{
    auto candidate = solved(2);
    const auto ofReflect = [](const auto&...) -> Vec3<double> { throw NotAttempted("02-reflect"); };
    candidate.tracer.reflect = ofReflect;
    candidate.tracer.color = ofReflect;
    candidate.tracer.tree = [](const auto&...) -> RayTree { throw NotAttempted("02-reflect"); };
    candidate.tracer.picture = [](const SceneDescription& scene) {
        Image image(scene.camera.width, scene.camera.height);
        std::fill(image.pixels.begin(), image.pixels.end(), magenta);
        return image;
    };
    const auto attempts = runCases(candidate, exercisesOf(2), "02-mirror");
    EXPECT_EQ(attempts.at("02-mirror").outcome, Outcome::notAttempted);
    EXPECT_EQ(attempts.at("02-mirror").missing, "02-reflect");
}

TEST(Attempt, ShowsTheFirstFailingCaseWithSlideAndNumbers)
{
    auto candidate = solved(2);
    candidate.tracer.reflect = [](const Vec3<double>& D, const Vec3<double>&) { return D; };
    const auto attempts = runCases(candidate, exercisesOf(2), "02-reflect");
    const auto& attempt = attempts.at("02-reflect");
    EXPECT_EQ(attempt.outcome, Outcome::wrong);
    EXPECT_LT(attempt.passed, attempt.cases);
    EXPECT_TRUE(attempt.name.starts_with("Reflect: ")) << attempt.name;
    EXPECT_NE(attempt.slide.find("Reflected Vector"), std::string::npos);
    EXPECT_FALSE(attempt.example.expected.empty());
    EXPECT_NE(attempt.example.expected, attempt.example.got);
    EXPECT_EQ(attempts.at("02-mirror").outcome, Outcome::passed) << "only reflect was changed";
}

TEST(Attempt, HasThePicturesOfAWrongPicture)
{
    auto candidate = solved(2);
    candidate.tracer.picture = [right = candidate.tracer.picture](const SceneDescription& scene) {
        Image image = right(scene);
        for (int x = 0; x < image.width; ++x) image.at(x, 5) += Vec3<double>(0.1);
        image.at(10, 20) += Vec3<double>(0.5);
        return image;
    };
    const auto attempt = runCases(candidate, exercisesOf(2), "02-mirror").at("02-mirror");
    EXPECT_EQ(attempt.outcome, Outcome::wrong);
    ASSERT_TRUE(attempt.pictures);
    EXPECT_TRUE(attempt.pictures->title.starts_with("lessons/02_mirrors/scenes/")) << attempt.pictures->title;
    const auto camera = loadScene(std::string(RAYTREE_SOURCE_DIR) + "/" + attempt.pictures->title).camera;
    EXPECT_EQ(attempt.pictures->x, 21 * camera.width / 128);
    EXPECT_EQ(attempt.pictures->y, 41 * camera.height / 96);
    EXPECT_NEAR(attempt.pictures->difference.at(10, 20).x, 0.5, 1e-6); // stored floats have 24 bits
    EXPECT_NEAR(attempt.pictures->difference.at(11, 20).x, 0, 1e-6);
    const Image together = sideBySide(*attempt.pictures, 4);
    EXPECT_EQ(together.width, (3 * 64 + 2 * 2) * 4);
    EXPECT_EQ(together.height, 48 * 4);
    EXPECT_EQ(together.at(4 * 10 + 3, 4 * 20 + 3), attempt.pictures->expected.at(10, 20));
    EXPECT_EQ(together.at(4 * (66 + 10), 4 * 20), attempt.pictures->got.at(10, 20));
    EXPECT_EQ(together.at(4 * (132 + 10), 4 * 20), attempt.pictures->difference.at(10, 20));
}

TEST(Attempt, StopsAtTheFirstDeathAndLeavesTheOthersOpen)
{
    auto candidate = solved(2);
    int asked = 0;
    candidate.tracer.reflect = [&asked](const auto&...) -> Vec3<double> {
        ++asked;
        throw Died(Outcome::timedOut, "it takes too long");
    };
    const auto attempts = runCases(candidate, exercisesOf(2), "02-reflect");
    EXPECT_EQ(attempts.at("02-reflect").outcome, Outcome::timedOut);
    EXPECT_EQ(attempts.at("02-reflect").example.got, "it takes too long");
    EXPECT_EQ(attempts.at("02-mirror").outcome, Outcome::notRun);
    EXPECT_EQ(asked, 1);
}

TEST(Attempt, ShowsThePictureOfAWrongExerciseAndNotOfAnother)
{
    auto candidate = solved(2);
    candidate.tracer.reflect = [](const Vec3<double>& D, const Vec3<double>&) { return D; };
    candidate.tracer.picture = [](const SceneDescription& scene) {
        return Image(scene.camera.width, scene.camera.height);
    };
    const auto attempts = runCases(candidate, exercisesOf(2), "02-reflect");
    EXPECT_TRUE(attempts.at("02-reflect").pictures);
    EXPECT_TRUE(attempts.at("02-reflect").name.starts_with("Reflect: ")) << "a value says more than a picture";
    EXPECT_FALSE(attempts.at("02-mirror").pictures) << "it is right";
    // Whichever is looked at first.
    candidate.tracer.tree = [](const auto&...) { return RayTree(); };
    const auto both = runCases(candidate, exercisesOf(2), "02-reflect");
    EXPECT_EQ(both.at("02-mirror").outcome, Outcome::wrong);
    EXPECT_TRUE(both.at("02-reflect").pictures);
    EXPECT_TRUE(both.at("02-mirror").pictures);
}

TEST(Attempt, ShowsNoPictureThatIsMagentaBecauseAnotherExerciseIsMissing)
{
    auto candidate = untouched(2);
    candidate.tracer.reflect = [](const Vec3<double>& D, const Vec3<double>&) { return D; };
    const auto attempts = runCases(candidate, exercisesOf(2), "02-reflect");
    EXPECT_EQ(attempts.at("02-reflect").outcome, Outcome::wrong);
    EXPECT_FALSE(attempts.at("02-reflect").pictures);
}

TEST(Attempt, TakesWhatExercisesThrowForWrong)
{
    auto candidate = solved(2);
    candidate.tracer.reflect = [](const auto&...) -> Vec3<double> { throw std::runtime_error("no idea"); };
    const auto attempt = runCases(candidate, exercisesOf(2), "02-reflect").at("02-reflect");
    EXPECT_EQ(attempt.outcome, Outcome::wrong);
    EXPECT_EQ(attempt.example.got, "no idea");
}

TEST(CaseName, IsASentence)
{
    EXPECT_EQ(caseName("Reflect", "KeepsTheAngleToTheNormal"), "Reflect: keeps the angle to the normal");
    EXPECT_EQ(caseName("Length", "IsTheRootOf53"), "Length: is the root of 53");
}

TEST(TodoLine, IsWhereTheCallStands)
{
    EXPECT_EQ(todoLine("a\nb todo(\"02-reflect\");\n", "02-reflect"), 2);
    EXPECT_EQ(todoLine("todo(\"02-mirror\");", "02-mirror"), 1);
    EXPECT_EQ(todoLine("// TODO 02-mirror\n", "02-mirror"), 0);
}

struct Learning : testing::Test
{
    Session session{{{"01-a", 1, 2, "A", "slide a", "hint a", {"A"}},
                     {"01-b", 1, 3, "B", "slide b", "hint b", {"B"}},
                     {"02-c", 2, 5, "C", "slide c", "hint c", {"C"}}},
                    {"01-a", {{"01-a", Standing::right}}},
                    "",
                    ""};
};

TEST_F(Learning, FindsWhatIsNextAndNotYetRight)
{
    EXPECT_EQ(session.nextToDo("01-a")->id, "01-b");
    session.progress.exercises["01-b"] = Standing::right;
    EXPECT_EQ(session.nextToDo("01-a")->id, "02-c");
    session.progress.exercises = {{"01-b", Standing::right}, {"02-c", Standing::right}};
    EXPECT_EQ(session.nextToDo("01-a")->id, "01-a") << "it comes round to what was left out";
    session.progress.exercises["01-a"] = Standing::right;
    EXPECT_EQ(session.nextToDo("01-a"), nullptr);
    EXPECT_EQ(session.neighbour("01-a", -1), nullptr);
    EXPECT_EQ(session.neighbour("02-c", 1), nullptr);
    EXPECT_EQ(session.neighbour("02-c", -1)->id, "01-b");
}

TEST_F(Learning, CountsPoints)
{
    EXPECT_EQ(progressLine(session), "[######........................] 2 of 10 points, 1 of 3 exercises\n");
}

TEST_F(Learning, ShowsThreeCompilerErrorsAtMost)
{
    LessonRun run;
    for (int i = 1; i <= 5; ++i) run.errors.push_back("exercise.h:" + std::to_string(i) + ": error: oh");
    const auto text = resultText(session, session.current(), run, {});
    EXPECT_NE(text.find("exercise.h:3: error"), std::string::npos);
    EXPECT_EQ(text.find("exercise.h:4"), std::string::npos);
    EXPECT_NE(text.find("and 2 more"), std::string::npos);
}

TEST_F(Learning, ShowsTheLinesThatLedToAnError)
{
    LessonRun run;
    run.errors = {"common/base/vec.h:1: error: oh\nexercise.h:3: required from here"};
    EXPECT_EQ(resultText(session, session.current(), run, {}),
              "does not compile\n  common/base/vec.h:1: error: oh\n  exercise.h:3: required from here\n");
}

TEST_F(Learning, CountsNoCasesWhereThereIsOne)
{
    LessonRun run;
    run.compiled = true;
    run.attempts["01-a"].outcome = Outcome::wrong;
    run.attempts["01-a"].cases = 1;
    EXPECT_TRUE(resultText(session, session.current(), run, {}).starts_with("wrong\n"));
    run.attempts["01-a"].cases = 2;
    EXPECT_TRUE(resultText(session, session.current(), run, {}).starts_with("wrong: 0 of 2 cases are right\n"));
}

TEST_F(Learning, SaysThatAnEarlierExerciseIsWrongToo)
{
    LessonRun run;
    run.compiled = true;
    run.attempts["01-a"].outcome = run.attempts["01-b"].outcome = Outcome::wrong;
    const auto sentence = "01-a is wrong too, and this may follow from it: mend it first";
    EXPECT_NE(resultText(session, *session.find("01-b"), run, {}).find(sentence), std::string::npos);
    EXPECT_EQ(resultText(session, *session.find("01-a"), run, {}).find("wrong too"), std::string::npos);
    run.attempts["01-a"].outcome = Outcome::passed;
    EXPECT_EQ(resultText(session, *session.find("01-b"), run, {}).find("wrong too"), std::string::npos);
}

TEST_F(Learning, KeepsControlCharactersOfForeignTextOut)
{
    LessonRun run{true,
                  "",
                  {},
                  {},
                  {{"01-a",
                    {.outcome = Outcome::wrong,
                     .cases = 1,
                     .missing = {},
                     .name = "A: is",
                     .slide = "s",
                     .example = {"x", "1", "\033[2J", {}},
                     .pictures = {},
                     .mistake = {}}}},
                  "print\007ed\n"};
    const auto text = resultText(session, session.current(), run, {});
    EXPECT_EQ(text.find('\033'), std::string::npos);
    EXPECT_EQ(text.find('\007'), std::string::npos);
    EXPECT_NE(text.find("print\\x07ed"), std::string::npos);
}

} // namespace

} // namespace rt::grade
