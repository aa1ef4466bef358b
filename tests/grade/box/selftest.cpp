#include <array>
#include <cmath>
#include <stdexcept>

#include <unistd.h>

#include <fmt/format.h>

#include "tests/grade/box/box.h"
#include "tests/grade/box/child.h"

namespace rt::grade
{

namespace
{

// Seconds: far more than anything here needs, as a machine that grades is busy. Where the sandbox holds, nobody waits.
constexpr double patience = 30;

/// What the probe does; empty: as it should.
using Finding = std::string;

/// All that is refused with an error.
Finding listed(const Box& box)
{
    Limits limits;
    limits.cpuSeconds = 1;
    Child child(box, GRADE_PROBE, limits);
    child.send("list\n", patience);
    std::string worked;
    const std::string end = ".survived";
    while (worked.size() < end.size() || worked.compare(worked.size() - end.size(), end.size(), end) != 0)
        if (child.receive(worked, 1, patience) != Child::Got::all)
            return fmt::format("the probe did not answer: {}", child.finish().sentence);
    if (worked == end) return "";
    return fmt::format("a program in the box can {}", worked.substr(0, worked.find('\n')));
}

/// What must kill it.
Finding forbidden(const Box& box, const std::string& word)
{
    Limits limits;
    limits.cpuSeconds = 1;
    Child child(box, GRADE_PROBE, limits);
    child.send(word + "\n", patience);
    std::string ignored;
    const auto got = child.receive(ignored, 1, patience);
    const auto end = child.finish();
    if (got == Child::Got::ended && end.outcome == Outcome::forbiddenCall) return "";
    return fmt::format("trying {} did not end the probe", word);
}

Finding memory(const Box& box)
{
    Limits limits;
    limits.cpuSeconds = 1;
    limits.memory = std::size_t(64) << 20;
    Child child(box, GRADE_PROBE, limits);
    child.send("memory\n", patience);
    std::string ignored;
    child.receive(ignored, 1, patience);
    return child.finish().outcome == Outcome::outOfMemory ? ""
                                                          : "a program in the box can use more memory than its limit";
}

Finding triedAll(const Box& box)
{
    // This one takes its second beside the others.
    Limits limits;
    limits.cpuSeconds = 1;
    limits.wallSeconds = 2 * patience; // its second of processor time must end it, not the clock
    Child spinning(box, GRADE_PROBE, limits);
    spinning.send("cpu\n", patience);

    Finding found;
    if (box.sandbox != Sandbox::none)
    {
        found = listed(box);
        for (const char* word : {"socket", "ptrace", "kill", "signal", "memfd_create", "mount", "unshare",
                                 "io_uring_setup", "bpf", "keyctl", "process_vm_readv", "code"})
            if (found.empty()) found = forbidden(box, word);
    }
    if (found.empty()) found = memory(box);
    if (!found.empty()) return found;
    std::string ignored;
    spinning.receive(ignored, 1, patience);
    const auto end = spinning.finish();
    if (end.outcome != Outcome::timedOut || !end.byItself)
        return "a program in the box can use more processor time than its limit";
    return "";
}

} // namespace

std::string selfTest(const Box& box)
{
    try
    {
        const auto found = triedAll(box);
        return found.empty() ? "" : fmt::format("the sandbox \"{}\" is not tight: {}", name(box.sandbox), found);
    }
    catch (const std::exception& error)
    {
        return fmt::format("the sandbox \"{}\" does not work: {}", name(box.sandbox), error.what());
    }
}

std::optional<Sandbox> bestSandbox(std::string& why)
{
    why.clear();
    for (const auto sandbox : {Sandbox::bubblewrap, Sandbox::chroot})
    {
        const auto reason = selfTest({sandbox, 0});
        if (reason.empty()) return sandbox;
        why += (why.empty() ? "" : "; ") + reason;
    }
    return std::nullopt;
}

} // namespace rt::grade
