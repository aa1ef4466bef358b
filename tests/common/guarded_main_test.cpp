#include "common/program/guarded_main.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace rt
{

namespace
{

char path[] = "bin/program";
char* arguments[] = {path, nullptr};

/// The exit code, and what stood on standard error.
template <class Work>
std::pair<int, std::string> outcomeOf(char** argv, Work work)
{
    testing::internal::CaptureStderr();
    const int code = guarded(argv, work);
    return {code, testing::internal::GetCapturedStderr()};
}

using Outcome = std::pair<int, std::string>;

} // namespace

TEST(GuardedMain, PassesTheExitCodeOn)
{
    EXPECT_EQ(outcomeOf(arguments, [] { return 3; }), Outcome(3, ""));
}

TEST(GuardedMain, AnExceptionIsASentenceAndUnwinds)
{
    bool unwound = false;
    struct Folder
    {
        bool& gone;
        ~Folder() { gone = true; }
    };
    const auto work = [&]() -> int {
        const Folder folder{unwound};
        throw std::runtime_error("exercises.toml: cannot be read");
    };
    EXPECT_EQ(outcomeOf(arguments, work), Outcome(2, "program: exercises.toml: cannot be read\n"));
    EXPECT_TRUE(unwound);
}

TEST(GuardedMain, OtherThingsThatAreThrownAreToldToo)
{
    EXPECT_EQ(outcomeOf(arguments, []() -> int { throw std::bad_alloc(); }), Outcome(2, "program: out of memory\n"));
    EXPECT_EQ(outcomeOf(arguments, []() -> int { throw 1; }),
              Outcome(2, "program: stopped by something that is no std::exception\n"));
}

TEST(GuardedMain, AProgramMayHaveNoName)
{
    char* none[] = {nullptr};
    EXPECT_EQ(outcomeOf(none, []() -> int { throw std::runtime_error("why"); }), Outcome(2, "raytree: why\n"));
}

} // namespace rt
