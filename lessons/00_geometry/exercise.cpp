#include "exercise.h"
#include "common/program/guarded_main.h"
#include "lessons/00_geometry/tutorial.h"

int main(int argc, char** argv)
{
    using namespace rt;
    return guarded(argv, [&] {
        return lesson00::geometryMain(lesson00::functionsOf<exercise00::Geometry>(), "exercise00", nullptr, argc, argv);
    });
}
