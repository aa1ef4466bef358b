#include "viz/window/own_display.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/random.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/program/program.h"

#include <X11/Xlib.h>

namespace rt::viz
{

namespace
{

/// For what takes a tenth of a second on an idle machine.
constexpr auto startTime = std::chrono::seconds(60), endTime = std::chrono::seconds(10);

/// Closed when it goes.
struct File
{
    int number = -1;

    explicit File(int opened) : number(opened) {}
    ~File() { close(); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    void close()
    {
        if (number >= 0) ::close(number);
        number = -1;
    }
};

std::string inPath(const std::string& program)
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (const auto file = std::filesystem::path(folder) / program; access(file.c_str(), X_OK) == 0)
            return file.string();
    return "";
}

/// Sockets of X have their place. Where that is somebody else's, Xvfb would try 59,535 numbers (12 s) and give up; told so,
/// it does with Linux's sockets that are no files.
bool canMakeSockets()
{
    const char *folder = "/tmp/.X11-unix", *above = "/tmp";
    return access(access(folder, F_OK) == 0 ? folder : above, W_OK) == 0;
}

constexpr char cookieName[] = "MIT-MAGIC-COOKIE-1";
constexpr std::size_t cookieLength = 16;

/// A file of X authority with one entry, for any display: numbers have their higher byte first.
std::string authority(const std::string& cookie)
{
    std::string file = "\xff\xff"; // any family of addresses
    const auto add = [&](const std::string& field) {
        file += char(field.size() >> 8);
        file += char(field.size() & 0xff);
        file += field;
    };
    add("");
    add("");
    add(cookieName);
    add(cookie);
    return file;
}

/// The last line of what a program has said, for a sentence.
std::string lastLine(int file)
{
    char text[4096];
    const auto end = lseek(file, 0, SEEK_END);
    const auto start = std::max<off_t>(0, end - off_t(sizeof text));
    const auto length = pread(file, text, sizeof text, start);
    std::istringstream lines(std::string(text, std::size_t(std::max<ssize_t>(0, length))));
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
    return last;
}

} // namespace

OwnDisplay::OwnDisplay(int width, int height)
{
    const auto program = inPath("Xvfb");
    if (program.empty()) throw std::runtime_error("the program Xvfb is not installed (Debian's package is xvfb)");

    std::string cookie(cookieLength, '\0');
    int ends[2] = {-1, -1};
    const bool isReady =
        getrandom(cookie.data(), cookie.size(), 0) == ssize_t(cookie.size()) && pipe2(ends, O_CLOEXEC) == 0;
    File reads(ends[0]), writes(ends[1]);
    // Files without a name: nobody else reads them, and nothing of them is left behind.
    const File secret(memfd_create("raytree-authority", MFD_CLOEXEC)), said(memfd_create("raytree-xvfb", MFD_CLOEXEC));
    const auto entry = authority(cookie);
    const auto secretName = fmt::format("/proc/self/fd/{}", secret.number);
    // A server that cannot read it would let everybody in.
    if (!isReady || said.number < 0 || write(secret.number, entry.data(), entry.size()) != ssize_t(entry.size()) ||
        access(secretName.c_str(), R_OK) != 0)
        throw std::runtime_error(fmt::format("pipes and files in memory cannot be made ({})", std::strerror(errno)));

    // What would keep a display drawn by software from drawing was meant for another one.
    for (const char* name : {"LIBGL_ALWAYS_INDIRECT", "MESA_GL_VERSION_OVERRIDE", "MESA_GLSL_VERSION_OVERRIDE",
                             "MESA_LOADER_DRIVER_OVERRIDE", "__GLX_VENDOR_LIBRARY_NAME"})
        unsetenv(name);
    const auto number = std::to_string(writes.number), screen = fmt::format("{}x{}x24", width, height);
    const std::vector<const char*> words{
        // -noreset: otherwise it starts anew, for a moment deaf, whenever its last client leaves.
        program.c_str(),
        "-displayfd",
        number.c_str(),
        "-screen",
        "0",
        screen.c_str(),
        "-auth",
        secretName.c_str(),
        "-nolisten",
        "tcp",
        "-noreset",
        canMakeSockets() ? nullptr : "-nolisten",
        "unix",
        nullptr};
    const pid_t parent = getpid();
    server = fork();
    if (server == 0)
    {
        // Its end lets it remove its socket and lock; SIGKILL would leave them.
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (getppid() != parent) _exit(1);
        setsid(); // Ctrl-C is for the viewer, which needs its display until it has ended
        std::signal(SIGTERM, SIG_DFL);
        sigset_t none;
        sigemptyset(&none);
        sigprocmask(SIG_SETMASK, &none, nullptr);
        for (const int kept : {writes.number, secret.number}) fcntl(kept, F_SETFD, 0);
        if (const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC); nowhere >= 0)
            for (const int stream : {STDIN_FILENO, STDOUT_FILENO}) dup2(nowhere, stream);
        dup2(said.number, STDERR_FILENO);
        execv(words[0], const_cast<char**>(words.data()));
        _exit(127);
    }
    if (server < 0) throw std::runtime_error(fmt::format("no process can be started ({})", std::strerror(errno)));
    writes.close();

    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + startTime;
    std::string display; // its number and a line end, once it listens
    while (display.empty() || display.back() != '\n')
    {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd wait{reads.number, POLLIN, 0};
        const int ready = left <= 0 || interrupted() ? 0 : poll(&wait, 1, int(left));
        if (ready < 0 && errno == EINTR) continue;
        char part[16];
        const auto got = ready <= 0 ? 0 : read(reads.number, part, sizeof part);
        if (got <= 0)
        {
            stop();
            const auto last = lastLine(said.number);
            throw std::runtime_error(ready <= 0     ? "Xvfb does not get ready"
                                     : last.empty() ? "Xvfb ended at once"
                                                    : fmt::format("Xvfb ended: {}", last));
        }
        display.append(part, std::size_t(got));
    }
    display.pop_back();
    if (const char* name = std::getenv("DISPLAY")) before = name;
    setenv("DISPLAY", (":" + display).c_str(), 1);
    XSetAuthorization(const_cast<char*>(cookieName), int(sizeof cookieName) - 1, cookie.data(), int(cookie.size()));
}

OwnDisplay::~OwnDisplay()
{
    stop();
    XSetAuthorization(nullptr, 0, nullptr, 0);
    if (before)
        setenv("DISPLAY", before->c_str(), 1);
    else
        unsetenv("DISPLAY");
}

/// So that it has removed its socket and lock when we end.
void OwnDisplay::stop()
{
    if (server <= 0) return;
    kill(server, SIGTERM);
    const auto end = std::chrono::steady_clock::now() + endTime;
    while (waitpid(server, nullptr, WNOHANG) == 0)
    {
        if (std::chrono::steady_clock::now() > end) kill(server, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    server = -1;
}

} // namespace rt::viz
