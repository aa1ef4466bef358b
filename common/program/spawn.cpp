#include "common/program/spawn.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>

#include <fmt/format.h>

#include "common/program/keeper.h"

namespace rt
{

namespace
{

[[noreturn]] void fail(const std::string& program, int error)
{
    throw std::runtime_error(fmt::format("{} cannot be started: {}", program, std::generic_category().message(error)));
}

constexpr int leastDescriptor = 16;

/// The files that a program's name stands for: it is searched in PATH if it names no folder.
std::vector<std::string> placesOf(const std::string& program)
{
    if (program.find('/') != std::string::npos) return {program};
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/bin:/usr/bin");
    std::vector<std::string> places;
    for (std::string folder; std::getline(folders, folder, ':');)
        places.push_back(folder.empty() ? program : folder + "/" + program);
    return places;
}

std::vector<char*> pointers(const std::vector<std::string>& words)
{
    std::vector<char*> result;
    for (const auto& word : words) result.push_back(const_cast<char*>(word.c_str()));
    result.push_back(nullptr);
    return result;
}

} // namespace

Pipe::Pipe(const std::string& program)
{
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) fail(program, errno);
    const Descriptor first(ends[0]), second(ends[1]);
    read.fd = ::fcntl(first.fd, F_DUPFD_CLOEXEC, leastDescriptor);
    write.fd = ::fcntl(second.fd, F_DUPFD_CLOEXEC, leastDescriptor);
    if (read.fd < 0 || write.fd < 0) fail(program, errno);
}

void setNonBlocking(const Descriptor& descriptor)
{
    ::fcntl(descriptor.fd, F_SETFL, O_NONBLOCK);
}

namespace
{

/// What the child needs is made before it is: it may call nothing but the system.
struct Start
{
    char** files; ///< what the program may be, one after the other
    char** words;
    char** environment;
    std::span<const int> descriptors;
    int nothing; ///< /dev/null
    int keeper;
    sigset_t mask;
    volatile int error = 0;
};

/// In the child, in our memory, while our thread stands still.
[[noreturn]] void become(Start& start)
{
    // Whatever signals we block or ignore, the program starts as from a shell. No handler of ours may run here: all signals
    // are still blocked.
    struct sigaction action
    {
    };
    action.sa_handler = SIG_DFL;
    for (int number = 1; number < NSIG; ++number) ::sigaction(number, &action, nullptr);
    ::setpgid(0, 0);
    // Before there is anything to kill: else who kills us right now leaves it behind.
    tellKeeper(start.keeper, '+', ::getpid());
    const int count = int(start.descriptors.size());
    for (int i = 0; i < count && !start.error; ++i)
    {
        const int from = start.descriptors[std::size_t(i)];
        if (::dup2(from < 0 ? start.nothing : from, i) < 0) start.error = errno;
    }
    ::close_range(unsigned(count), ~0U, 0);
    ::pthread_sigmask(SIG_SETMASK, &start.mask, nullptr);
    if (!*start.files) start.error = ENOENT; // PATH is empty
    if (start.error) ::_exit(1);
    // Not execvpe, which gives to the shell what is no program.
    int error = 0;
    for (char** file = start.files; *file; ++file)
    {
        ::execve(*file, start.words, start.environment);
        if (error != EACCES) error = errno; // more to the point than that another one is not there
        if (errno != EACCES && errno != ENOENT && errno != ENOTDIR) break;
    }
    start.error = error;
    ::_exit(1);
}

/// By itself: what a function has in registers may be lost after vfork.
[[gnu::noinline]] pid_t startChild(Start& start)
{
    const pid_t pid = ::vfork();
    if (pid == 0) become(start);
    return pid;
}

} // namespace

pid_t startProcess(const std::vector<std::string>& argv, std::span<const int> descriptors,
                   const std::vector<std::string>* environment)
{
    const auto places = placesOf(argv[0]);
    const auto files = pointers(places), words = pointers(argv);
    const auto names = environment ? pointers(*environment) : std::vector<char*>{};
    const Descriptor opened(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    const Descriptor nothing(::fcntl(opened.fd, F_DUPFD_CLOEXEC, leastDescriptor));
    if (nothing.fd < 0) fail(argv[0], errno);
    Start start{.files = const_cast<char**>(files.data()),
                .words = const_cast<char**>(words.data()),
                .environment = environment ? const_cast<char**>(names.data()) : environ,
                .descriptors = descriptors,
                .nothing = nothing.fd,
                .keeper = keeper(),
                .mask = {}};
    // posix_spawn would do most of this, but it cannot tell the keeper.
    sigset_t all, before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    const pid_t pid = startChild(start);
    const int failed = pid < 0 ? errno : start.error;
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (pid > 0 && failed)
    {
        forgetProcess(pid);
        while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR)
        {
        }
    }
    if (failed) fail(argv[0], failed);
    return pid;
}

void forgetProcess(pid_t pid)
{
    tellKeeper(keeper(), '-', pid);
}

std::string signalText(int number)
{
    const char* known = ::sigdescr_np(number);
    std::string text = known ? known : fmt::format("signal {}", number);
    if (text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' && text[1] >= 'a' && text[1] <= 'z')
        text[0] = char(text[0] - 'A' + 'a');
    return text;
}

} // namespace rt
