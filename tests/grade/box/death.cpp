#include "tests/grade/box/death.h"

#include <csignal>

#include <fmt/format.h>

#include "common/program/spawn.h"

namespace rt::grade
{

namespace
{

/// What the C++ library prints last when nobody caught std::bad_alloc. A program that only prints it gains nothing.
bool wantedMemory(const std::string& text)
{
    constexpr std::size_t end = 400;
    const auto last = text.substr(text.size() > end ? text.size() - end : 0);
    return last.find("std::bad_alloc") != std::string::npos;
}

std::string tooMuchMemory(const Limits& limits)
{
    return fmt::format("it needs more than {} of memory", inMiB(limits.memory));
}

/// As the C++ library names the exception that nobody caught; empty: none.
std::string uncaught(const std::string& text)
{
    const std::string start = "terminate called after throwing an instance of '";
    const auto place = text.rfind(start);
    if (place == std::string::npos) return "";
    const auto from = place + start.size();
    constexpr std::size_t longest = 80;
    return text.substr(from, std::min(text.find('\'', from) - from, longest));
}

Child::End bySignal(const Death& death)
{
    // Processor time is counted in ticks; a kill that near to the limit is the limit's.
    constexpr double nearly = 0.05;
    const auto& limits = death.limits;
    if (death.signal == SIGXCPU || (death.signal == SIGKILL && death.cpuSeconds > limits.cpuSeconds - nearly))
        return {Outcome::timedOut,
                fmt::format("it needs more than {} of processor time", inSeconds(limits.cpuSeconds))};
    if (death.signal == SIGKILL) return {Outcome::outOfMemory, "it was killed, perhaps for want of memory"};
    if (death.signal == SIGSYS)
        return {Outcome::forbiddenCall, "it asked the operating system for something that the box refuses"};
    if (death.signal == SIGABRT && wantedMemory(death.text)) return {Outcome::outOfMemory, tooMuchMemory(limits)};
    if (death.signal == SIGABRT)
    {
        const auto what = uncaught(death.text);
        return {Outcome::crashed, what.empty()
                                      ? "it crashed (aborted)"
                                      : fmt::format("it crashed (nobody caught an exception of type {})", what)};
    }
    if (death.signal == SIGSEGV)
        return {Outcome::crashed,
                "it crashed (segmentation fault: a bad index or pointer, or a recursion without an end)"};
    return {Outcome::crashed, fmt::format("it crashed ({})", signalText(death.signal))};
}

} // namespace

std::string inSeconds(double seconds)
{
    return fmt::format("{:.3g} s", seconds);
}

std::string inMiB(std::size_t bytes)
{
    return fmt::format("{:.4g} MiB", double(bytes) / double(1 << 20));
}

Child::End explainDeath(const Death& death)
{
    Child::End end;
    if (death.flooded)
        end = {Outcome::protocol,
               fmt::format("it was stopped after printing {} of text", inMiB(death.limits.textBytes))};
    else if (!death.late.empty())
        end = {Outcome::timedOut, death.late};
    else if (death.signal != 0)
        end = bySignal(death);
    else if (death.exitCode > 0)
        end = {Outcome::crashed, fmt::format("it ended with code {}", death.exitCode)};
    else if (death.exitCode < 0 && death.closedAnswers)
        end = {Outcome::protocol, "it closed the descriptor of its answers"};
    end.exitCode = death.signal == 0 ? death.exitCode : -1;
    end.byItself = death.signal != 0 || death.exitCode >= 0;
    end.cpuSeconds = death.cpuSeconds;
    return end;
}

} // namespace rt::grade
