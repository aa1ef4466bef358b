#include "tests/grade/exercises.h"

#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "common/program/program.h"
#include "lessons/00_geometry/exercise.h"
#include "lessons/01_direct_illumination/exercise.h"
#include "lessons/02_mirrors/exercise.h"
#include "lessons/03_partial_reflection/exercise.h"
#include "lessons/04_hdr_sky/exercise.h"
#include "lessons/05_refraction/exercise.h"
#include "lessons/06_fresnel/exercise.h"
#include "lessons/07_recursion_caps/exercise.h"
#include "lessons/08_phong/exercise.h"
#include "solved00.h"
#include "solved01.h"
#include "solved02.h"
#include "solved03.h"
#include "solved04.h"
#include "solved05.h"
#include "solved06.h"
#include "solved07.h"
#include "solved08.h"
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

const std::map<int, Exercise> exercises{
    {0, {geometry<solved00::Geometry>, geometry<exercise00::Geometry>}},
    {1, {tracer<solved01::Tracer>, tracer<exercise01::Tracer>}},
    {2, {tracer<solved02::Tracer>, tracer<exercise02::Tracer>}},
    {3, {tracer<solved03::Tracer>, tracer<exercise03::Tracer>}},
    {4, {tracer<solved04::Tracer>, tracer<exercise04::Tracer>}},
    {5, {tracer<solved05::Tracer>, tracer<exercise05::Tracer>}},
    {6, {tracer<solved06::Tracer>, tracer<exercise06::Tracer>}},
    {7, {tracer<solved07::Tracer>, tracer<exercise07::Tracer>}},
    {8, {tracer<solved08::Tracer>, tracer<exercise08::Tracer>}},
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
