#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include "tests/grade/box/child.h"
#include "tests/grade/box/machine.h"

namespace rt::grade
{

namespace
{

constexpr double patience = 20;

Limits shortLimits()
{
    Limits limits;
    limits.cpuSeconds = 1;
    limits.wallSeconds = patience;
    limits.memory = std::size_t(64) << 20;
    limits.textBytes = std::size_t(1) << 20;
    return limits;
}

Box boxOf(Sandbox sandbox)
{
    return {sandbox, 7};
}

/// Every box that this machine and user can make.
class InABox : public testing::TestWithParam<Sandbox>
{
protected:
    void SetUp() override
    {
        if (GetParam() == Sandbox::bubblewrap && !noBubblewrap().empty()) GTEST_SKIP() << noBubblewrap();
    }

    /// How the probe ends that is told to misbehave.
    Child::End endOf(const std::string& word, Limits limits = shortLimits(), double seconds = patience)
    {
        Child child(boxOf(GetParam()), GRADE_PROBE, limits);
        child.send(word + "\n", seconds);
        std::string ignored;
        child.receive(ignored, 8, seconds);
        return child.finish();
    }
};

std::string nameOf(const testing::TestParamInfo<Sandbox>& info)
{
    return name(info.param);
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Each, InABox, testing::ValuesIn(sandboxesHere()), nameOf);

TEST_P(InABox, AProgramAnswersAndEndsWell)
{
    Child child(boxOf(GetParam()), GRADE_PROBE, shortLimits());
    for (int i = 0; i < 3; ++i)
    {
        ASSERT_TRUE(child.send("echo\n", patience));
        std::string got;
        ASSERT_EQ(child.receive(got, 12, patience), Child::Got::all);
        EXPECT_EQ(got, "echosurvived");
    }
    const auto end = child.finish();
    EXPECT_EQ(end.outcome, Outcome::passed) << end.sentence;
    EXPECT_TRUE(end.byItself);
    EXPECT_EQ(end.exitCode, 0);
    EXPECT_EQ(end.sentence, "");
}

TEST_P(InABox, TextOfBothKindsIsJoinedAndIsNoAnswer)
{
    Child child(boxOf(GetParam()), GRADE_PROBE, shortLimits());
    child.send("print\n", patience);
    std::string got;
    EXPECT_EQ(child.receive(got, 9, patience), Child::Got::all);
    EXPECT_EQ(got, "psurvived");
    child.finish();
    EXPECT_NE(child.text().find("seen\n"), std::string::npos) << child.text();
    EXPECT_NE(child.text().find("error\n"), std::string::npos) << child.text();
}

TEST_P(InABox, EachDeathHasItsOutcome)
{
    EXPECT_EQ(endOf("segfault").sentence,
              "it crashed (segmentation fault: a bad index or pointer, or a recursion without an end)");
    EXPECT_EQ(endOf("segfault").outcome, Outcome::crashed);
    EXPECT_EQ(endOf("stack").outcome, Outcome::crashed);
    EXPECT_EQ(endOf("abort").sentence, "it crashed (aborted)");
    EXPECT_EQ(endOf("throw").sentence.substr(0, 52), "it crashed (nobody caught an exception of type std::");
    EXPECT_EQ(endOf("memory").sentence, "it needs more than 64 MiB of memory");
    EXPECT_EQ(endOf("memory").outcome, Outcome::outOfMemory);
    EXPECT_EQ(endOf("exit3").sentence, "it ended with code 3");
    EXPECT_EQ(endOf("exit3").outcome, Outcome::crashed);
    const auto well = endOf("exit0");
    EXPECT_EQ(well.outcome, Outcome::passed);
    EXPECT_TRUE(well.byItself);
}

TEST_P(InABox, ForbiddenCallsKill)
{
    if (GetParam() == Sandbox::none)
    {
        EXPECT_EQ(endOf("socket").outcome, Outcome::passed) << "without a sandbox nothing is forbidden";
        return;
    }
    for (const char* word : {"socket", "kill", "ptrace", "i386"})
    {
        const auto end = endOf(word);
        EXPECT_EQ(end.outcome, Outcome::forbiddenCall) << word << ": " << end.sentence;
    }
}

TEST_P(InABox, EndlessLoopsAreStopped)
{
    const auto end = endOf("cpu");
    EXPECT_EQ(end.outcome, Outcome::timedOut);
    EXPECT_EQ(end.sentence, "it needs more than 1 s of processor time");
    EXPECT_GT(end.cpuSeconds, 0.5);
    EXPECT_LT(end.cpuSeconds, 2.5);
}

TEST_P(InABox, IgnoringTheLimitOfProcessorTimeHelpsForASecond)
{
    const auto end = endOf("ignore");
    EXPECT_EQ(end.outcome, Outcome::timedOut) << end.sentence;
}

TEST_P(InABox, SleepersAreLate)
{
    const auto end = endOf("sleep", shortLimits(), 0.2);
    EXPECT_EQ(end.outcome, Outcome::timedOut);
    EXPECT_EQ(end.sentence, "it did not answer within 0.2 s");
    Limits limits = shortLimits();
    limits.wallSeconds = 0.3;
    EXPECT_EQ(endOf("sleep", limits).sentence, "it was stopped after 0.3 s");
}

TEST_P(InABox, FloodsOfTextAreStopped)
{
    const auto end = endOf("text");
    EXPECT_EQ(end.outcome, Outcome::protocol);
    EXPECT_EQ(end.sentence, "it was stopped after printing 1 MiB of text");
}

TEST_P(InABox, FloodsOfAnswersWaitForAReader)
{
    Child child(boxOf(GetParam()), GRADE_PROBE, shortLimits());
    child.send("answers\n", patience);
    std::string got;
    EXPECT_EQ(child.receive(got, 100, patience), Child::Got::all);
    EXPECT_EQ(got, std::string(100, 'x'));
    EXPECT_FALSE(child.finish().byItself);
}

TEST_P(InABox, ClosingEverythingIsNoticed)
{
    const auto end = endOf("close", shortLimits(), 1);
    EXPECT_TRUE(end.outcome == Outcome::protocol || end.outcome == Outcome::timedOut) << end.sentence;
}

TEST_P(InABox, NotReadingIsNoticed)
{
    Child child(boxOf(GetParam()), GRADE_PROBE, shortLimits());
    ASSERT_TRUE(child.send("sleep\n", patience));
    EXPECT_FALSE(child.send(std::string(1 << 20, 'x'), 0.2));
    EXPECT_EQ(child.finish().sentence, "it did not read its questions within 0.2 s");
}

TEST_P(InABox, WritingToTheDeadIsNoDeath)
{
    Child child(boxOf(GetParam()), GRADE_PROBE, shortLimits());
    child.send("exit0\n", patience);
    std::string ignored;
    EXPECT_EQ(child.receive(ignored, 1, patience), Child::Got::ended);
    EXPECT_FALSE(child.send(std::string(1 << 20, 'x'), 1));
}

TEST_P(InABox, NothingIsLeftBehind)
{
    for (const char* word : {"sleep", "exit0", "segfault"}) endOf(word, shortLimits(), 0.05);
    {
        Child abandoned(boxOf(GetParam()), GRADE_PROBE, shortLimits());
        abandoned.send("sleep\n", patience);
    }
    // What a killed program had started may reach us a moment later as an orphan, dead or dying: it is buried here.
    // As process 1 we have one that lives on: the keeper, whose parent has gone.
    const bool isFirst = ::getpid() == 1;
    const int most = isFirst ? 100 : 30000; // times 10 ms: only what lives on takes that
    pid_t left = 0;
    for (int i = 0; i < most && (left = ::waitpid(-1, nullptr, WNOHANG)) != -1; ++i) ::usleep(10000);
    EXPECT_EQ(left, isFirst ? 0 : -1) << "a child is left";
}

TEST_P(InABox, SeveralThreadsHaveTheirOwn)
{
    std::vector<std::thread> threads;
    std::vector<int> well(4, 0);
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&, i] {
            for (int round = 0; round < 3; ++round)
            {
                Child child({GetParam(), i}, GRADE_PROBE, shortLimits());
                std::string got;
                child.send("echo\n", patience);
                if (child.receive(got, 12, patience) == Child::Got::all && child.finish().exitCode == 0)
                    ++well[std::size_t(i)];
            }
        });
    for (auto& thread : threads) thread.join();
    for (const int count : well) EXPECT_EQ(count, 3);
}

TEST(Box, SaysWhenItCannotStart)
{
    EXPECT_THROW(Child({Sandbox::bubblewrap, 0}, "/no/such/program", {}), std::runtime_error);
    if (!noBubblewrap().empty()) GTEST_SKIP() << noBubblewrap();
    Command command;
    command.argv = {"/usr/bin/bwrap", "--json-status-fd", "4", "--no-such-option"};
    command.reportsStatus = true;
    command.shown = "the program";
    try
    {
        Child child(command, {});
        FAIL() << "it started";
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_STREQ(error.what(), "the box cannot be started: bwrap: Unknown option --no-such-option");
    }
}

TEST(Box, AMissingProgramInTheBoxIsNoFaultOfTheStudents)
{
    if (!noBubblewrap().empty()) GTEST_SKIP() << noBubblewrap();
    auto command = runCommand({Sandbox::bubblewrap, 0}, {}, GRADE_PROBE, "");
    for (auto& word : command.argv)
        if (word == GRADE_PROBE) word = "/no/such/program";
    Child child(command, {});
    EXPECT_THROW(child.finish(), std::runtime_error);
}

} // namespace rt::grade
