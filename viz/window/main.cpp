#include "common/program/guarded_main.h"
#include "viz/window/viewer_main.h"

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::viz::viewerMain(argc, argv); });
}
