// The probe of the self-test: tries in the box what a program must not be able to do, and tells. One word on its input says
// what; "list" tries all that is refused with an error and answers with the names of what succeeded, one a line, then a full
// stop. The others are one attempt each, that should kill it. It is also a program that misbehaves, for tests.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <fcntl.h>
#include <linux/bpf.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char** environ;

namespace
{

constexpr int answers = 3;

void answer(const std::string& text)
{
    if (::write(answers, text.data(), text.size()) != ssize_t(text.size())) ::_exit(9);
}

bool canOpen(const char* path, int flags)
{
    return ::open(path, flags, 0600) >= 0;
}

bool canFork()
{
    const pid_t pid = ::fork();
    if (pid == 0) ::_exit(0);
    return pid > 0;
}

bool canStartShell()
{
    char shell[] = "/bin/sh", option[] = "-c", command[] = "exit 0";
    char* arguments[] = {shell, option, command, nullptr};
    ::execve(shell, arguments, environ); // success does not return: no answer, which the tester notices
    return false;
}

/// PWD is set by bubblewrap itself.
bool hasEnvironment()
{
    for (char** one = environ; *one; ++one)
        if (std::strncmp(*one, "PWD=", 4) != 0) return true;
    return false;
}

bool hasStrayDescriptor()
{
    constexpr int most = 4096;
    for (int fd = answers + 1; fd < most; ++fd)
        if (::lseek(fd, 0, SEEK_CUR) >= 0 || errno != EBADF) return true;
    return false;
}

void list()
{
    std::string worked;
    const auto tell = [&](const char* what, bool does) {
        if (does) worked += std::string(what) + "\n";
    };
    tell("read /etc/passwd", canOpen("/etc/passwd", O_RDONLY));
    tell("read /proc/self/environ", canOpen("/proc/self/environ", O_RDONLY));
    tell("read /proc/1/environ", canOpen("/proc/1/environ", O_RDONLY));
    tell("read /proc/self/maps", canOpen("/proc/self/maps", O_RDONLY));
    tell("read its own program", canOpen("/program", O_RDONLY));
    tell("list the root folder", canOpen("/", O_RDONLY | O_DIRECTORY));
    tell("open /dev/null", canOpen("/dev/null", O_RDWR));
    for (const char* path : {"/written", "/tmp/written", "/dev/shm/written", "written", "/out/written"})
        tell("write a file", canOpen(path, O_WRONLY | O_CREAT));
    tell("make a folder", ::mkdir("/made", 0700) == 0);
    tell("start a process", canFork());
    tell("start a thread",
         ::syscall(SYS_clone, CLONE_VM | CLONE_FS | CLONE_FILES | CLONE_SIGHAND | CLONE_THREAD, 0, 0, 0, 0) >= 0);
    tell("start /bin/sh", canStartShell());
    tell("see environment variables", hasEnvironment());
    tell("use a stray descriptor", hasStrayDescriptor());
    // Asking for the state of a file is allowed, so that this sees the file system itself and not the filter.
    struct stat state;
    for (const char* path : {"/etc", "/usr", "/proc", "/dev", "/tmp", "/home", "/lib"})
        tell("see files of the system", ::stat(path, &state) == 0);
    answer(worked + ".");
}

[[noreturn]] void sleepLong()
{
    for (;;) ::sleep(1000);
}

[[gnu::noinline]] int endless(volatile int* above)
{
    if (above[0] < 0) return 0; // never, but the compiler does not know

    volatile int here[256] = {*above};
    return endless(here) + here[0];
}

[[noreturn]] void flood(int fd)
{
    const std::string much(1 << 16, 'x');
    for (;;)
        if (::write(fd, much.data(), much.size()) < 0) ::_exit(8);
}

void eatMemory()
{
    constexpr std::size_t chunk = std::size_t(16) << 20;
    for (std::size_t i = 0; i < 4096; ++i) std::memset(new char[chunk], 1, chunk);
}

[[noreturn]] void spin()
{
    volatile bool forever = true;
    while (forever)
    {
    }
    ::_exit(6);
}

void attempt(const std::string& word)
{
    if (word == "list") list();
    if (word == "echo") answer("echo");
    if (word == "socket") ::socket(AF_INET, SOCK_STREAM, 0);
    if (word == "ptrace") ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    if (word == "kill") ::kill(1, SIGTERM);
    if (word == "memfd_create") ::memfd_create("x", 0);
    if (word == "mount") ::mount("none", "/", "tmpfs", 0, nullptr);
    if (word == "unshare") ::unshare(CLONE_NEWUSER);
    if (word == "io_uring_setup") ::syscall(SYS_io_uring_setup, 1, nullptr);
    if (word == "bpf") ::syscall(SYS_bpf, BPF_MAP_CREATE, nullptr, 0);
    if (word == "keyctl") ::syscall(SYS_keyctl, 0, 0, 0, 0, 0);
    if (word == "process_vm_readv") ::syscall(SYS_process_vm_readv, 1, nullptr, 0, nullptr, 0, 0);
    if (word == "signal") ::syscall(SYS_tgkill, 1, 1, SIGKILL);
    if (word == "i386") asm volatile("int $0x80" : : "a"(20) : "memory", "r8", "r9", "r10", "r11");
    if (word == "code") ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (word == "raise limits")
    {
        const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
        ::setrlimit(RLIMIT_CPU, &none);
    }
    if (word == "memory") eatMemory();
    if (word == "cpu") spin();
    // Misbehaviour, for tests.
    if (word == "sleep") sleepLong();
    if (word == "segfault")
    {
        static int* volatile nowhere = nullptr;
        *nowhere = 1;
    }
    if (word == "abort") std::abort();
    if (word == "throw") throw std::vector<int>();
    if (word == "stack")
    {
        volatile int start = 0;
        std::printf("%d\n", endless(&start));
    }
    if (word == "text") flood(1);
    if (word == "answers") flood(answers);
    if (word == "exit0") ::_exit(0);
    if (word == "exit3") ::_exit(3);
    if (word == "close")
    {
        for (int fd = 0; fd < 64; ++fd) ::close(fd);
        sleepLong();
    }
    if (word == "ignore")
    {
        ::signal(SIGXCPU, SIG_IGN);
        spin();
    }
    if (word == "print") std::puts("seen"), std::fputs("error\n", stderr), answer("p");
}

} // namespace

int main()
{
    constexpr std::size_t longest = 64;
    char word[longest + 1];
    for (std::size_t length = 0; ::read(0, word + length, 1) == 1;)
    {
        if (word[length] != '\n')
        {
            if (++length == longest) return 7;
            continue;
        }
        attempt(std::string(word, length));
        answer("survived");
        length = 0;
    }
    return 0;
}
