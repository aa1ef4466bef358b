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
            exerciseEntry<3, exercise03::Tracer>(lessonFacts(3), "lessons/03_partial_reflection/exercise.h"),
            exerciseFormulas<exercise03::Tracer>(), argc, argv);
    });
}
