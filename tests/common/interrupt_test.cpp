#include "common/base/interrupt.h"

#include <csignal>
#include <filesystem>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/files/text_file.h"

namespace rt
{

namespace
{

namespace fs = std::filesystem;
using std::chrono::hours;
using std::chrono::milliseconds;
using testing::ExitedWithCode;

/// What does not end is a failure: of a signal of its own, long after everything else has had its turn.
[[noreturn]] void goOnForEver()
{
    ::alarm(60);
    for (;;) std::this_thread::sleep_for(milliseconds(100));
}

TEST(InterruptDeathTest, EndsAtOnceAProgramThatDoesNotLook)
{
    const auto ended = [](int number) {
        endAtInterrupt();
        std::raise(number);
        goOnForEver();
    };
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        EXPECT_EXIT(ended(number), ExitedWithCode(130), "^interrupted: nothing was written\n$");
}

TEST(InterruptDeathTest, EndsFromOutsideAProgramThatSaidThatItLooks)
{
    EXPECT_EXIT(
        {
            watchInterrupt({.patience = milliseconds(1)});
            std::raise(SIGINT);
            goOnForEver();
        },
        ExitedWithCode(130), "^interrupted: nothing was written\n$");
    EXPECT_EXIT(
        {
            watchInterrupt({.patience = milliseconds(1), .words = [] { return std::string("half of it is there"); }});
            std::raise(SIGINT);
            goOnForEver();
        },
        ExitedWithCode(130), "^half of it is there\n$");
}

TEST(InterruptDeathTest, LetsAProgramThatLooksEndByItself)
{
    EXPECT_EXIT(
        {
            watchInterrupt({.patience = hours(1)});
            if (interrupted()) ::_exit(1);
            std::raise(SIGTERM);
            const int code = interrupted() ? sayInterrupted() : 2;
            sayInterrupted(); // not a second time
            ::_exit(code);
        },
        ExitedWithCode(130), "^interrupted: nothing was written\n$");
}

TEST(InterruptDeathTest, EndsAtOnceAtTheSecondSignal)
{
    EXPECT_EXIT(
        {
            watchInterrupt({.patience = hours(1)});
            std::raise(SIGINT);
            std::raise(SIGINT);
            goOnForEver();
        },
        ExitedWithCode(130), "^interrupted: nothing was written\n$");
}

TEST(InterruptDeathTest, LeavesAHangUpThatWasIgnoredAlone)
{
    EXPECT_EXIT(
        {
            std::signal(SIGHUP, SIG_IGN); // as nohup does
            watchInterrupt({.patience = milliseconds(1)});
            std::raise(SIGHUP);
            ::_exit(interrupted() ? 1 : 7);
        },
        ExitedWithCode(7), "^$");
}

[[noreturn]] void beInterruptedWhileDoing()
{
    endAtInterrupt();
    const auto says = [](const char* text) {
        return [text] {
            if (::write(STDERR_FILENO, text, 2) < 0) ::_exit(1);
        };
    };
    const UndoAtInterrupt first(says("a ")), second(says("b "));
    {
        const UndoAtInterrupt over(says("c "));
    }
    std::raise(SIGINT);
    goOnForEver();
}

TEST(InterruptDeathTest, UndoesTheNewestFirstAndOnlyWhatIsUnderWay)
{
    EXPECT_EXIT(beInterruptedWhileDoing(), ExitedWithCode(130), "^b a interrupted: nothing was written\n$");
}

/// Somebody writes a file, and is ended when the temporary one is open.
[[noreturn]] void beInterruptedWhileWriting(const std::string& folder)
{
    ::alarm(60);
    const auto part = fmt::format("{}/.part-{}-file.txt", folder, ::getpid());
    if (::mkfifo(part.c_str(), 0600) != 0) ::_exit(1);
    endAtInterrupt();
    std::thread([part] {
        if (::open(part.c_str(), O_RDONLY) < 0) ::_exit(1); // waits until somebody opens it to write
        std::raise(SIGINT);
    }).detach();
    writeTextFile(folder + "/file.txt", std::string(std::size_t(1) << 20, 'x')); // no pipe holds that much
    ::_exit(2);
}

TEST(InterruptDeathTest, LeavesNoHalfFile)
{
    std::string folder = (fs::temp_directory_path() / "raytree-interrupt-XXXXXX").string();
    ASSERT_TRUE(::mkdtemp(folder.data()));
    EXPECT_EXIT(beInterruptedWhileWriting(folder), ExitedWithCode(130), "^interrupted");
    EXPECT_TRUE(fs::is_empty(folder));
    fs::remove_all(folder);
}

TEST(InterruptDeathTest, DoesNotDenyWhatWasWritten)
{
    std::string folder = (fs::temp_directory_path() / "raytree-interrupt-XXXXXX").string();
    ASSERT_TRUE(::mkdtemp(folder.data()));
    EXPECT_EXIT(
        {
            endAtInterrupt();
            writeTextFile(folder + "/file.txt", "x");
            std::raise(SIGINT);
            goOnForEver();
        },
        ExitedWithCode(130), "^interrupted\n$");
    fs::remove_all(folder);
}

} // namespace

} // namespace rt
