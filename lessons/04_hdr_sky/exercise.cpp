#include "exercise.h"
#include "common/program/exercise_entry.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/exercise_main.h"
#include "lessons/programs/facts.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return guarded(argv, [&] {
        return exerciseMain(exerciseEntry<4, exercise04::Tracer>(lessonFacts(4), "lessons/04_hdr_sky/exercise.h"),
                            exerciseFormulas<exercise04::Tracer>(), argc, argv);
    });
}
