// Lesson 00: the cases in three scalar types, on the solved exercise and on the untouched one; the program and its figures.
#include <filesystem>

#include <gtest/gtest.h>

#include "common/files/text_file.h"
#include "lessons/00_geometry/exercise.h"
#include "lessons/00_geometry/geometry.h"
#include "lessons/00_geometry/tutorial.h"
#include "solved00.h"
#include "tests/cases/lesson00_cases.h"

namespace rt::cases
{

namespace
{

using lesson00::V2;
using lesson00::V3;

class GeometryCaseTest : public testing::Test
{
public:
    GeometryCaseTest(const GeometryCase& one, const GeometrySubject& of) : which(one), subject(of) {}

    void TestBody() override
    {
        const Check check = runCase(which, subject);
        EXPECT_GT(check.checked, 0) << "the case checks nothing";
        for (const auto& failure : check.failures)
            ADD_FAILURE() << "Slide: " << which.slide << "\n  " << failure.what << "\n  expected " << failure.expected
                          << "\n  got      " << failure.got;
    }

private:
    GeometryCase which;
    GeometrySubject subject;
};

bool registerCases(const char* suite, const GeometrySubject& subject)
{
    for (const auto& which : geometryCases())
        testing::RegisterTest(suite, fmt::format("{}_{}", which.group, which.name).c_str(), nullptr, nullptr, __FILE__,
                              __LINE__,
                              [which, subject]() -> testing::Test* { return new GeometryCaseTest(which, subject); });
    return true;
}

[[maybe_unused]] const bool registered =
    registerCases("Lesson00Float", geometrySubject<lesson00::Geometry<float>>()) &&
    registerCases("Lesson00Double", geometrySubject<lesson00::Geometry<double>>()) &&
    registerCases("Lesson00LongDouble", geometrySubject<lesson00::Geometry<long double>>()) &&
    registerCases("Solved00", geometrySubject<solved00::Geometry>());

TEST(Exercise00, IsNotAttemptedInAnyCase)
{
    for (const auto& which : geometryCases())
        EXPECT_THROW(runCase(which, geometrySubject<exercise00::Geometry>()), NotAttempted)
            << which.group << " " << which.name;
}

// The tutorial's numbers, to twelve digits.
TEST(Lesson00, AnswersTheTutorialToTwelveDigits)
{
    using G = lesson00::Geometry<double>;
    const auto slope = G::slopeIntercept({-3, 0}, {2, 2});
    ASSERT_TRUE(slope);
    EXPECT_NEAR(slope->a, 0.4, 1e-12);
    EXPECT_NEAR(slope->b, 1.2, 1e-12);
    EXPECT_NEAR(G::yAt(*slope, -3), 0, 1e-12);
    EXPECT_NEAR(G::yAt(*slope, 2), 2, 1e-12);
    const auto line = G::implicitForm({-3, 0}, {2, 2});
    EXPECT_NEAR(line.A, 2, 1e-12);
    EXPECT_NEAR(line.B, -5, 1e-12);
    EXPECT_NEAR(line.C, 6, 1e-12);
    const auto [n1, n2] = G::normals(line);
    EXPECT_EQ(n1, G::vec2(2, -5));
    EXPECT_EQ(n2, G::vec2(-2, 5));
    EXPECT_NEAR(G::distanceToOrigin(line), 6 / std::sqrt(29.0), 1e-12);
    EXPECT_NEAR(G::withUnitNormal(line).C, 6 / std::sqrt(29.0), 1e-12);
    EXPECT_NEAR(G::segmentLength({-4, 1, 1}, {2, 2, 5}), std::sqrt(53.0), 1e-12);
    EXPECT_EQ(G::parametricForm({-4, 1, 1}, {2, 2, 5}).D, G::vec3(6, 1, 4));
}

TEST(Lesson00, FindsUnitNormalsOfVeryLongAndVeryShortDirections)
{
    using G = lesson00::Geometry<double>;
    for (const double scale : {1e-300, 1e-160, 1e160, 1e300})
        for (const auto& D : {V3(6, 1, 4), V3(0, 1, 0), V3(-1, 0, 0), V3(0, 0, 1)})
        {
            const auto N = G::unitNormal({G::vec3(0), scale * D}, 1);
            EXPECT_NEAR(length(N), 1, 1e-14);
            EXPECT_NEAR(dot(N, D), 0, 1e-14);
        }
}

/// Runs the program; standard output and standard error.
struct Run
{
    int code;
    std::string out, err;
};

Run run(std::vector<std::string> arguments, bool exercise = false)
{
    arguments.insert(arguments.begin(), "program");
    std::vector<char*> argv;
    for (auto& argument : arguments) argv.push_back(argument.data());
    const auto functions =
        exercise ? lesson00::functionsOf<exercise00::Geometry>() : lesson00::functionsOf<lesson00::Geometry<double>>();
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = lesson00::geometryMain(functions, "program", exercise ? nullptr : &lesson00::tutorialSteps(),
                                            int(argv.size()), argv.data());
    const std::string out = testing::internal::GetCapturedStdout();
    return {code, out, testing::internal::GetCapturedStderr()};
}

TEST(Program00, PrintsTheTutorialsAnswers)
{
    const auto [code, out, err] = run({});
    EXPECT_EQ(code, 0);
    EXPECT_EQ(err, "");
    for (const char* words : {"y = 0.4x + 1.2\n", "2x - 5y + 6 = 0\n", "(2, -5)", "(-2, 5)", "distance = 1.11417\n",
                              "sqrt(29)", "sqrt(53)", "length = 7.28011\n", "(-4, 1, 1) + t (6, 1, 4)\n", "315°"})
        EXPECT_NE(out.find(words), std::string::npos) << words;
}

TEST(Program00, TakesOtherLines)
{
    const auto [code, out, err] = run({"--line2", "-1,1,-1,5", "--line3", "0,0,0,0,-2,0"});
    EXPECT_EQ(code, 0);
    for (const char* words : {"none: the line is vertical, x = -1\n", "4x + 4 = 0\n", "length = 2\n"})
        EXPECT_NE(out.find(words), std::string::npos) << words;
    EXPECT_EQ(out.find("nan"), std::string::npos);
    EXPECT_EQ(out.find("inf"), std::string::npos);
}

TEST(Program00, RefusesBadInputWithOneSentence)
{
    using Arguments = std::vector<std::string>;
    for (const auto& arguments : {Arguments{"--line2", "1,1,1,1"},
                                  {"--line2", "1,2,3"},
                                  {"--line2", ""},
                                  {"--line2", "1,2,3,x"},
                                  {"--line3", "1,2,3,4,5,nan"},
                                  {"--line3", "1,2,3,1,2,3"},
                                  {"--line3", "1e7,0,0,0,0,0"},
                                  {"--nonsense"},
                                  {"--figures", "no/such/folder"},
                                  {"--figures", ""},
                                  {"3"}})
    {
        const auto [code, out, err] = run(arguments);
        EXPECT_EQ(code, 2) << arguments[0];
        EXPECT_EQ(out, "") << arguments[0];
        EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
    }
}

TEST(Program00, SaysWhatAnExerciseHasNotAttempted)
{
    const auto [code, out, err] = run({}, true);
    EXPECT_EQ(code, 0);
    for (const char* id : {"00-slope", "00-implicit", "00-length", "00-parametric", "00-normals-3d", "00-circle"})
        EXPECT_NE(out.find(fmt::format("not attempted: {}\n", id)), std::string::npos) << id;
    EXPECT_EQ(out.find("0.4"), std::string::npos) << "gives the answer away";
}

class Figures00 : public testing::Test
{
protected:
    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("raytree_lesson00_test_" + std::to_string(getpid()));
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::size_t files() const { return std::size_t(std::distance(std::filesystem::directory_iterator(folder), {})); }
};

TEST_F(Figures00, AreThoseOfTheNotes)
{
    EXPECT_EQ(run({"--figures", folder.string()}).code, 0);
    EXPECT_EQ(files(), 4u);
    for (const char* name : {"00_exercise_1.svg", "00_exercise_2a.svg", "00_exercise_2b.svg", "00_exercise_3.svg"})
        EXPECT_EQ(readTextFile((folder / name).string()),
                  readTextFile(std::string(RAYTREE_SOURCE_DIR) + "/slides-notes/pictures/" + name))
            << "stale: run ./raytree lesson 0 --figures slides-notes/pictures";
}

TEST_F(Figures00, OfAnUntouchedExerciseAreOnlyThoseOfExerciseTwo)
{
    const auto [code, out, err] = run({"--figures", folder.string()}, true);
    EXPECT_EQ(code, 0);
    EXPECT_EQ(files(), 2u);
    EXPECT_NE(err.find("00_exercise_1.svg is not drawn: exercise 00-slope has not been attempted"), std::string::npos);
}

TEST(Figures, AreFiniteForAllKindsOfLines)
{
    const auto functions = lesson00::functionsOf<lesson00::Geometry<double>>();
    for (const V2& Q : {V2(1, 5), V2(1, -1e6), V2(-7, 0), V2(1.000001, 0), V2(-1e6, 1e6), V2(2, 0)})
        for (const V3& D : {V3(1, 0, 0), V3(0, 1e-6, 0), V3(0, 0, -1e6), V3(1e6, -1e6, 1e6), V3(3, -2, 1)})
            for (const auto& figure : lesson00::figures(functions, {{1, 0}, Q, V3(0), D}))
                EXPECT_TRUE(figure.why.empty()) << figure.name << ": " << figure.why;
}

TEST(Figures, AreNotDrawnFromNonsense)
{
    auto functions = lesson00::functionsOf<lesson00::Geometry<double>>();
    functions.normals2 = [](const auto&) { return std::pair(V2(NAN), V2(NAN)); };
    functions.unitNormal = [](const auto&, double) { return V3(INFINITY); };
    const auto drawn = lesson00::figures(functions, {});
    EXPECT_EQ(drawn[0].why, "its numbers are not finite");
    EXPECT_EQ(drawn[3].why, "its numbers are not finite");
    EXPECT_TRUE(drawn[0].svg.empty());
}

} // namespace

} // namespace rt::cases
