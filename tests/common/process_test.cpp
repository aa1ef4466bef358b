#include "common/program/process.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rt
{

namespace
{

constexpr double patience = 300; // seconds: only what hangs takes them

ProcessResult shell(const std::string& script, const ProcessLimits& limits = {.seconds = patience})
{
    return runProcess({"sh", "-c", script}, limits);
}

std::string refusal(const std::vector<std::string>& argv)
{
    try
    {
        runProcess(argv);
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "started";
}

int openDescriptors()
{
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) count += !entry.path().empty();
    return count;
}

/// Gone, if need be soon; what runs has no zombie either, as its parent is gone and somebody else buries it.
bool isGone(const std::string& line)
{
    const auto pid = std::to_string(std::stoi(line));
    for (int i = 0; i < int(patience) * 100; ++i)
    {
        if (::kill(std::stoi(pid), 0) != 0) return true;
        std::string state;
        std::ifstream status("/proc/" + pid + "/stat");
        for (int word = 0; word < 3; ++word) status >> state;
        if (state == "Z" || state == "X") return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

/// No test may leave a child or a file behind.
class RunProcess : public testing::Test
{
protected:
    static void SetUpTestSuite() { shell("true"); } // starts the keeper, who stays

    int before = openDescriptors();

    void TearDown() override
    {
        EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
        EXPECT_EQ(openDescriptors(), before);
    }
};

TEST_F(RunProcess, GivesOutputAndExitCode)
{
    const auto result = shell("printf 'a b\\n'; echo complaint >&2; exit 3");
    EXPECT_EQ(result.out, "a b\n");
    EXPECT_EQ(result.err, "complaint\n");
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(result.signal, 0);
    EXPECT_FALSE(result.ok());
    EXPECT_EQ(describeFailure("exercise06", result), "exercise06 ended with code 3: complaint");
}

TEST_F(RunProcess, TakesArgumentsAsTheyAre)
{
    EXPECT_EQ(runProcess({"printf", "%s|", "a b", "", "$HOME", "'\"", "*"}).out, "a b||$HOME|'\"|*|");
}

TEST_F(RunProcess, MayWriteNothing)
{
    const auto result = runProcess({"true"});
    EXPECT_TRUE(result.ok());
    EXPECT_EQ(result.out + result.err, "");
    EXPECT_EQ(describeFailure("true", result), "");
}

TEST_F(RunProcess, StopsWhatHangs)
{
    auto result = shell("echo early; exec sleep 600", {.seconds = 0.2});
    EXPECT_TRUE(result.timedOut);
    EXPECT_EQ(result.out, "early\n");
    EXPECT_EQ(result.exitCode, -1);
    EXPECT_GE(result.seconds, 0.2);
    EXPECT_LT(result.seconds, patience) << "it waited for the program";
    result.seconds = 0.2; // how long it took depends on the machine, what is said of it does not
    EXPECT_EQ(describeFailure("exercise06", result), "exercise06 was stopped after 0.2 s without an answer");
}

TEST_F(RunProcess, StopsWhatHangsWithItsOutputClosed)
{
    const auto result = shell("exec sleep 600 >&- 2>&-", {.seconds = 0.2});
    EXPECT_TRUE(result.timedOut);
}

TEST_F(RunProcess, StopsWhatIgnoresSignals)
{
    const auto result = shell("trap '' TERM INT HUP PIPE; while :; do :; done", {.seconds = 0.2});
    EXPECT_TRUE(result.timedOut);
}

TEST_F(RunProcess, StopsTheChildrenToo)
{
    const auto result = shell("sleep 600 & echo $!; wait", {.seconds = 0.2});
    EXPECT_TRUE(result.timedOut);
    EXPECT_TRUE(isGone(result.out)) << result.out;
}

TEST_F(RunProcess, DoesNotWaitForChildrenThatOutliveIt)
{
    const auto result = shell("sleep 600 & echo $!");
    EXPECT_TRUE(result.ok());
    EXPECT_LT(result.seconds, patience) << "it waited for the child";
    EXPECT_TRUE(isGone(result.out)) << result.out;
}

TEST_F(RunProcess, DoesNotWaitForChildrenThatLeaveTheGroup)
{
    const auto result = shell("setsid sleep 600 & echo $!");
    EXPECT_TRUE(result.ok());
    EXPECT_LT(result.seconds, patience) << "it waited for the child";
    const pid_t child = std::stoi("0" + result.out);
    EXPECT_TRUE(child > 0 && ::kill(child, SIGKILL) == 0) << "it was not left: " << result.out;
}

TEST_F(RunProcess, GivesAllThatWasWrittenBeforeTheEnd)
{
    for (int i = 0; i < 20; ++i)
    {
        const auto result = shell("head -c 3000000 /dev/zero; head -c 60000 /dev/zero >&2");
        EXPECT_EQ(result.out.size(), 3000000U);
        EXPECT_EQ(result.err.size(), 60000U);
    }
}

TEST_F(RunProcess, GivesAllThatALargePipeHolds)
{
    const char* script = "import fcntl, os; fcntl.fcntl(1, 1031, 1 << 20); os.write(1, bytes(1 << 20))"; // F_SETPIPE_SZ
    for (int i = 0; i < 5; ++i) EXPECT_EQ(runProcess({"python3", "-c", script}).out.size(), std::size_t(1) << 20);
}

TEST_F(RunProcess, ReadsBothFloodsAtOnce)
{
    const auto result = shell("head -c 20000000 /dev/zero >&2 & head -c 20000000 /dev/zero; wait; echo last >&2");
    EXPECT_TRUE(result.ok());
    EXPECT_EQ(result.out.size(), 20000000U);
    EXPECT_EQ(result.err.size(), 65536U);
    EXPECT_EQ(result.err.substr(65530), std::string(1, '\0') + "last\n");
}

TEST_F(RunProcess, StopsAFloodAtTheLimit)
{
    const auto result = runProcess({"yes"}, {.outputBytes = 1 << 20});
    EXPECT_TRUE(result.tooMuchOutput);
    EXPECT_EQ(result.out.size(), std::size_t(1) << 20);
    EXPECT_EQ(describeFailure("yes", result), "yes wrote more than 1 MiB to standard output");
}

TEST_F(RunProcess, AcceptsOutputUpToTheLimit)
{
    EXPECT_TRUE(runProcess({"printf", "12345678"}, {.outputBytes = 8}).ok());
    const auto result = runProcess({"printf", "123456789"}, {.outputBytes = 8});
    EXPECT_TRUE(result.tooMuchOutput);
    EXPECT_EQ(result.out, "12345678");
}

TEST_F(RunProcess, StopsAFloodOfComplaints)
{
    const auto result = shell("exec yes >&2", {.seconds = patience, .outputBytes = 1 << 20});
    EXPECT_TRUE(result.tooMuchOutput);
    EXPECT_FALSE(result.timedOut);
    EXPECT_EQ(result.err.size(), 65536U);
}

TEST_F(RunProcess, NamesACrash)
{
    const auto result = shell("kill -SEGV $$");
    EXPECT_EQ(result.signal, SIGSEGV);
    EXPECT_EQ(result.exitCode, -1);
    EXPECT_EQ(describeFailure("exercise06", result), "exercise06 crashed (segmentation fault)");
    EXPECT_EQ(describeFailure("it", shell("kill -ABRT $$")), "it crashed (aborted)");
    EXPECT_EQ(describeFailure(
                  "it", shell("printf 'one\\ntwo\\n\\n terminate called\\n  what():  no root\\n' >&2; kill -ABRT $$")),
              "it crashed (aborted): two; terminate called; what():  no root");
    EXPECT_EQ(describeFailure("it", shell("kill -KILL $$")), "it was killed from outside, perhaps for want of memory");
}

TEST_F(RunProcess, SaysWhyItCannotStart)
{
    EXPECT_EQ(refusal({}), "no program is named");
    EXPECT_EQ(refusal({""}), "no program is named");
    EXPECT_EQ(refusal({"raytree-no-such-program"}),
              "raytree-no-such-program cannot be started: No such file or directory");
    EXPECT_EQ(refusal({"/no/such/folder/program"}),
              "/no/such/folder/program cannot be started: No such file or directory");
    EXPECT_EQ(refusal({"/"}), "/ cannot be started: Permission denied");
    EXPECT_EQ(refusal({"/etc/passwd"}), "/etc/passwd cannot be started: Permission denied");
    EXPECT_EQ(refusal({"true", std::string("a\0b", 3)}), "a command cannot hold zero bytes");
}

TEST_F(RunProcess, SaysThatAFileIsNoProgram)
{
    const auto file = testing::TempDir() + "raytree_no_program_" + std::to_string(::getpid());
    std::ofstream(file) << "no program\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    EXPECT_EQ(refusal({file}), file + " cannot be started: Exec format error");
    std::filesystem::remove(file);
}

TEST_F(RunProcess, IsStoppedByAFlag)
{
    std::atomic<bool> stop = false;
    std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stop = true;
    });
    const auto result = runProcess({"sleep", "600"}, {.seconds = 2 * patience, .stop = &stop});
    other.join();
    EXPECT_TRUE(result.stopped);
    EXPECT_FALSE(result.timedOut);
    EXPECT_LT(result.seconds, patience) << "it waited for the program";
    EXPECT_EQ(describeFailure("sleep", result), "sleep was stopped");
}

TEST_F(RunProcess, ReturnsSoonAfterTheEnd)
{
    // The quickest of many, beside the quickest that the system's own call needs for the same: a wait of 100 ms is 50 times that.
    const auto quickest = [](auto work) {
        auto least = std::chrono::steady_clock::duration::max();
        for (int i = 0; i < 40; ++i)
        {
            const auto start = std::chrono::steady_clock::now();
            work();
            least = std::min(least, std::chrono::steady_clock::now() - start);
        }
        return std::chrono::duration<double>(least).count();
    };
    const double theirs = quickest([] { return std::system("exec true"); });
    EXPECT_LT(quickest([] { runProcess({"true"}); }), 20 * theirs) << "waits although the program has ended";
}

TEST_F(RunProcess, WorksFromSeveralThreads)
{
    std::vector<std::thread> threads;
    std::atomic<int> right = 0;
    for (int t = 0; t < 8; ++t)
        threads.emplace_back([&right, t] {
            for (int i = 0; i < 10; ++i)
            {
                const auto word = fmt::format("{} {}\n", t, i);
                const auto result = shell(fmt::format("head -c 100000 /dev/zero >&2; printf '{}'; exit {}", word, t));
                right += result.out == word && result.exitCode == t && result.err.size() == 65536;
            }
        });
    // Threads that hang must not keep the others' pipes open.
    threads.emplace_back([] { runProcess({"sleep", "600"}, {.seconds = 0.5}); });
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(right, 80);
}

TEST_F(RunProcess, InheritsNeitherFilesNorSignals)
{
    const int file = ::open("/dev/null", O_RDONLY); // without O_CLOEXEC
    const auto old = ::signal(SIGPIPE, SIG_IGN);
    const auto result = shell("for i in 0 1 2 3 4 5 6 7 8 9 10 11 12; do test -e /proc/$$/fd/$i && echo $i; done;"
                              "sed -n 's/^SigIgn:.*\\(........\\)$/\\1/p' /proc/$$/status");
    ::signal(SIGPIPE, old);
    ::close(file);
    constexpr unsigned long own = 0x80000000; // signal 32, which glibc keeps for itself
    ASSERT_EQ(result.out.substr(0, 6), "0\n1\n2\n");
    EXPECT_EQ(std::stoul(result.out.substr(6), nullptr, 16) & ~own, 0U) << result.out;
}

TEST_F(RunProcess, LimitsProcessorTimeAndCores)
{
    const unsigned all = (unsigned(patience) + 1) * std::max(1U, std::thread::hardware_concurrency());
    // A shell sees limits that are set just after its start only later.
    const std::string wait = "while [ $(ulimit -t) = unlimited ]; do sleep 0.01; done; ";
    EXPECT_EQ(shell(wait + "ulimit -t; ulimit -c").out, fmt::format("{}\n0\n", all));
    EXPECT_EQ(shell("sleep 0.1; ulimit -t", {.seconds = HUGE_VAL}).out, "unlimited\n");
}

/// In a process of its own, which may do what it likes with its signals and descriptors.
bool worksAfter(void (*strange)())
{
    const pid_t pid = ::fork();
    if (pid == 0)
    {
        strange();
        const auto result = shell("cat; echo out; echo err >&2");
        ::_exit(result.out == "out\n" && result.err == "err\n" && !result.timedOut ? 0 : 1);
    }
    int status = -1;
    ::waitpid(pid, &status, 0);
    return status == 0;
}

TEST_F(RunProcess, HasAnEmptyInputWhateverOursIs)
{
    EXPECT_TRUE(worksAfter([] {
        ::close(STDIN_FILENO);
        ::open("/etc/passwd", O_RDONLY);
    }));
}

TEST_F(RunProcess, WorksWithoutStandardStreams)
{
    EXPECT_TRUE(worksAfter([] {
        for (const int fd : {0, 1, 2}) ::close(fd);
    }));
}

TEST_F(RunProcess, WorksWhereTheStatusOfChildrenIsIgnored)
{
    EXPECT_TRUE(worksAfter([] { ::signal(SIGCHLD, SIG_IGN); }));
}

TEST(SplitCommand, SplitsLikeAShell)
{
    using Words = std::vector<std::string>;
    EXPECT_EQ(splitCommand(""), Words{});
    EXPECT_EQ(splitCommand("  \t\n "), Words{});
    EXPECT_EQ(splitCommand(" a  b\tc "), (Words{"a", "b", "c"}));
    EXPECT_EQ(splitCommand("'a b' \"c  d\" e' 'f"), (Words{"a b", "c  d", "e f"}));
    EXPECT_EQ(splitCommand("'' \"\""), (Words{"", ""}));
    EXPECT_EQ(splitCommand(R"(a\ b \' "\"\\\$\n" '\')"), (Words{"a b", "'", "\"\\$\\n", "\\"}));
    EXPECT_EQ(splitCommand("$HOME * ~ ; | `a`"), (Words{"$HOME", "*", "~", ";", "|", "`a`"}));
    EXPECT_EQ(splitCommand("--x=\"a b\"c"), (Words{"--x=a bc"}));
}

TEST(SplitCommand, AgreesWithTheShell)
{
    for (const std::string command : {R"(a\ b "c\d" 'e\f' "g'h" 'i"j' k''l "" m\\n "o\\p" "\`q\`")"})
    {
        auto argv = splitCommand(command);
        std::string ours;
        for (const auto& word : argv) ours += word + "|";
        EXPECT_EQ(ours, shell("printf '%s|' " + command).out);
    }
}

TEST(SplitCommand, RefusesAQuoteThatIsNotClosed)
{
    EXPECT_THROW(splitCommand("a 'b"), std::runtime_error);
    EXPECT_THROW(splitCommand("a \"b\\\""), std::runtime_error);
    EXPECT_THROW(splitCommand("a \\"), std::runtime_error);
}

TEST(DescribeFailure, QuotesTheFirstLineThatSaysAnything)
{
    const auto text = [](const std::string& err) {
        ProcessResult result;
        result.exitCode = 2;
        result.err = err;
        return describeFailure("x", result);
    };
    EXPECT_EQ(text(""), "x ended with code 2");
    EXPECT_EQ(text("\n  \n"), "x ended with code 2");
    EXPECT_EQ(text("\n  bad scene \r\nmore"), "x ended with code 2: bad scene");
    EXPECT_EQ(text("a\x1b[31mb\n"), "x ended with code 2: a [31mb");
    EXPECT_EQ(text(std::string(1000, 'a')), "x ended with code 2: " + std::string(200, 'a'));
}

} // namespace

} // namespace rt
