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
            exerciseEntry<1, exercise01::Tracer>(lessonFacts(1), "lessons/01_direct_illumination/exercise.h"),
            exerciseFormulas<exercise01::Tracer>(), argc, argv);
    });
}
