#include "common/program/guarded_main.h"
#include "lessons/10_speed_and_accuracy/study/exhibits.h"

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::lesson10::exhibitsMain(argc, argv); });
}
