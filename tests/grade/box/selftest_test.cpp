#include <filesystem>

#include <gtest/gtest.h>

#include <unistd.h>

#include "common/process.h"
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

namespace
{

std::string ourselves()
{
    return std::filesystem::read_symlink("/proc/self/exe").string();
}

/// Runs tests of this program otherwise: under words that come before it.
ProcessResult runOtherwise(std::vector<std::string> words, const std::string& tests)
{
    for (const auto& word : {ourselves(), std::string("--gtest_also_run_disabled_tests"), "--gtest_filter=" + tests})
        words.push_back(word);
    ProcessLimits limits;
    limits.seconds = 120;
    return runProcess(words, limits);
}

} // namespace

TEST(SelfTest, DISABLED_FindsNothingThatWorks)
{
    std::string why;
    EXPECT_EQ(bestSandbox(why), std::nullopt);
    EXPECT_EQ(why.rfind("the sandbox \"bubblewrap\" does not work: the box cannot be started: ", 0), 0U) << why;
    EXPECT_NE(why.find("; the sandbox \"chroot\" does not work: "), std::string::npos) << why;
}

TEST(SelfTest, DISABLED_FallsBackToChroot)
{
    std::string why;
    EXPECT_EQ(bestSandbox(why), Sandbox::chroot);
    EXPECT_EQ(why.rfind("the sandbox \"bubblewrap\" does not work: the box cannot be started: ", 0), 0U) << why;
}

TEST(SelfTest, FallsBackWhereBubblewrapCannotRun)
{
    if (::geteuid() != 0) GTEST_SKIP() << "chroot is for root";
    const auto result =
        runOtherwise({"/usr/bin/bwrap", "--dev-bind", "/", "/", "--ro-bind", "/bin/false", "/usr/bin/bwrap", "--"},
                     "SelfTest.DISABLED_FallsBackToChroot");
    EXPECT_TRUE(result.ok()) << result.out << result.err;
    EXPECT_NE(result.out.find("1 test from 1 test suite ran"), std::string::npos) << result.out;
}

TEST(SelfTest, SaysWhyNoSandboxWorks)
{
    // In a namespace whose only user is itself, with a program in bubblewrap's place that does nothing.
    const auto result = runOtherwise({"/usr/bin/bwrap", "--unshare-user", "--uid", "0", "--gid", "0", "--dev-bind", "/",
                                      "/", "--ro-bind", "/bin/false", "/usr/bin/bwrap", "--"},
                                     "SelfTest.DISABLED_FindsNothingThatWorks");
    EXPECT_TRUE(result.ok()) << result.out << result.err;
    EXPECT_NE(result.out.find("1 test from 1 test suite ran"), std::string::npos) << result.out;
}

TEST(SelfTest, HoldsForAnOrdinaryUser)
{
    if (::geteuid() != 0) GTEST_SKIP() << "all of this runs as one";
    if (!canReach({}, ourselves())) GTEST_SKIP() << "another user cannot start this program";
    const auto result =
        runOtherwise({"/usr/bin/setpriv", "--reuid", "60580", "--regid", "60580", "--clear-groups"},
                     "SelfTest.FindsBubblewrapTight:Each/InABox.*/bubblewrap:Compiling.WorksInEverySandbox-*Ignoring*");
    EXPECT_TRUE(result.ok()) << result.out << result.err;
}

} // namespace rt::grade
