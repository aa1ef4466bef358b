#include "lessons/entries.h"
#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    return rt::lessonMain(rt::lesson08::entry, argc, argv);
}
