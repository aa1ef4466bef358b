#include "exercise.h"
#include "common/program/exercise_entry.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/exercise_main.h"
#include "lessons/programs/facts.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return guarded(argv, [&] {
        return exerciseMain(exerciseEntry<8, exercise08::Tracer>(lessonFacts(8), "lessons/08_phong/exercise.h"),
                            exerciseFormulas<exercise08::Tracer>(), argc, argv);
    });
}
