// Real programs through pipes: solved exercises answer what they answer in our own process, untouched ones say so, and
// whatever else a program does, the next question is answered.
#include "tests/grade/wire/remote.h"

#include <chrono>
#include <map>

#include "tests/cases/lesson00_cases.h"
#include "tests/cases/run_cases.h"
#include "tests/grade/exercises.h"
#include "tests/grade/questions/manifest.h"
#include "tests/grade/wire/exercise_ids.h"
#include "tests/grade/wire/functions.h"
#include "tests/grade/wire/misbehaving.h"
#include "tests/grade/wire/payload.h"

namespace rt::grade
{

namespace
{

using cases::V;

/// The box has tests of its own.
const Box box{Sandbox::none, 0};

Limits limits()
{
    Limits some;
#ifdef __SANITIZE_ADDRESS__
    some.memory = std::size_t(1) << 46; // its shadow
#endif
    return some;
}

Remote student(const std::string& name, int lesson, const Limits& some = limits())
{
    return Remote(box, RAYTREE_STUDENTS + name, lesson, some);
}

/// Gives the remote one's answer, after comparing its bits with ours.
template <class R, class... Args>
std::function<R(Args...)> both(const std::function<R(Args...)>& far, const std::function<R(Args...)>& near,
                               int& compared)
{
    EXPECT_EQ(bool(far), bool(near));
    if (!far || !near) return {};
    return [&compared, far, near](Args... args) {
        const R got = far(args...);
        EXPECT_EQ(encode(got), encode(near(args...)));
        ++compared;
        return got;
    };
}

Candidate both(const Candidate& far, const Candidate& near, int& compared)
{
    Candidate pair = far;
    const auto join = [&](auto& mine, const auto& theirs) { mine = both(mine, theirs, compared); };
    auto& t = pair.tracer;
    const auto& n = near.tracer;
    join(t.color, n.color);
    join(t.tree, n.tree);
    join(t.picture, n.picture);
    join(t.toSphere, n.toSphere);
    join(t.toPlane, n.toPlane);
    join(t.reflect, n.reflect);
    join(t.latLong, n.latLong);
    join(t.refract, n.refract);
    join(t.cosSquared2, n.cosSquared2);
    join(t.fresnel, n.fresnel);
    join(t.schlick, n.schlick);
    join(t.phong, n.phong);
    auto& g = pair.geometry;
    const auto& m = near.geometry;
    join(g.slopeIntercept, m.slopeIntercept);
    join(g.yAt, m.yAt);
    join(g.implicitForm, m.implicitForm);
    join(g.normals2, m.normals2);
    join(g.distanceToOrigin, m.distanceToOrigin);
    join(g.withUnitNormal, m.withUnitNormal);
    join(g.segmentLength, m.segmentLength);
    join(g.parametricForm, m.parametricForm);
    join(g.normals3, m.normals3);
    join(g.unitNormal, m.unitNormal);
    return pair;
}

/// All own cases pass, and all answers have the bits of our own process.
void expectSolved(const std::string& name, int lesson)
{
    auto remote = student(name, lesson);
    int compared = 0;
    const auto candidate = both(remote.candidate(), solved(lesson), compared);
    const auto expectPassed = [](const auto& which, const cases::Check& check) {
        EXPECT_GT(check.checked, 0);
        for (const auto& failure : check.failures)
            ADD_FAILURE() << which.group << "_" << which.name << ": " << failure.what << ": expected "
                          << failure.expected << ", got " << failure.got;
    };
    for (const auto& which : cases::ownCases(lesson)) expectPassed(which, cases::runCase(which, candidate.tracer));
    if (lesson == 0)
        for (const auto& which : cases::geometryCases()) expectPassed(which, cases::runCase(which, candidate.geometry));
    EXPECT_GT(compared, 10);
    EXPECT_EQ(remote.deaths(), 0);
    EXPECT_EQ(remote.text(), "");
}

class Solved : public testing::TestWithParam<int>
{
};

TEST_P(Solved, PassesAllCasesWithTheBitsOfOurOwnProcess)
{
    expectSolved(fmt::format("solved{:02}", GetParam()), GetParam());
}

TEST(SolvedInTheKit, GetsTheBlockersThatItCannotFindWithoutFormulas)
{
    expectSolved("blockerless", 1);
}

INSTANTIATE_TEST_SUITE_P(Lesson, Solved, testing::ValuesIn(exerciseLessons()));

class Untouched : public testing::TestWithParam<int>
{
};

TEST_P(Untouched, SaysWhichExerciseIsNotAttempted)
{
    const int lesson = GetParam();
    auto remote = student(fmt::format("exercise{:02}", lesson), lesson);
    const auto candidate = remote.candidate();
    std::map<std::string, int> marks;
    const auto count = [&](const auto& which, const auto& subject) {
        try
        {
            runCase(which, subject);
        }
        catch (const NotAttempted& mark)
        {
            ++marks[mark.id];
        }
    };
    for (const auto& which : cases::ownCases(lesson)) count(which, candidate.tracer);
    if (lesson == 0)
        for (const auto& which : cases::geometryCases()) count(which, candidate.geometry);
    EXPECT_FALSE(marks.empty());
    const auto ids = exerciseIds(lesson);
    for (const auto& [id, times] : marks) EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
    EXPECT_EQ(remote.deaths(), 0);
}

INSTANTIATE_TEST_SUITE_P(Lesson, Untouched, testing::ValuesIn(exerciseLessons()));

TEST(UntouchedExercise, HasMagentaPictures)
{
    auto remote = student("exercise01", 1);
    const auto picture =
        remote.candidate().tracer.picture(cases::smallScene("lessons/01_direct_illumination/scenes/behind.toml"));
    ASSERT_EQ(picture.pixels.size(), 64 * 48U);
    for (const auto& pixel : picture.pixels) ASSERT_EQ(pixel, magenta);
}

/// What becomes of one question.
Outcome outcomeOf(const Candidate& candidate, Way way, std::string* sentence = nullptr)
{
    try
    {
        candidate.tracer.refract(V(0, -1, 0), V(0, 1, 0), double(way), 1);
    }
    catch (const Died& death)
    {
        if (sentence) *sentence = death.what();
        return death.outcome;
    }
    catch (const NotAttempted&)
    {
        return Outcome::notAttempted;
    }
    catch (const std::exception& error)
    {
        if (sentence) *sentence = error.what();
        return Outcome::wrong;
    }
    return Outcome::passed;
}

TEST(Misbehaving, EndsAsWhatItIsAndIsAskedAgain)
{
    const std::map<Way, Outcome> expected = {
        {Way::behave, Outcome::passed},
        {Way::abort, Outcome::crashed},
        {Way::recurse, Outcome::crashed},
        {Way::exit, Outcome::protocol},
        {Way::print, Outcome::passed},
        {Way::printMuch, Outcome::passed},
        {Way::garbage, Outcome::protocol},
        {Way::otherSequence, Outcome::protocol},
        {Way::hugeAnswer, Outcome::protocol},
        {Way::longAnswer, Outcome::protocol},
        {Way::halfAnswer, Outcome::protocol},
        {Way::flood, Outcome::protocol},
        {Way::throwText, Outcome::wrong},
        {Way::throwNumber, Outcome::wrong},
        {Way::throwMemory, Outcome::outOfMemory},
        {Way::ownMark, Outcome::notAttempted},
        {Way::foreignMark, Outcome::protocol},
        {Way::inventedMark, Outcome::protocol},
    };
    for (const auto& [way, outcome] : expected)
    {
        auto remote = student("misbehaving", 5);
        const auto candidate = remote.candidate();
        std::string sentence;
        EXPECT_EQ(outcomeOf(candidate, way, &sentence), outcome) << int(way) << ": " << sentence;
        EXPECT_LT(sentence.size(), 1100U) << int(way);
        EXPECT_EQ(outcomeOf(candidate, Way::behave, &sentence), Outcome::passed) << int(way) << ": " << sentence;
        const bool dies = outcome != Outcome::passed && outcome != Outcome::wrong && outcome != Outcome::notAttempted;
        EXPECT_EQ(remote.deaths(), dies) << int(way);
    }
}

TEST(Misbehaving, EatingMemoryEndsItself)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer needs its address space";
#endif
    Limits some = limits();
    some.wallSeconds = 1200; // its memory must end it, not the clock of a busy machine
    auto remote = student("misbehaving", 5, some);
    EXPECT_EQ(outcomeOf(remote.candidate(), Way::eatMemory), Outcome::outOfMemory);
    EXPECT_EQ(outcomeOf(remote.candidate(), Way::behave), Outcome::passed);
}

TEST(Misbehaving, ClosingTheAnswersIsSeenAtOnce)
{
    auto remote = student("misbehaving", 5);
    const auto outcome = outcomeOf(remote.candidate(), Way::closeAnswers);
    EXPECT_TRUE(outcome == Outcome::protocol || outcome == Outcome::crashed) << name(outcome); // the runner gives up
    EXPECT_EQ(outcomeOf(remote.candidate(), Way::behave), Outcome::passed);
}

TEST(Misbehaving, HangingIsStoppedInTime)
{
    Limits some = limits();
    some.wallSeconds = 24; // 10 s to start, 2 s for a question, the first one too
    for (const Way way : {Way::loop, Way::sleep})
    {
        auto remote = student("misbehaving", 5, some);
        std::string sentence;
        EXPECT_EQ(outcomeOf(remote.candidate(), way, &sentence), Outcome::timedOut);
        EXPECT_EQ(sentence, "it did not answer within 2 s");
        EXPECT_EQ(outcomeOf(remote.candidate(), Way::behave), Outcome::passed);
    }
}

TEST(Misbehaving, IsGivenUpWhenItHasUsedItsTime)
{
    Limits some = limits();
    some.wallSeconds = 0.6; // a question 0.05 s
    auto remote = student("misbehaving", 5, some);
    Outcome last = Outcome::timedOut;
    const auto begin = std::chrono::steady_clock::now();
    for (int hung = 0; hung < 15 && last == Outcome::timedOut; ++hung) last = outcomeOf(remote.candidate(), Way::sleep);
    const auto used = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    EXPECT_EQ(last, Outcome::notRun);
    EXPECT_EQ(outcomeOf(remote.candidate(), Way::behave), Outcome::notRun);
    EXPECT_GE(used, some.wallSeconds) << "it was given up before its time was over";
}

TEST(Misbehaving, IsGivenUpAfterTwentyDeaths)
{
    auto remote = student("misbehaving", 5);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(outcomeOf(remote.candidate(), Way::abort), Outcome::crashed) << i;
    EXPECT_EQ(outcomeOf(remote.candidate(), Way::behave), Outcome::notRun);
    EXPECT_EQ(remote.deaths(), 20);
    EXPECT_EQ(outcomeOf(remote.afresh(), Way::behave), Outcome::passed) << "another exercise pays for this one";
    EXPECT_EQ(remote.deaths(), 0);
}

TEST(Misbehaving, IsAskedAfreshInAnotherProcess)
{
    auto remote = student("misbehaving", 5);
    const auto scene = cases::Build().floor().depth(3).scene;
    const auto candidate = remote.candidate();
    candidate.tracer.tree(scene, V(1, 0, 0), V(1));
    const auto afresh = remote.afresh();
    const auto nothing = afresh.fingerprint();
    EXPECT_EQ(outcomeOf(afresh, Way::behave), Outcome::passed);
    EXPECT_NE(afresh.fingerprint(), nothing);
    EXPECT_EQ(afresh.tracer.tree(scene, V(1, 0, 0), V(1)).maxDepth, 3) << "the new process has no scene yet";
}

TEST(Misbehaving, ThatNeverStartsIsGivenUpForAllExercises)
{
    const Remote remote(box, "/bin/false", 5, limits());
    std::string sentence;
    for (int i = 0; i < 3; ++i) EXPECT_NE(outcomeOf(remote.afresh(), Way::behave), Outcome::notRun);
    EXPECT_EQ(outcomeOf(remote.afresh(), Way::behave, &sentence), Outcome::notRun);
    EXPECT_EQ(sentence, "it is not asked any more: it did not start 3 times");
}

TEST(Misbehaving, TextIsKeptFromTheFirstProcessesAndNotAllOfIt)
{
    auto remote = student("misbehaving", 5);
    outcomeOf(remote.candidate(), Way::print);
    outcomeOf(remote.candidate(), Way::abort);
    for (int i = 0; i < 5; ++i)
    {
        outcomeOf(remote.candidate(), Way::printMuch);
        outcomeOf(remote.candidate(), Way::abort);
    }
    const auto text = remote.text();
    EXPECT_EQ(text.substr(0, 8), "debug 2\n"); // 1 is the greeting
    EXPECT_GT(text.size(), 3 * 4096U);
    EXPECT_LE(text.size(), 4 * 4096U);
}

TEST(Misbehaving, MissingFunctionsAreExceptionsAndNoDeaths)
{
    auto remote = student("misbehaving", 5);
    const auto candidate = remote.candidate();
    EXPECT_THROW(candidate.tracer.reflect(V(1, 0, 0), V(0, 1, 0)), std::runtime_error);
    EXPECT_THROW(candidate.tracer.color(cases::Build().floor().scene, V(0), V(1)), std::runtime_error);
    EXPECT_FALSE(candidate.tracer.fresnel); // lesson 05 has none, whatever the student has
    EXPECT_FALSE(candidate.geometry.yAt);
    EXPECT_EQ(remote.deaths(), 0);
}

TEST(Misbehaving, PicturesOfAnotherSizeAndImpossibleTreesAreViolations)
{
    auto remote = student("misbehaving", 5);
    const auto candidate = remote.candidate();
    const auto scene = cases::smallScene("lessons/05_refraction/scenes/slab.toml");
    EXPECT_THROW(candidate.tracer.picture(scene), Died);
    EXPECT_THROW(candidate.tracer.tree(scene, V(2, 0, 0), V(1)), Died);                     // two nodes 0
    EXPECT_THROW(candidate.tracer.tree(scene, V(0, 1, 0), V(1)), Died);                     // a shadow ray of no node
    EXPECT_THROW(candidate.tracer.tree(scene, V(1 << 16, 0, 0), V(1)), std::runtime_error); // over 4 MiB
    EXPECT_EQ(candidate.tracer.tree(scene, V(1, 1, 0), V(1)).shadows.size(), 1U);
    EXPECT_EQ(remote.deaths(), 3);
}

TEST(Remote, HashesAllAnswersSinceTheLastTime)
{
    const auto ask = [](const Candidate& candidate, double x) {
        candidate.tracer.refract(V(x, -1, 0), V(0, 1, 0), double(Way::behave), 1);
    };
    auto a = student("misbehaving", 5), b = student("misbehaving", 5);
    const auto one = a.candidate(), two = b.candidate();
    const auto nothing = one.fingerprint();
    ask(one, 1);
    ask(one, 2);
    ask(two, 1);
    const auto afterOne = two.fingerprint();
    ask(two, 2);
    const auto first = one.fingerprint(), second = two.fingerprint();
    EXPECT_NE(first, nothing);
    EXPECT_NE(first, afterOne);
    EXPECT_NE(first, second); // an answer less
    ask(one, 2);
    EXPECT_EQ(one.fingerprint(), second);
    EXPECT_EQ(two.fingerprint(), nothing);
    ask(one, 2);
    ask(two, 3);
    EXPECT_NE(one.fingerprint(), two.fingerprint()); // as many answers, one of them another
}

TEST(Remote, ShowsTheSceneToEachNewProcess)
{
    auto remote = student("misbehaving", 5);
    const auto candidate = remote.candidate();
    const auto scene = cases::Build().floor().depth(3).scene; // its tree says so; without a scene it would say 8
    for (int i = 0; i < 2; ++i)
    {
        EXPECT_EQ(candidate.tracer.tree(scene, V(1, 0, 0), V(1)).maxDepth, 3);
        EXPECT_EQ(outcomeOf(candidate, Way::abort), Outcome::crashed);
    }
}

TEST(Remote, FailuresOfOursAreNoVerdicts)
{
    const auto missing = student("no-such-program", 5).candidate();
    EXPECT_THROW(missing.tracer.refract(V(1), V(1), 1, 1), GraderError);
    auto scene = cases::smallScene("lessons/05_refraction/scenes/slab.toml");
    const auto candidate = student("solved05", 5).candidate();
    scene.camera.width = 4000;
    EXPECT_THROW(candidate.tracer.picture(scene), GraderError);
    scene.camera.width = 64;
    scene.materials[0].name = std::string(longestText + 1, 'x');
    EXPECT_THROW(candidate.tracer.picture(scene), GraderError);
    EXPECT_THROW(student("solved05", 9), std::exception);
}

} // namespace

} // namespace rt::grade
