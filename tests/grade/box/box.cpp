#include "tests/grade/box/box.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <unistd.h>

#include <fmt/format.h>

#include "tests/grade/box/seccomp.h"

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// In the range that systemd's list of users leaves free, and below 65536, as containers often have no more.
constexpr unsigned firstUser = 60'600;

void append(Words& to, const Words& more)
{
    to.insert(to.end(), more.begin(), more.end());
}

/// Another user before anything else: the limit of processes does not hold for root.
Words asUser(const Box& box)
{
    if (::geteuid() != 0) return {};
    const auto user = std::to_string(userOf(box));
    return {"/usr/bin/setpriv", "--reuid", user, "--regid", user, "--clear-groups", "--no-new-privs"};
}

Words limited(const Limits& limits, std::size_t fileBytes, int files, int processes)
{
    const auto seconds = (long long)std::ceil(limits.cpuSeconds);
    // A signal first, which says why; the program may ignore it, but not the second.
    Words words = {"/usr/bin/prlimit",
                   fmt::format("--cpu={}:{}", seconds, seconds + 1),
                   fmt::format("--as={}", limits.memory),
                   fmt::format("--fsize={}", fileBytes),
                   "--core=0",
                   fmt::format("--nofile={}", files)};
    // An ordinary user has other processes too, and the limit counts all of them.
    if (::geteuid() == 0) words.push_back(fmt::format("--nproc={}", processes));
    return words;
}

/// No namespace is shared, none can be made; no privilege, no terminal; it dies with us.
Words bubblewrap()
{
    return {"/usr/bin/bwrap",    "--unshare-user",
            "--unshare-all",     "--disable-userns",
            "--die-with-parent", "--new-session",
            "--cap-drop",        "ALL",
            "--hostname",        "box",
            "--json-status-fd",  "4"};
}

} // namespace

const char* name(Sandbox sandbox)
{
    switch (sandbox)
    {
    case Sandbox::bubblewrap:
        return "bubblewrap";
    case Sandbox::chroot:
        return "chroot";
    case Sandbox::none:
        return "none";
    }
    return "unknown";
}

unsigned userOf(const Box& box)
{
    // Graders that run at the same time, as shards do, should not share the limit of processes.
    constexpr unsigned graders = 16, workers = 32;
    return ::geteuid() == 0 ? firstUser + unsigned(::getpid()) % graders * workers + unsigned(box.worker) % workers
                            : ::geteuid();
}

bool canReach(const Box& box, const std::string& path)
{
    if (::geteuid() != 0) return true;
    (void)box; // its user owns nothing and is in no group
    std::error_code error;
    fs::path place = fs::canonical(path, error);
    if (error) return false;
    if ((fs::status(place, error).permissions() & fs::perms::others_read) == fs::perms::none) return false;
    while (place.has_relative_path())
    {
        place = place.parent_path();
        if ((fs::status(place, error).permissions() & fs::perms::others_exec) == fs::perms::none) return false;
    }
    return true;
}

Command runCommand(const Box& box, const Limits& limits, const std::string& program, const std::string& folder)
{
    constexpr int files = 16, processes = 64; // several boxes may share a user
    Command command;
    command.shown = "the program";
    const auto bounds = limited(limits, 0, files, processes);
    if (box.sandbox == Sandbox::bubblewrap)
    {
        command.argv = asUser(box);
        append(command.argv, bounds);
        append(command.argv, bubblewrap());
        append(command.argv, {"--seccomp", "5", "--ro-bind", program, "/program", "--remount-ro", "/", "--chdir", "/",
                              "--", "/program"});
        command.filter = seccompFilter();
        command.reportsStatus = true;
    }
    else if (box.sandbox == Sandbox::chroot)
    {
        if (::geteuid() != 0) throw std::runtime_error("the sandbox \"chroot\" is for root only");
        command.argv = bounds;
        append(command.argv, {GRADE_LAUNCH, folder, std::to_string(userOf(box)), program});
        command.filter = seccompFilter();
    }
    else
    {
        command.argv = asUser(box);
        append(command.argv, bounds);
        command.argv.push_back(program);
    }
    return command;
}

CompilePlaces placesInside(const Box& box, const CompilePlaces& outside)
{
    if (box.sandbox == Sandbox::bubblewrap) return {"/kit", "/source", "/out", ""};
    if (box.sandbox == Sandbox::none) return outside;
    const auto below = outside.root.size();
    return {outside.kit.substr(below), outside.source.substr(below), outside.out.substr(below), "/"};
}

Command compileCommand(const Box& box, const Limits& limits, const CompilePlaces& outside, std::size_t fileBytes,
                       const Words& compiler)
{
    constexpr int files = 256, processes = 256;
    Command command;
    command.shown = "the compiler";
    // Who changes the root folder must still be root.
    command.argv = box.sandbox == Sandbox::chroot ? Words{"/usr/bin/setpriv", "--no-new-privs"} : asUser(box);
    append(command.argv, limited(limits, fileBytes, files, processes));
    command.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C", "TMPDIR=" + placesInside(box, outside).out};
    if (box.sandbox == Sandbox::bubblewrap)
    {
        append(command.argv, bubblewrap());
        append(command.argv, {"--ro-bind", "/usr", "/usr"});
        for (const char* folder : {"/bin", "/lib", "/lib64"})
        {
            std::error_code error;
            if (fs::is_symlink(folder))
                append(command.argv, {"--symlink", fs::read_symlink(folder, error).string(), folder});
            else if (fs::is_directory(folder))
                append(command.argv, {"--ro-bind", folder, folder});
        }
        append(command.argv, {"--ro-bind", outside.kit, "/kit", "--ro-bind", outside.source, "/source", "--bind",
                              outside.out, "/out", "--remount-ro", "/", "--chdir", "/source", "--"});
        command.reportsStatus = true;
    }
    if (box.sandbox == Sandbox::chroot)
    {
        if (::geteuid() != 0) throw std::runtime_error("the sandbox \"chroot\" is for root only");
        append(command.argv,
               {"/usr/sbin/chroot", fmt::format("--userspec=+{0}:+{0}", userOf(box)), "--groups=", outside.root});
    }
    append(command.argv, compiler);
    return command;
}

} // namespace rt::grade
