#include "exercise.h"
#include "common/program/exercise_entry.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/exercise_main.h"
#include "lessons/programs/facts.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return guarded(argv, [&] {
        return exerciseMain(
            exerciseEntry<7, exercise07::Tracer>(lessonFacts(7), "lessons/07_recursion_caps/exercise.h"),
            exerciseFormulas<exercise07::Tracer>(), argc, argv);
    });
}
