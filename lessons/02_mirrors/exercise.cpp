#include "exercise.h"
#include "common/exercise_entry.h"
#include "lessons/entries.h"
#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return exerciseMain(exerciseEntry<2, exercise02::Tracer>(lesson02::entry, "lessons/02_mirrors/exercise.h"), argc,
                        argv);
}
