#include "exercise.h"
#include "common/exercise_entry.h"
#include "lessons/entries.h"
#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return exerciseMain(exerciseEntry<8, exercise08::Tracer>(lesson08::entry, "lessons/08_phong/exercise.h"), argc,
                        argv);
}
