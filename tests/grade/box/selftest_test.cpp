#include <gtest/gtest.h>

#include <unistd.h>

#include "tests/grade/box/box.h"

namespace rt::grade
{

TEST(SelfTest, FindsBubblewrapTight)
{
    EXPECT_EQ(selfTest({Sandbox::bubblewrap, 0}), "");
}

TEST(SelfTest, FindsTheFallbackTight)
{
    if (::geteuid() != 0) GTEST_SKIP() << "chroot is for root";
    EXPECT_EQ(selfTest({Sandbox::chroot, 0}), "");
}

TEST(SelfTest, FindsThatLimitsHoldWithoutASandbox)
{
    EXPECT_EQ(selfTest({Sandbox::none, 0}), "");
}

TEST(SelfTest, TakesTheBestThatWorks)
{
    std::string why;
    EXPECT_EQ(bestSandbox(why), Sandbox::bubblewrap);
    EXPECT_EQ(why, "");
}

} // namespace rt::grade
