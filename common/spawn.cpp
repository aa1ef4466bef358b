#include "common/spawn.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>

#include <fmt/format.h>

namespace rt
{

namespace
{

[[noreturn]] void fail(const std::string& program, int error)
{
    throw std::runtime_error(fmt::format("{} cannot be started: {}", program, std::generic_category().message(error)));
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
    constexpr int least = 16;
    read.fd = ::fcntl(first.fd, F_DUPFD_CLOEXEC, least);
    write.fd = ::fcntl(second.fd, F_DUPFD_CLOEXEC, least);
    if (read.fd < 0 || write.fd < 0) fail(program, errno);
}

void setNonBlocking(const Descriptor& descriptor)
{
    ::fcntl(descriptor.fd, F_SETFL, O_NONBLOCK);
}

pid_t startProcess(const std::vector<std::string>& argv, std::span<const int> descriptors,
                   const std::vector<std::string>* environment)
{
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawnattr_init(&attributes);
    for (int i = 0; i < int(descriptors.size()); ++i)
        if (descriptors[std::size_t(i)] < 0)
            ::posix_spawn_file_actions_addopen(&files, i, "/dev/null", O_RDONLY, 0);
        else
            ::posix_spawn_file_actions_adddup2(&files, descriptors[std::size_t(i)], i);
    ::posix_spawn_file_actions_addclosefrom_np(&files, int(descriptors.size()));
    // Whatever signals we block or ignore, the program starts as from a shell.
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

    const auto words = pointers(argv);
    const auto names = environment ? pointers(*environment) : std::vector<char*>{};
    pid_t pid = -1;
    const int error =
        ::posix_spawnp(&pid, words[0], &files, &attributes, words.data(), environment ? names.data() : environ);
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
    if (error != 0) fail(argv[0], error);
    return pid;
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
