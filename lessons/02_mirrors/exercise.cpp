#include "exercise.h"
#include "common/program/exercise_entry.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/exercise_main.h"
#include "lessons/programs/facts.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return guarded(argv, [&] {
        return exerciseMain(exerciseEntry<2, exercise02::Tracer>(lessonFacts(2), "lessons/02_mirrors/exercise.h"),
                            exerciseFormulas<exercise02::Tracer>(), argc, argv);
    });
}
