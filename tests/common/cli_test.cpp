#include "common/cli.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "common/picture_module.h"

namespace rt
{

namespace
{

TEST(RunMain, HasACodeOfItsOwnForWhatNeedsOpenImageIO)
{
    CommandLine app("a program", "program");
    unsetenv("RAYTREE_DOOR");
    char name[] = "program";
    char* argv[] = {name, nullptr};
    testing::internal::CaptureStderr();
    const int code = runMain(app, 1, argv, []() -> int { throw NeedsOpenImageIO("sky.hdr"); });
    EXPECT_TRUE(testing::internal::GetCapturedStderr().starts_with("sky.hdr: "));
    EXPECT_EQ(code, exitNeedsOpenImageIO);
    // What reads a scene makes a mistake in the scene of every runtime_error.
    static_assert(!std::is_base_of_v<std::runtime_error, NeedsOpenImageIO>);
}

} // namespace

} // namespace rt
