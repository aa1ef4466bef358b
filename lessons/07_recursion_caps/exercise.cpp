#include "exercise.h"
#include "common/exercise_entry.h"
#include "lessons/entries.h"
#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return exerciseMain(exerciseEntry<7, exercise07::Tracer>(lesson07::entry, "lessons/07_recursion_caps/exercise.h"),
                        argc, argv);
}
