#include "common/program/guarded_main.h"
#include "trade.h"

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::lesson10::tradeMain(argc, argv); });
}
