// launch FOLDER USER PROGRAM: where bubblewrap cannot run. Root starts it; it gives up everything and becomes the program: the
// root folder becomes FOLDER, the user and group become USER, descriptor 5 gives the filter of system calls. A word in
// descriptor 4 says that this failed.
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <grp.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace
{

constexpr int statusFile = 4, filterFile = 5;

[[noreturn]] void fail(const char* what)
{
    std::perror(what);
    const bool isSaid = ::write(statusFile, "failed", sizeof "failed") > 0;
    ::_exit(isSaid ? 1 : 2);
}

void need(bool worked, const char* what)
{
    if (!worked) fail(what);
}

} // namespace

int main(int argc, char** argv)
{
    constexpr int words = 4, safe = 15;
    if (argc != words) return 2;
    const auto user = uid_t(std::strtoul(argv[2], nullptr, 10));
    need(user != 0, "the user");

    static sock_filter filter[4096];
    const auto bytes = ::read(filterFile, filter, sizeof filter);
    need(bytes > 0 && std::size_t(bytes) < sizeof filter, "the filter");
    const sock_fprog program{static_cast<unsigned short>(std::size_t(bytes) / sizeof(sock_filter)), filter};

    const int opened = ::open(argv[3], O_PATH | O_CLOEXEC);
    need(opened >= 0, argv[3]);
    need(::dup3(opened, safe, O_CLOEXEC) == safe, argv[3]);
    need(::chdir(argv[1]) == 0 && ::chroot(".") == 0, argv[1]);
    // The groups first, while we still may.
    need(::setgroups(0, nullptr) == 0 && ::setresgid(user, user, user) == 0 && ::setresuid(user, user, user) == 0,
         "the user");
    need(::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) == 0, "the privileges");
    // Cleared by the change of user, so only now.
    need(::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) == 0, "the parent");
    need(::fcntl(statusFile, F_SETFD, FD_CLOEXEC) == 0, "the descriptors");
    need(::syscall(SYS_close_range, filterFile, safe - 1, 0) == 0, "the descriptors");
    ::syscall(SYS_close_range, safe + 1, ~0U, 0);
    need(::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0, "the filter");
    char* const arguments[] = {const_cast<char*>("/program"), nullptr};
    char* const environment[] = {nullptr};
    ::syscall(SYS_execveat, safe, "", arguments, environment, AT_EMPTY_PATH);
    fail(argv[3]);
}
