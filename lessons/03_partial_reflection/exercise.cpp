#include "exercise.h"
#include "common/exercise_entry.h"
#include "lessons/entries.h"
#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return exerciseMain(
        exerciseEntry<3, exercise03::Tracer>(lesson03::entry, "lessons/03_partial_reflection/exercise.h"), argc, argv);
}
