#include "exercise.h"
#include "common/exercise_entry.h"
#include "lessons/entries.h"
#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return exerciseMain(exerciseEntry<4, exercise04::Tracer>(lesson04::entry, "lessons/04_hdr_sky/exercise.h"), argc,
                        argv);
}
