#include "common/program/guarded_main.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/lesson_main.h"

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::lessonMain(rt::lesson02::entry, argc, argv); });
}
