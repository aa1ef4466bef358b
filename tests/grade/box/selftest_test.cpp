#include <gtest/gtest.h>

#include "tests/grade/box/box.h"

namespace rt::grade
{

TEST(SelfTest, FindsBubblewrapTight)
{
    EXPECT_EQ(selfTest({Sandbox::bubblewrap, 0}), "");
}

} // namespace rt::grade
