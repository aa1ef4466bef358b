#include <filesystem>

#include <gtest/gtest.h>

#include "common/program/process.h"
#include "tests/grade/box/box.h"
#include "tests/grade/box/machine.h"
#include "tests/grade/box/temporary_folder.h"

namespace rt::grade
{

TEST(SelfTest, FindsBubblewrapTight)
{
    if (!noBubblewrap().empty()) GTEST_SKIP() << noBubblewrap();
    EXPECT_EQ(selfTest({Sandbox::bubblewrap, 0}), "");
}

TEST(SelfTest, FindsTheFallbackTight)
{
    EXPECT_EQ(selfTest({Sandbox::chroot, 0}),
              isRoot() ? "" : "the sandbox \"chroot\" does not work: the sandbox \"chroot\" is for root only");
}

TEST(SelfTest, FindsThatLimitsHoldWithoutASandbox)
{
    EXPECT_EQ(selfTest({Sandbox::none, 0}), "");
}

TEST(SelfTest, TakesTheBestThatWorks)
{
    if (!noBubblewrap().empty()) GTEST_SKIP() << noBubblewrap();
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
    limits.seconds = 600;
    return runProcess(words, limits);
}

/// What comes before a program for which bubblewrap does not work; nothing where it does not work anyway.
std::vector<std::string> withoutBubblewrap(std::vector<std::string> user = {})
{
    if (!noBubblewrap().empty()) return {};
    std::vector<std::string> words = {"/usr/bin/bwrap"};
    words.insert(words.end(), user.begin(), user.end());
    for (const char* word : {"--dev-bind", "/", "/", "--ro-bind", "/bin/false", "/usr/bin/bwrap", "--"})
        words.push_back(word);
    return words;
}

/// Opens the way to the project for other users, for the command that follows: where a folder above it is closed to them, as
/// root's home is, an open one with nothing but the project in it takes its place in a mount namespace of its own.
constexpr const char* openWay = R"sh(
set -e
project=$1 open=$2; shift 2
closed=$project
way=""
while [ "$closed" != / ]; do
    closed=$(dirname "$closed")
    case "$(stat -c %A "$closed")" in *x | *t) ;; *) way=$closed ;; esac
done
if [ -n "$way" ]; then
    umask 022
    mkdir -p "$open/${project#"$way"/}"
    mount --bind "$project" "$open/${project#"$way"/}"
    mount --rbind "$open" "$way"
fi
exec setpriv --reuid 60580 --regid 60580 --clear-groups "$@"
)sh";

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
    // chroot is for root: for others nothing is left.
    const auto result = runOtherwise(withoutBubblewrap(), isRoot() ? "SelfTest.DISABLED_FallsBackToChroot"
                                                                   : "SelfTest.DISABLED_FindsNothingThatWorks");
    EXPECT_TRUE(result.ok()) << result.out << result.err;
    EXPECT_NE(result.out.find("1 test from 1 test suite ran"), std::string::npos) << result.out;
}

TEST(SelfTest, SaysWhyNoSandboxWorks)
{
    // In a namespace whose only user is itself, with a program in bubblewrap's place that does nothing.
    if (!noBubblewrap().empty()) GTEST_SKIP() << noBubblewrap();
    const auto result = runOtherwise(withoutBubblewrap({"--unshare-user", "--uid", "0", "--gid", "0"}),
                                     "SelfTest.DISABLED_FindsNothingThatWorks");
    EXPECT_TRUE(result.ok()) << result.out << result.err;
    EXPECT_NE(result.out.find("1 test from 1 test suite ran"), std::string::npos) << result.out;
}

TEST(SelfTest, HoldsForAnOrdinaryUser)
{
    if (!isRoot()) return; // all of this runs as one
    if (!noBubblewrap().empty()) GTEST_SKIP() << noBubblewrap();
    const TemporaryFolder open;
    const auto result =
        runOtherwise({"/usr/bin/unshare", "--mount", "--propagation", "private", "sh", "-c", openWay, "sh",
                      RAYTREE_SOURCE_DIR, open.path},
                     "SelfTest.FindsBubblewrapTight:Each/InABox.*/bubblewrap:Compiling.WorksInEverySandbox-*Ignoring*");
    EXPECT_TRUE(result.ok()) << result.out << result.err;
}

} // namespace rt::grade
