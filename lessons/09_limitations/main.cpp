#include "common/program/guarded_main.h"
#include "pairs.h"

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::lesson09::limitationsMain(argc, argv); });
}
