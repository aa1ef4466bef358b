#include "common/program/guarded_main.h"
#include "exhibits.h"

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::lesson10::exhibitsMain(argc, argv); });
}
