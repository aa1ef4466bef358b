#include "pairs.h"

int main(int argc, char** argv)
{
    return rt::lesson09::limitationsMain(argc, argv);
}
