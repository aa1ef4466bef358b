#include "exercise.h"
#include "common/exercise_entry.h"
#include "lessons/entries.h"
#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return exerciseMain(exerciseEntry<5, exercise05::Tracer>(lesson05::entry, "lessons/05_refraction/exercise.h"), argc,
                        argv);
}
