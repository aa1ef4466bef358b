#include "common/program/guarded_main.h"
#include "lessons/00_geometry/geometry.h"
#include "lessons/00_geometry/tutorial.h"

int main(int argc, char** argv)
{
    using namespace rt::lesson00;
    return rt::guarded(
        argv, [&] { return geometryMain(functionsOf<Geometry<double>>(), "lesson00", &tutorialSteps(), argc, argv); });
}
