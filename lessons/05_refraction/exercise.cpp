#include "exercise.h"
#include "common/program/exercise_entry.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/exercise_main.h"
#include "lessons/programs/facts.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return guarded(argv, [&] {
        return exerciseMain(exerciseEntry<5, exercise05::Tracer>(lessonFacts(5), "lessons/05_refraction/exercise.h"),
                            exerciseFormulas<exercise05::Tracer>(), argc, argv);
    });
}
