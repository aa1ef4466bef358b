#include "exhibits.h"

int main(int argc, char** argv)
{
    return rt::lesson10::exhibitsMain(argc, argv);
}
