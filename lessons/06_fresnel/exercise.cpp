#include "exercise.h"
#include "common/program/exercise_entry.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/exercise_main.h"
#include "lessons/programs/facts.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return guarded(argv, [&] {
        return exerciseMain(exerciseEntry<6, exercise06::Tracer>(lessonFacts(6), "lessons/06_fresnel/exercise.h"),
                            exerciseFormulas<exercise06::Tracer>(), argc, argv);
    });
}
