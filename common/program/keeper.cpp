#include "common/program/keeper.h"

#include <cerrno>
#include <cstddef>
#include <initializer_list>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rt
{

namespace
{

// It holds nothing of ours: no terminal, no folder, no descriptor but the pipe. A child of a child, so that it is nobody's to
// wait for. `3<&-` in the subshell's parent ends with it.
constexpr const char* script = R"(
trap '' INT TERM HUP QUIT
{
    live=" "
    while read -r sign group; do
        case "$sign$live" in
            +*) live="$live$group " ;;
            -*" $group "*) live="${live%% "$group" *} ${live#* "$group" }" ;;
        esac
    done
    for group in $live; do kill -KILL "-$group"; done
} <&3 3<&- >/dev/null 2>&1 &
)";

int startKeeper()
{
    int ends[2]; // sockets, since a write to a pipe that nobody reads any more raises a signal
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return -1;
    constexpr int least = 16; // as Pipe in spawn.h
    const int ours = ::fcntl(ends[1], F_DUPFD_CLOEXEC, least);
    ::close(ends[1]);
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_adddup2(&files, ends[0], 3);
    for (const int standard : {0, 1, 2})
        ::posix_spawn_file_actions_addopen(&files, standard, "/dev/null", standard == 0 ? O_RDONLY : O_WRONLY, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&files, 4);
    ::posix_spawn_file_actions_addchdir_np(&files, "/");
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    const char* words[] = {"sh", "-c", script, nullptr};
    char* environment[] = {nullptr};
    pid_t pid = -1;
    const int failed = ::posix_spawn(&pid, "/bin/sh", &files, &attributes, const_cast<char**>(words), environment);
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
    ::close(ends[0]);
    int status = 0;
    if (!failed)
        while (::waitpid(pid, &status, 0) < 0 && errno == EINTR)
        {
        }
    if (!failed && status == 0) return ours;
    ::close(ours);
    return -1;
}

} // namespace

int keeper()
{
    static const int ours = startKeeper();
    return ours;
}

void tellKeeper(int descriptor, char sign, pid_t group)
{
    constexpr std::size_t most = 16;
    char line[most];
    char* at = line + most;
    *--at = '\n';
    for (; group > 0; group /= 10) *--at = char('0' + group % 10);
    *--at = ' ';
    *--at = sign;
    if (::send(descriptor, at, std::size_t(line + most - at), MSG_NOSIGNAL | MSG_DONTWAIT) < 0) return;
}

} // namespace rt
