#include "tests/grade/box/seccomp.h"

#include <cerrno>
#include <csignal>
#include <stdexcept>

#include <fcntl.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

#include "common/program/spawn.h"

namespace rt::grade
{

namespace
{

struct Context
{
    scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_KILL_PROCESS);
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context() { ::seccomp_release(filter); }

    template <class... Conditions>
    void add(std::uint32_t action, const char* call, Conditions... conditions)
    {
        const int number = ::seccomp_syscall_resolve_name(call);
        if (number == __NR_SCMP_ERROR) return; // older than the kernel's call: then it is not allowed
        const int error = ::seccomp_rule_add(filter, action, number, sizeof...(conditions), conditions...);
        // A call that another architecture has: there is nothing to add.
        if (error != 0 && error != -EDOM && error != -EINVAL)
            throw std::runtime_error(std::string("the filter of system calls cannot be made, at ") + call);
    }
};

// clang-format off
constexpr const char* allowed[] = {
    "read", "write", "readv", "writev", "close", "lseek", "fstat", "newfstatat", "stat", "lstat", "statx", "readlink", "readlinkat",
    "exit", "exit_group", "brk", "munmap", "mremap", "madvise", "futex",
    "clock_gettime", "clock_getres", "gettimeofday", "time", "times", "getrusage", "nanosleep", "clock_nanosleep",
    "getrandom", "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "sigaltstack", "sched_yield",
    "arch_prctl", "set_tid_address", "set_robust_list", "rseq", "getpid", "gettid", "getuid", "geteuid", "getgid", "getegid",
    "uname",
    // Bubblewrap's process 1 runs under the filter too and waits; the program has no children.
    "wait4",
    // The program itself is started by it. There is nothing else that could be.
    "execve", "execveat"};

// What the C and C++ libraries may try by themselves: an error instead of death.
constexpr const char* refused[] = {
    "open", "openat", "openat2", "creat", "access", "faccessat", "faccessat2", "getcwd", "chdir",
    "unlink", "unlinkat", "rename", "renameat", "renameat2", "mkdir", "mkdirat", "rmdir", "fcntl", "dup", "dup2", "dup3", "pipe", "pipe2",
    "fork", "vfork", "clone", "clone3", "sched_getaffinity", "sysinfo", "setrlimit", "truncate", "ftruncate"};
// clang-format on

std::string exported(const Context& context)
{
    const Descriptor file(::memfd_create("filter", MFD_CLOEXEC));
    if (file.fd < 0 || ::seccomp_export_bpf(context.filter, file.fd) != 0)
        throw std::runtime_error("the filter of system calls cannot be made");
    std::string bytes(std::size_t(::lseek(file.fd, 0, SEEK_END)), '\0');
    if (bytes.empty() || ::pread(file.fd, bytes.data(), bytes.size(), 0) != ssize_t(bytes.size()))
        throw std::runtime_error("the filter of system calls cannot be made");
    return bytes;
}

std::string makeFilter()
{
    Context context;
    if (!context.filter) throw std::runtime_error("the filter of system calls cannot be made");
    ::seccomp_attr_set(context.filter, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    for (const char* call : allowed) context.add(SCMP_ACT_ALLOW, call);
    for (const char* call : refused) context.add(SCMP_ACT_ERRNO(EPERM), call);
    context.add(SCMP_ACT_ERRNO(ENOTTY), "ioctl");
    // Memory that is neither a file nor code.
    context.add(SCMP_ACT_ALLOW, "mmap", SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0),
                SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_ANONYMOUS, MAP_ANONYMOUS));
    context.add(SCMP_ACT_ALLOW, "mprotect", SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0));
    // abort() sends itself a signal; reading a limit is part of starting.
    context.add(SCMP_ACT_ALLOW, "tgkill", SCMP_A2(SCMP_CMP_EQ, SIGABRT));
    context.add(SCMP_ACT_ALLOW, "prlimit64", SCMP_A2(SCMP_CMP_EQ, 0));
    return exported(context);
}

} // namespace

const std::string& seccompFilter()
{
    static const std::string filter = makeFilter();
    return filter;
}

} // namespace rt::grade
