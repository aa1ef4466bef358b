#include "common/guarded_main.h"
#include "viz/viewer_main.h"

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::viz::viewerMain(argc, argv); });
}
