// Where a student's program runs: it sees its own code, three pipes, and nothing else. DESIGN.md, "The box", says why each
// part is there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rt::grade
{

enum class Sandbox
{
    bubblewrap, ///< own namespaces, an empty file system, no system calls but those for computing
    chroot,     ///< the same without namespaces; for root, where bubblewrap cannot run
    none        ///< limits only: for code that one trusts
};

const char* name(Sandbox sandbox); ///< "bubblewrap", "chroot", "none"

/// Of one process. Answers are limited by who reads them.
struct Limits
{
    double cpuSeconds = 10;                        ///< rounded up to whole seconds
    double wallSeconds = 24;                       ///< since the start
    std::size_t memory = std::size_t(512) << 20;   ///< bytes of address space
    std::size_t textBytes = std::size_t(16) << 20; ///< of standard output and error together
};

/// Workers of one grader differ in their number, from 0: as root, each worker runs as an own user that owns nothing.
struct Box
{
    Sandbox sandbox = Sandbox::bubblewrap;
    int worker = 0;
};

/// "" if a program in the box can neither read, write, connect, start nor disturb anything, nor exceed its limits; else one
/// sentence without a full stop that names what was not refused. Takes about a second. For Sandbox::none only the limits.
std::string selfTest(const Box& box);

/// Bubblewrap if its self-test succeeds, else chroot if that does, else nothing; `why` says why the better ones are not.
std::optional<Sandbox> bestSandbox(std::string& why);

/// How a process is started in a box. Words in argv may name descriptors 4 and 5, see below.
struct Command
{
    std::vector<std::string> argv;
    std::vector<std::string> environment; ///< NAME=value; all of it
    std::string filter;                   ///< if not empty: what descriptor 5 gives, a BPF program for seccomp
    bool reportsStatus = false;           ///< it writes bubblewrap's --json-status-fd to descriptor 4
    std::string shown;                    ///< what messages call it: "the program"
};

/// Runs `program`, a static binary. `folder`: empty and read-only, for Sandbox::chroot.
Command runCommand(const Box& box, const Limits& limits, const std::string& program, const std::string& folder);

/// What the compiler may see besides itself and the system's headers, and where it writes.
struct CompilePlaces
{
    std::string kit;    ///< read only
    std::string source; ///< a folder with one file, read only
    std::string out;    ///< a folder; the only place to write
    std::string root;   ///< for Sandbox::chroot: a folder that holds all these and the compiler, and nothing else
};

/// As they are called inside the box.
CompilePlaces placesInside(const Box& box, const CompilePlaces& outside);

/// Runs compiler[0] with the rest as arguments, which name places as they are inside. `fileBytes`: the largest file.
Command compileCommand(const Box& box, const Limits& limits, const CompilePlaces& outside, std::size_t fileBytes,
                       const std::vector<std::string>& compiler);

/// The user that worker's programs run as; ourselves, if we are not root.
unsigned userOf(const Box& box);

/// Can that user follow the path? Always, if we are not root.
bool canReach(const Box& box, const std::string& path);

} // namespace rt::grade
