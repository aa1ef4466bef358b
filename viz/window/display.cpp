#include "viz/window/display.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/program/program.h"
#include "viz/window/display_probe.h"

namespace rt::viz
{

namespace
{

/// For what takes a tenth of a second on an idle machine, and some seconds over a slow network.
constexpr auto patience = std::chrono::seconds(30);

/// In the child. It ends without destructors and exit handlers, which belong to the parent.
[[noreturn]] void answerInto(int pipe, bool forWindow)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // A crash is an answer, too: no core is dumped.
    for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(crash, [](int) { _exit(1); });
    std::atexit([] { _exit(1); }); // of all handlers the last one is called first
    for (const int stop : {SIGINT, SIGTERM, SIGHUP}) std::signal(stop, SIG_DFL);
    // What drivers say when they fail is said again, in one sentence.
    if (const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC); nowhere >= 0)
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    DisplayAnswer answer;
    probeDisplay(answer, forWindow);
    const auto written = write(pipe, &answer, sizeof answer);
    _exit(written == sizeof answer ? 0 : 1);
}

enum class Ended
{
    answered,
    early,
    late
};

Ended readAnswer(int pipe, DisplayAnswer& answer)
{
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + patience;
    auto* bytes = reinterpret_cast<char*>(&answer);
    std::size_t known = 0;
    while (known < sizeof answer)
    {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0 || interrupted()) return Ended::late;
        pollfd wait{pipe, POLLIN, 0};
        if (poll(&wait, 1, int(left)) <= 0) continue; // time or a signal: looked at above
        const auto got = read(pipe, bytes + known, sizeof answer - known);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return Ended::early;
        known += std::size_t(got);
    }
    return Ended::answered;
}

} // namespace

DisplayFacts askDisplay(bool forWindow)
{
    DisplayFacts facts;
    const char* name = std::getenv("DISPLAY");
    if (!name || !*name)
    {
        facts.lacks = "there is no display";
        return facts;
    }
    int ends[2];
    pid_t child = -1;
    if (pipe2(ends, O_CLOEXEC) == 0 && (child = fork()) == 0) answerInto(ends[1], forWindow);
    if (child < 0)
    {
        facts.lacks = fmt::format("no process to ask the display {} can be started ({})", name, std::strerror(errno));
        return facts;
    }
    close(ends[1]);
    DisplayAnswer answer;
    const auto ended = readAnswer(ends[0], answer);
    close(ends[0]);
    if (ended == Ended::late) kill(child, SIGKILL);
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR)
    {
    }
    if (ended == Ended::late)
        facts.lacks = fmt::format("the display {} does not answer", name);
    else if (ended == Ended::early)
        facts.lacks = fmt::format("the display {} or its OpenGL driver crashes when it is asked", name);
    else if (*answer.lacks)
        facts.lacks = fmt::format("the display {} {}", name, answer.lacks);
    facts.area = answer.area;
    facts.frame = answer.frame;
    facts.scale = answer.scale;
    return facts;
}

} // namespace rt::viz
