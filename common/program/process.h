// Runs another program that may hang, crash or write without end: a student's exercise.
#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

namespace rt
{

struct ProcessLimits
{
    double seconds = 10;                             ///< of wall time; infinity: no limit
    std::size_t outputBytes = std::size_t(64) << 20; ///< of standard output, and of standard error
    const std::atomic<bool>* stop = nullptr;         ///< once true, the program is stopped
};

struct ProcessResult
{
    int exitCode = -1; ///< -1 if it did not end by itself
    int signal = 0;    ///< that ended it; 0: none
    bool timedOut = false, tooMuchOutput = false, stopped = false;
    double seconds = 0;         ///< of wall time that it ran
    std::size_t mostOutput = 0; ///< the limit that it had
    std::string out;            ///< standard output, at most the limit
    std::string err;            ///< the last 64 KiB of standard error

    bool ok() const { return exitCode == 0 && signal == 0 && !timedOut && !tooMuchOutput && !stopped; }
};

/// Runs argv[0], searched in PATH, without a shell and with an empty standard input, and waits for it to end. It gets a
/// process group of its own, all of which is killed at a limit and when the program itself has ended; none of it is
/// left behind, also if we are killed, unless it leaves the group on purpose: this is no sandbox. It dumps no core, and cannot
/// use more processor time than the limit gives all processors together. May be called from
/// several threads. Throws std::runtime_error with one sentence if the program cannot be started.
ProcessResult runProcess(const std::vector<std::string>& argv, const ProcessLimits& limits = {});

/// The words of a command as a shell splits them: 'single quotes', "double quotes" and \ work; nothing is expanded.
/// Throws std::runtime_error with one sentence if a quote is not closed.
std::vector<std::string> splitCommand(const std::string& command);

/// One sentence without a full stop: "exercise06 was stopped after 10 s without an answer", "exercise06 crashed
/// (aborted): what(): no root" (the last lines of its standard error), "exercise06 ended with code 2: bad scene" (the first
/// line). Empty if ok().
std::string describeFailure(const std::string& what, const ProcessResult& result);

} // namespace rt
