#include "lessons/lesson_main.h"

int main(int argc, char** argv)
{
    return rt::renderMain(argc, argv);
}
