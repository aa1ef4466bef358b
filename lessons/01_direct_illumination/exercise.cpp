#include "exercise.h"
#include "common/exercise_entry.h"
#include "lessons/entries.h"
#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return exerciseMain(
        exerciseEntry<1, exercise01::Tracer>(lesson01::entry, "lessons/01_direct_illumination/exercise.h"), argc, argv);
}
