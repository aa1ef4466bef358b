#include "tests/grade/exercises.h"

#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "common/program/program.h"
#include "lessons/00_geometry/exercise.h"
#include "lessons/exercises.h"
#include "lessons/list.h"
#include "lessons/solved.h"
#include "solved00.h"
#include "tests/cases/run_cases.h"
#include "tests/grade/questions/manifest.h"

namespace rt::grade
{

namespace
{

template <class Geometry>
Candidate geometry()
{
    return {.geometry = cases::geometrySubject<Geometry>()};
}

template <class Tracer>
Candidate tracer()
{
    return {.tracer = cases::exerciseSubject<Tracer>()};
}

struct Exercise
{
    Candidate (*solved)();
    Candidate (*untouched)();
};

const std::map<int, Exercise> exercises{{0, {geometry<solved00::Geometry>, geometry<exercise00::Geometry>}},
#define RAYTREE_ROW(number, NN) {number, {tracer<solved##NN::Tracer>, tracer<exercise##NN::Tracer>}},
                                        RAYTREE_FOR_EACH_LESSON(RAYTREE_ROW)
#undef RAYTREE_ROW
};

// The other tests go through exerciseLessons(): what it leaves out, they would leave out in silence.
TEST(Exercises, AreThoseOfTheFoldersAndOfTheManifest)
{
    std::set<int> folders, here;
    for (const auto& folder : std::filesystem::directory_iterator(projectFile("lessons")))
        if (std::filesystem::exists(folder.path() / "exercise.h"))
            folders.insert(std::stoi(folder.path().filename().string()));
    for (const auto& [lesson, exercise] : exercises) here.insert(lesson);
    const auto listed = exerciseLessons();
    EXPECT_EQ(std::set(listed.begin(), listed.end()), folders) << "lessons/exercises.toml";
    EXPECT_EQ(here, folders) << "the table above";
}

} // namespace

Candidate solved(int lesson)
{
    return exercises.at(lesson).solved();
}

Candidate untouched(int lesson)
{
    return exercises.at(lesson).untouched();
}

} // namespace rt::grade
