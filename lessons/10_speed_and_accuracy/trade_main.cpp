#include "trade.h"

int main(int argc, char** argv)
{
    return rt::lesson10::tradeMain(argc, argv);
}
