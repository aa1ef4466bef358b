#include "exercise.h"
#include "common/exercise_entry.h"
#include "lessons/entries.h"
#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return exerciseMain(exerciseEntry<6, exercise06::Tracer>(lesson06::entry, "lessons/06_fresnel/exercise.h"), argc,
                        argv);
}
