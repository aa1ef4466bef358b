// The grader's questions, put to those whose marks are known: solutions, mutants, other right formulas, constants.
#include <cstdlib>
#include <map>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "common/files/text_file.h"
#include "tests/grade/exercises.h"
#include "tests/grade/questions/ask.h"
#include "tests/grade/questions/known_mistakes.h"
#include "tests/grade/questions/question_set.h"
#include "tests/lessons/mutants.h"

namespace rt::cases
{
std::vector<Mutant> variants(int lesson);
}

namespace rt::grade
{

namespace
{

const Secret secret{"a secret of the tests", "2026-autumn"};

Answers grade(int lesson, const Candidate& candidate, const Secret& with = secret, bool mistakes = false)
{
    AskOptions options;
    options.twice = false;
    options.mistakes = mistakes;
    return gradeCandidate(
        lesson, [&] { return candidate; }, with, options);
}

double sum(const Answers& answers, double CriterionResult::*what)
{
    double all = 0;
    for (const auto& one : answers.criteria) all += one.*what;
    return all;
}

std::string describe(const CriterionResult& one)
{
    auto text =
        fmt::format("{}, {}{}: {} of {}, {:.3g} of {:.3g} points, {}", one.exercise, one.hidden ? "hidden " : "",
                    one.name, one.passed, one.cases, one.points, one.most, name(one.outcome));
    if (one.example)
        text += fmt::format("\n    {}\n    expected {}\n    got      {}", one.example->what, one.example->expected,
                            one.example->got);
    return text;
}

void expectFullMarks(int lesson, const Candidate& candidate, const Secret& with = secret)
{
    for (const auto& one : grade(lesson, candidate, with).criteria)
    {
        EXPECT_EQ(one.outcome, Outcome::passed) << describe(one);
        EXPECT_DOUBLE_EQ(one.points, one.most) << describe(one);
        EXPECT_TRUE(one.mistake.empty());
    }
}

class Lesson : public testing::TestWithParam<int>
{
};
INSTANTIATE_TEST_SUITE_P(All, Lesson, testing::ValuesIn(exerciseLessons()));

TEST_P(Lesson, ThatIsSolvedGetsFullMarksWithAnySecret)
{
    double points = 0;
    for (const auto& exercise : exercisesOf(GetParam())) points += exercise.points;
    for (const auto& with : {secret, Secret{"another", "2026-autumn"}, Secret{secret.course, "2027-spring"}})
    {
        expectFullMarks(GetParam(), solved(GetParam()), with);
        const auto set = questionSet(GetParam(), with, true);
        double shown = 0, all = 0;
        for (const auto& one : *set)
        {
            all += one.most;
            if (!one.hidden) shown += one.most;
        }
        EXPECT_NEAR(all, points, 1e-9)
            << "points that questions give, and points in lessons/exercises.toml: an exercise has "
               "no criterion in an ask_*.cpp";
        EXPECT_NEAR(shown, 0.3 * points, 1e-9);
    }
}

TEST_P(Lesson, ThatIsUntouchedGetsNothing)
{
    const auto answers = grade(GetParam(), untouched(GetParam()));
    for (const auto& one : answers.criteria)
    {
        EXPECT_EQ(one.outcome, Outcome::notAttempted) << describe(one);
        EXPECT_EQ(one.points, 0) << describe(one);
    }
}

TEST_P(Lesson, InOtherWordsGetsFullMarks)
{
    int variants = 0;
    for (const auto& variant : cases::variants(GetParam()))
    {
        SCOPED_TRACE(variant.id);
        expectFullMarks(GetParam(), {.tracer = variant.subject});
        ++variants;
    }
    EXPECT_TRUE(GetParam() == 0 || variants >= 2);
}

// Every known mistake loses points where the student may look and where not, and is named; its marks are on record.
TEST_P(Lesson, MarksEachKnownMistake)
{
    static const std::string path = std::string(RAYTREE_SOURCE_DIR) + "/tests/grade/questions/marks.txt";
    std::map<std::string, std::string> marks;
    std::istringstream lines(readTextFile(path));
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && line[0] != '#') marks[line.substr(0, line.find(' '))] = line;
    double most = 0;
    for (const auto& one : *questionSet(GetParam(), secret, true)) most += one.most;
    for (const auto& mutant : mutantCandidates(GetParam()))
    {
        if (mutant.endless) continue; // its process would die; wire's tests and the attacks ask those
        const auto answers = grade(GetParam(), mutant.candidate, secret, true);
        double shown = 0, hidden = 0;
        std::map<std::string, int> named;
        std::string killers;
        for (const auto& one : answers.criteria)
        {
            (one.hidden ? hidden : shown) += one.most - one.points;
            if (one.points < one.most) killers += fmt::format("; {}{}", one.hidden ? "" : "public ", one.name);
            if (!one.mistake.empty()) ++named[one.mistake];
        }
        EXPECT_GT(shown, 0) << mutant.id << ": " << mutant.mistake;
        EXPECT_GT(hidden, 0) << mutant.id << ": " << mutant.mistake;
        std::string names;
        for (const auto& [sentence, count] : named) names += (names.empty() ? "" : " / ") + sentence;
        const auto line = fmt::format("{} {:.2f} of {:.0f}, named: {}", mutant.id,
                                      sum(answers, &CriterionResult::points), most, names);
        if (std::getenv("RAYTREE_SHOW_MARKS"))
            fmt::print("{}{}\n", line, std::getenv("RAYTREE_SHOW_MARKS")[0] == 'k' ? killers : "");
        EXPECT_EQ(marks[mutant.id], line) << "marks.txt; RAYTREE_SHOW_MARKS=1 prints what belongs there";
        EXPECT_FALSE(names.empty()) << mutant.id << ": " << mutant.mistake;
    }
}

/// All functions return the same, whatever they are asked.
Candidate constant(double x)
{
    Candidate c;
    c.tracer.epsilon = c.geometry.epsilon = std::numeric_limits<double>::epsilon();
    c.tracer.color = [x](auto&&...) { return V(x); };
    c.tracer.tree = [](const SceneDescription&, const V& O, const V& D) {
        RayTree tree;
        tree.nodes.emplace_back();
        tree.nodes[0].origin = O;
        tree.nodes[0].direction = D;
        return tree;
    };
    c.tracer.picture = [x](const SceneDescription& scene) {
        Image image(scene.camera.width, scene.camera.height);
        for (auto& pixel : image.pixels) pixel = V(x);
        return image;
    };
    c.tracer.toSphere = [x](auto&&...) { return x == 0 ? -1 : x; };
    c.tracer.toPlane = [x](auto&&...) { return x == 0 ? -1 : x; };
    c.tracer.reflect = [x](const V& D, const V& N) { return x == 0 ? D : x == 1 ? -D : N; };
    c.tracer.latLong = [x](const V&) { return std::array{x, x}; };
    c.tracer.refract = [x](const V& D, auto&&...) { return x == 0 ? std::optional<V>() : D; };
    c.tracer.cosSquared2 = c.tracer.fresnel = c.tracer.schlick = [x](auto&&...) { return x; };
    c.tracer.phong = [x](auto&&...) { return x; };
    c.geometry.slopeIntercept = [x](auto&&...) {
        return x == 0 ? std::optional<lesson00::SlopeIntercept>() : lesson00::SlopeIntercept{x, x};
    };
    c.geometry.yAt = [x](auto&&...) { return x; };
    c.geometry.implicitForm = [x](auto&&...) { return lesson00::Implicit{x, x, x}; };
    c.geometry.withUnitNormal = [x](const lesson00::Implicit& line) {
        return x == 0 ? lesson00::Implicit{0, 0, 0} : line;
    };
    c.geometry.normals2 = [x](auto&&...) { return std::pair(lesson00::V2(x), lesson00::V2(-x)); };
    c.geometry.distanceToOrigin = [x](auto&&...) { return x; };
    c.geometry.segmentLength = [x](auto&&...) { return x; };
    c.geometry.parametricForm = [x](const V& P, const V&) { return lesson00::Parametric{P, V(x)}; };
    c.geometry.normals3 = [x](auto&&...) { return std::pair(V(x, 0, 0), V(0, x, 0)); };
    c.geometry.unitNormal = [x](auto&&...) { return V(x, 0, 0); };
    return c;
}

TEST_P(Lesson, GivesNothingForConstants)
{
    for (const double x : {0.0, 1.0, 0.5, 0.04, double(NAN)})
        for (const auto& one : grade(GetParam(), constant(x)).criteria)
            EXPECT_EQ(one.points, 0) << x << ": " << describe(one);
}

/// A solution whose picture is spoilt.
Answers spoilt(int lesson, const std::function<void(Image&)>& spoil)
{
    auto candidate = solved(lesson);
    candidate.tracer.picture = [honest = candidate.tracer.picture, spoil](const SceneDescription& scene) {
        auto image = honest(scene);
        spoil(image);
        return image;
    };
    return grade(lesson, candidate);
}

bool isPicture(const CriterionResult& one)
{
    return one.name.starts_with("picture");
}

TEST_P(Lesson, GivesNothingForPicturesThatAreNone)
{
    if (GetParam() == 0) return;
    const std::function<void(Image&)> all[] = {
        [](Image& image) { std::fill(image.pixels.begin(), image.pixels.end(), V(NAN)); },
        [](Image& image) { std::fill(image.pixels.begin(), image.pixels.end(), V(0)); },
        [](Image& image) { image = Image(); },
        [](Image& image) {
            --image.height;
            image.pixels.resize(std::size_t(image.width * image.height));
        },
    };
    for (const auto& spoil : all)
    {
        int pictures = 0;
        for (const auto& one : spoilt(GetParam(), spoil).criteria)
            if (isPicture(one))
            {
                EXPECT_EQ(one.points, 0) << describe(one);
                EXPECT_EQ(one.outcome, Outcome::wrong) << describe(one);
                ++pictures;
            }
        EXPECT_GE(pictures, 2);
    }
}

TEST(Pictures, WithOneValueThatIsNotFiniteGetNinetyPercent)
{
    for (const auto& one : spoilt(2, [](Image& image) { image.at(0, 0).x = INFINITY; }).criteria)
    {
        if (!isPicture(one)) continue;
        EXPECT_NEAR(one.points, 0.9 * one.most, 1e-12);
    }
}

TEST(Pictures, AreCreditedLinearlyBetween80And99AndAHalfPercent)
{
    const auto set = questionSet(2, secret, true);
    for (const auto& asked : *set)
    {
        if (!asked.picture) continue;
        const auto credit = [&](double share) {
            Image got = asked.picture->expected;
            int spoil = int(std::lround((1 - share) * asked.picture->pixels));
            for (std::size_t i = 0; i < got.pixels.size() && spoil > 0; ++i)
                if (asked.picture->counts[i])
                {
                    got.pixels[i] += V(0.01);
                    --spoil;
                }
            return pictureCredit(*asked.picture, got);
        };
        EXPECT_EQ(credit(1), 1);
        EXPECT_EQ(credit(0.996), 1);
        EXPECT_NEAR(credit(0.9), 0.1 / 0.195, 1 / 0.195 / asked.picture->pixels); // whole pixels
        EXPECT_LT(credit(0.99), 1);
        EXPECT_EQ(credit(0.79), 0);
    }
}

TEST(Pictures, ThatAreWrongComeWithTheWorstPixelAndTheFirstDifferenceOfTheTrees)
{
    for (const auto& mutant : cases::mutants(5))
    {
        if (mutant.id != "05-media-swapped") continue;
        int triples = 0;
        for (const auto& one : grade(5, {.tracer = mutant.subject}).criteria)
        {
            EXPECT_TRUE(!one.hidden || (!one.pictures && !one.example)) << describe(one);
            if (!one.pictures) continue;
            ++triples;
            const auto& triple = *one.pictures;
            EXPECT_EQ(triple.expected.width, 64);
            EXPECT_GT(largestChannel(triple.difference.at(triple.x, triple.y)), 0.01);
            EXPECT_NE(triple.divergence, "");
            EXPECT_EQ(triple.command,
                      fmt::format("./raytree view 5 SCENE --pixel {},{} --compare exercise", triple.x, triple.y));
            EXPECT_EQ(parseScene(triple.scene, "scene.toml").camera.width, 64);
        }
        EXPECT_EQ(triples, 2);
        return;
    }
    FAIL() << "there is no mutant 05-media-swapped";
}

TEST(Examples, OfVectorsTellTheAngleBetween)
{
    auto candidate = solved(2);
    candidate.tracer.reflect = [](const V& D, const V&) { return D; };
    for (const auto& one : grade(2, candidate).criteria)
        if (one.name == "oblique" && !one.hidden)
        {
            ASSERT_TRUE(one.example && one.example->degrees) << describe(one);
            EXPECT_GT(*one.example->degrees, 20);
            EXPECT_LT(*one.example->degrees, 160);
            return;
        }
    FAIL();
}

std::string wordsOf(const QuestionSet& set, bool hidden)
{
    std::string words;
    for (const auto& one : set)
        if (one.hidden == hidden)
        {
            for (std::size_t i = 0; i < one.questions.size(); ++i)
                words += fmt::format("{} {}\n", one.questions[i].what, fmt::join(one.expected[i].values, " "));
            if (one.picture) words += sceneToToml(one.picture->scene);
        }
    return words;
}

TEST(Secrets, ChangeTheHiddenQuestionsAndNothingElse)
{
    for (const int lesson : {0, 5})
    {
        const auto a = questionSet(lesson, secret, true), b = questionSet(lesson, {"another", secret.term}, true),
                   c = questionSet(lesson, {secret.course, "2027-spring"}, true);
        EXPECT_NE(wordsOf(*a, true), wordsOf(*b, true));
        EXPECT_NE(wordsOf(*a, true), wordsOf(*c, true));
        EXPECT_NE(wordsOf(*a, true), wordsOf(*a, false));
        EXPECT_EQ(wordsOf(*a, false), wordsOf(*b, false));
    }
}

TEST(Secrets, ThatAreTheSameGiveTheSameBits)
{
    const auto before = wordsOf(*questionSet(5, secret, true), true);
    for (int i = 0; i < 50; ++i) questionSet(0, {"fills what is kept", std::to_string(i)}, false);
    EXPECT_EQ(wordsOf(*questionSet(5, secret, true), true), before);
}

TEST(Secrets, ThatAreEmptyGiveAllPointsToThePublicCriteria)
{
    double most = 0;
    for (const auto& one : grade(3, solved(3), {}).criteria)
    {
        EXPECT_FALSE(one.hidden);
        most += one.most;
    }
    EXPECT_NEAR(most, 4, 1e-12);
}

/// A candidate that misbehaves in one function. The two runs of an exercise follow each other.
Answers gradeTwice(int lesson, const std::function<Candidate(int run)>& make, const Secret& with = secret)
{
    int starts = 0;
    return gradeCandidate(
        lesson, [&] { return make(starts++ % 2); }, with);
}

TEST(TwoRuns, ThatDifferCountAsTheWorseOneAndAreSaidToDiffer)
{
    const auto answers = gradeTwice(2, [](int run) {
        auto candidate = solved(2);
        auto bits = std::make_shared<std::uint64_t>(0);
        candidate.tracer.reflect = [bits, run, honest = candidate.tracer.reflect](const V& D, const V& N) {
            *bits += std::uint64_t(run);
            return run == 0 ? honest(D, N) : D;
        };
        candidate.fingerprint = [bits] { return std::exchange(*bits, 0); };
        return candidate;
    });
    for (const auto& one : answers.criteria)
    {
        const bool about = one.exercise == "02-reflect";
        EXPECT_EQ(one.outcome, about ? Outcome::notDeterministic : Outcome::passed) << describe(one);
        EXPECT_DOUBLE_EQ(one.points, about ? 0 : one.most) << describe(one);
    }
    EXPECT_EQ(answers.remarks, std::vector<std::string>{"answers differ between two runs"});
}

TEST(TwoRuns, ThatTheClockCutShortAreNotSaidToDiffer)
{
    for (const auto ending : {Outcome::timedOut, Outcome::notRun})
    {
        const auto answers = gradeTwice(2, [ending](int run) {
            auto candidate = solved(2);
            if (run == 1)
                candidate.tracer.reflect = [ending](const V&, const V&) -> V { throw Died(ending, "it took long"); };
            candidate.fingerprint = [run] { return std::uint64_t(run); };
            return candidate;
        });
        for (const auto& one : answers.criteria)
            if (one.exercise == "02-reflect")
            {
                EXPECT_EQ(one.outcome, ending) << describe(one);
                EXPECT_EQ(one.points, 0) << describe(one);
            }
            else
                EXPECT_EQ(one.outcome, Outcome::notDeterministic) << describe(one);
    }
}

TEST(TwoRuns, CatchDeathsForEachQuestionAndKeepTheWorstOne)
{
    const auto answers = gradeTwice(5, [](int) {
        auto candidate = solved(5);
        candidate.tracer.refract = [honest = candidate.tracer.refract](const V& D, const V& N, double n1, double n2) {
            if (n1 == n2) throw Died(Outcome::timedOut, "it ran for 10 seconds");
            return honest(D, N, n1, n2);
        };
        return candidate;
    });
    for (const auto& one : answers.criteria)
    {
        if (one.name == "grazing")
        {
            EXPECT_EQ(one.outcome, Outcome::passed) << describe(one);
        }
        if (one.name != "equal and similar media" || one.exercise != "05-refract") continue;
        EXPECT_EQ(one.outcome, Outcome::timedOut);
        EXPECT_LE(one.passed, 3) << "it was asked on though it had lost";
        EXPECT_EQ(one.points, 0);
        ASSERT_EQ(one.example.has_value(), !one.hidden);
        if (one.hidden) continue;
        EXPECT_EQ(one.example->got, "it ran for 10 seconds; its points were lost then, the rest was not asked");
    }
}

/// A solved lesson 02 of which reflect dies; counts how often that happened.
Answers gradeDying(Outcome how, int& deaths)
{
    return gradeTwice(2, [how, &deaths](int) {
        auto candidate = solved(2);
        candidate.tracer.reflect = [how, &deaths](const V&, const V&) -> V {
            ++deaths;
            throw Died(how, "it died");
        };
        return candidate;
    });
}

TEST(Deaths, AreNotAskedForWhereNothingIsLeftToEarn)
{
    int publicCriteria = 0, hiddenCriteria = 0;
    for (const auto& one : *questionSet(2, secret, true))
        if (one.exercise == "02-reflect") ++(one.hidden ? hiddenCriteria : publicCriteria);
    int crashes = 0, hangs = 0;
    const auto answers = gradeDying(Outcome::crashed, crashes);
    for (const auto& one : answers.criteria)
    {
        EXPECT_EQ(one.points, one.exercise == "02-reflect" ? 0 : one.most) << describe(one);
        EXPECT_EQ(one.outcome, one.exercise != "02-reflect" ? Outcome::passed
                               : one.hidden                 ? Outcome::notRun
                                                            : Outcome::crashed);
    }
    // Three of 40 lose a criterion; no second run, and no hidden criteria when all public ones are lost.
    EXPECT_LE(crashes, 3 * publicCriteria);
    EXPECT_EQ(answers.remarks, std::vector<std::string>{
                                   "all public cases of 02-reflect ended the program, so no hidden ones were asked"});
    gradeDying(Outcome::timedOut, hangs);
    EXPECT_LE(hangs, publicCriteria + 2) << "each costs seconds: after the first criterion that is lost, one is enough";
}

TEST(Deaths, OfSeveralExercisesAreSaidToHaveOneCausePerhaps)
{
    const auto answers = gradeTwice(2, [](int) {
        auto candidate = solved(2);
        candidate.tracer.reflect = [](auto&&...) -> V { throw Died(Outcome::crashed, "it died"); };
        candidate.tracer.tree = [](auto&&...) -> RayTree { throw Died(Outcome::crashed, "it died"); };
        return candidate;
    });
    ASSERT_FALSE(answers.remarks.empty());
    EXPECT_EQ(answers.remarks[0], "the program ended, or did not answer, in 02-mirror, 02-reflect: where one of them "
                                  "calls another, mend that one first");
}

/// A lesson 02 that tells all it was ever asked: in exceptions, in answers, by dying and by being someone else each time.
Candidate tellTale(int how)
{
    auto candidate = solved(2);
    auto seen = std::make_shared<std::string>();
    const auto tell = [seen, how](const V& D) {
        *seen += text(D);
        if (how == 0) throw std::runtime_error(*seen);
        if (how == 1) throw Died(Outcome::crashed, *seen);
        return V(double(std::hash<std::string>()(*seen) % 1000));
    };
    candidate.tracer.reflect = [tell](const V& D, const V&) { return tell(D); };
    candidate.tracer.color = [tell](const SceneDescription&, const V&, const V& D) { return tell(D); };
    return candidate;
}

TEST(Secrets, DoNotReachWhatStudentsSee)
{
    for (const int how : {0, 1, 2})
    {
        const auto shown = [how](const char* with) {
            const auto answers = gradeTwice(2, [how](int) { return tellTale(how); }, {with, ""});
            std::string all = fmt::format("{}\n", fmt::join(answers.remarks, "\n"));
            for (const auto& one : answers.criteria)
            {
                if (!one.hidden) all += describe(one) + "\n";
                if (one.pictures) all += one.pictures->divergence + "\n";
                all += one.mistake + "\n";
            }
            return all;
        };
        EXPECT_EQ(shown("one secret"), shown("another secret")) << how;
    }
}

TEST(TwoRuns, CanBeInterrupted)
{
    std::atomic<bool> stop = false;
    AskOptions options;
    options.stop = &stop;
    options.progress = [&](double share) { stop = share > 0.3; };
    EXPECT_THROW(gradeCandidate(
                     2, [] { return solved(2); }, secret, options),
                 Interrupted);
}

TEST(TwoRuns, ReportTheirProgress)
{
    AskOptions options;
    std::vector<double> shares;
    options.progress = [&](double share) { shares.push_back(share); };
    gradeCandidate(
        2, [] { return solved(2); }, secret, options);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_DOUBLE_EQ(shares.back(), 1);
}

TEST(LikelyMistakes, AreNotMadeUp)
{
    auto odd = solved(5);
    odd.tracer.refract = [honest = odd.tracer.refract](const V& D, const V& N, double n1, double n2) {
        const auto T = honest(D, N, n1, n2);
        return T ? std::optional<V>(*T + 0.1 * N) : T;
    };
    odd.tracer.cosSquared2 = [](double cos1, double, double) { return cos1 * cos1 * cos1; };
    for (const auto& one : grade(5, odd, secret, true).criteria) EXPECT_EQ(one.mistake, "") << describe(one);
    for (const auto& one : grade(2, constant(0.25), secret, true).criteria) EXPECT_EQ(one.mistake, "") << describe(one);
}

TEST(Questions, AreSafeOnlyWhereRoundingDoesNotDecide)
{
    const auto scene = Build().sphere(V(0), 1).light({0, 0, 5}, 20).scene;
    EXPECT_TRUE(askTree("in the middle", scene, {0.1, 0, 4}, {0, 0, -1}).safe(1));
    EXPECT_TRUE(askColor("beside", scene, {1.1, 0, 4}, {0, 0, -1}).safe(1));
    EXPECT_FALSE(askTree("at the edge", scene, {1, 0, 4}, {0, 0, -1}).safe(1));
    EXPECT_FALSE(askColor("where float is too coarse", scene, {1e7, 0.5, 0}, {-1, 0, 0}).safe(1));
}

TEST(Uninitialised, IsSaidOfWhatIsWrongWithAPatternAndRightWithZero)
{
    auto pattern = solved(5);
    pattern.tracer.cosSquared2 = [](auto&&...) { return NAN; };
    const auto wrong = grade(5, pattern), right = grade(5, solved(5));
    EXPECT_EQ(uninitialised(wrong, right), "a variable is read before it is set, in 05-k");
    EXPECT_EQ(uninitialised(right, right), std::nullopt);
    EXPECT_EQ(uninitialised(wrong, wrong), std::nullopt);
    pattern.tracer.cosSquared2 = [](auto&&...) -> double { throw Died(Outcome::timedOut, "the machine was busy"); };
    EXPECT_EQ(uninitialised(grade(5, pattern), right), std::nullopt);
}

} // namespace

} // namespace rt::grade
