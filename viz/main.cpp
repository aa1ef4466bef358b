#include "viz/viewer_main.h"

int main(int argc, char** argv)
{
    return rt::viz::viewerMain(argc, argv);
}
