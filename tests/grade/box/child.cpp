#include "tests/grade/box/child.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <fmt/format.h>

#include "common/base/interrupt.h"
#include "common/program/spawn.h"
#include "tests/grade/box/death.h"
#include "tests/grade/box/temporary_folder.h"

namespace rt::grade
{

namespace
{

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Writing to a program that is gone raises a signal in the writing thread; here it is an error like others.
class NoBrokenPipe
{
public:
    NoBrokenPipe()
    {
        ::sigemptyset(&pipe);
        ::sigaddset(&pipe, SIGPIPE);
        ::pthread_sigmask(SIG_BLOCK, &pipe, &before);
    }
    NoBrokenPipe(const NoBrokenPipe&) = delete;
    NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;
    ~NoBrokenPipe()
    {
        if (::sigismember(&before, SIGPIPE)) return;
        const timespec now{0, 0};
        while (::sigtimedwait(&pipe, nullptr, &now) < 0 && errno == EINTR)
        {
        }
        ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    }

private:
    sigset_t pipe, before;
};

/// Process 1 of bubblewrap's namespace is a child of bubblewrap, which does not bury it. So that it comes to us, by whom it is
/// buried by its number: nobody else's children are touched.
void becomeSubreaper()
{
    static std::once_flag once;
    std::call_once(once, [] { ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0); });
}

double secondsOf(const rusage& usage)
{
    constexpr double micro = 1e-6;
    return double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           micro * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// Adds its processor time. False if it is not our child.
bool bury(pid_t pid, int& status, double& cpuSeconds)
{
    rusage usage{};
    pid_t buried = -1;
    do buried = ::wait4(pid, &status, 0, &usage);
    while (buried < 0 && errno == EINTR);
    if (buried > 0) cpuSeconds += secondsOf(usage);
    return buried > 0;
}

} // namespace

struct Child::State
{
    Limits limits;
    std::string shown;
    bool boxed = false;                      ///< bubblewrap is between it and us: 128 + n stands for the signal n
    std::unique_ptr<TemporaryFolder> folder; ///< that it needs, if any

    Clock::time_point start = Clock::now();
    Pipe questions, answers, text, status;
    std::atomic<pid_t> pid = -1;
    Descriptor process; ///< readable once it has ended
    pid_t inner = -1;   ///< process 1 of its namespace, in our numbers
    Descriptor innerProcess;

    std::string said, statusText;
    bool flooded = false;
    std::string late;          ///< why it is too late, in words
    bool endOfAnswers = false; ///< it closed them
    double cpuSeconds = 0;
    std::optional<End> end;
    UndoAtInterrupt undo{[this] { kill(); }};

    State(const Command& command, const Limits& given)
        : limits(given), shown(command.shown), boxed(command.reportsStatus), questions(shown), answers(shown),
          text(shown), status(shown)
    {
        if (boxed) becomeSubreaper();
        Pipe filter(shown);
        std::vector<int> files = {questions.read.fd, text.write.fd, text.write.fd, answers.write.fd};
        if (boxed || !command.filter.empty()) files.push_back(status.write.fd);
        if (!command.filter.empty()) files.push_back(filter.read.fd);
        setNonBlocking(questions.write);
        setNonBlocking(answers.read);
        setNonBlocking(text.read);
        setNonBlocking(status.read);
        // A pipe holds 64 KiB, a filter is far smaller.
        setNonBlocking(filter.write);
        if (::write(filter.write.fd, command.filter.data(), command.filter.size()) != ssize_t(command.filter.size()))
            throw std::runtime_error("the filter of system calls does not fit a pipe");
        filter.write.close();

        pid = startProcess(command.argv, files, &command.environment);
        process.fd = int(::syscall(SYS_pidfd_open, pid.load(), 0));
        questions.read.close();
        answers.write.close();
        text.write.close();
        status.write.close();
        if (process.fd < 0)
        {
            stop();
            throw std::runtime_error("this system is too old for the grader: it has no pidfd_open");
        }
        if (boxed) waitForInner();
    }

    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State()
    {
        if (pid > 0) stop();
    }

    bool hasEnded() const
    {
        pollfd one{process.fd, POLLIN, 0};
        return ::poll(&one, 1, 0) > 0;
    }

    /// What is in the pipe now. A program that writes on and on does not keep us here.
    void drainText()
    {
        char buffer[1 << 16];
        while (text.read.fd >= 0)
        {
            const auto count = ::read(text.read.fd, buffer, sizeof buffer);
            if (count < 0 && errno == EINTR) continue;
            if (count < 0 && errno == EAGAIN) return;
            if (count <= 0) return text.read.close();
            const auto fits = std::min(std::size_t(count), limits.textBytes - said.size());
            said.append(buffer, fits);
            if (fits < std::size_t(count)) flood();
            if (std::size_t(count) < sizeof buffer) return;
        }
    }

    void flood()
    {
        flooded = true;
        text.read.close();
        kill();
    }

    void kill()
    {
        if (innerProcess.fd >= 0) ::syscall(SYS_pidfd_send_signal, innerProcess.fd, SIGKILL, nullptr, 0);
        // With bubblewrap this is bubblewrap, outside, and its end is the end of all inside; else it is the program itself.
        if (const pid_t group = pid; group > 0) ::kill(-group, SIGKILL);
    }

    /// Kills and buries all of it; the status of what we started, which is its own if it had ended before.
    int stop()
    {
        kill();
        int code = 0, ignored = 0;
        const pid_t group = pid.exchange(-1);
        forgetProcess(group);
        bury(group, code, cpuSeconds);
        // What it started and left in its group.
        ::kill(-group, SIGKILL);
        if (inner > 0)
        {
            if (innerProcess.fd >= 0) ::syscall(SYS_pidfd_send_signal, innerProcess.fd, SIGKILL, nullptr, 0);
            bury(inner, ignored, cpuSeconds);
        }
        inner = -1;
        return code;
    }

    void drainStatus()
    {
        char buffer[1024];
        for (;;)
        {
            const auto count = ::read(status.read.fd, buffer, sizeof buffer);
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) return;
            statusText.append(buffer, std::size_t(count));
        }
    }

    /// The number after "key": in what bubblewrap reports; -1 if it is not there.
    long reported(const std::string& key) const
    {
        const auto place = statusText.find("\"" + key + "\":");
        return place == std::string::npos ? -1 : std::strtol(statusText.c_str() + place + key.size() + 3, nullptr, 10);
    }

    /// Until bubblewrap says which process it made: by that one we kill, and bury what is left.
    void waitForInner()
    {
        constexpr double patience = 10;
        while (since(start) < patience)
        {
            const bool ended = hasEnded();
            drainStatus();
            inner = pid_t(reported("child-pid"));
            if (inner > 0)
            {
                innerProcess.fd = int(::syscall(SYS_pidfd_open, inner, 0));
                return;
            }
            if (ended) break;
            constexpr int milliseconds = 100;
            pollfd files[] = {{status.read.fd, POLLIN, 0}, {process.fd, POLLIN, 0}};
            ::poll(files, 2, milliseconds);
        }
        drainText();
        stop();
        throw std::runtime_error("the box cannot be started: " + firstLine());
    }

    std::string firstLine() const { return said.empty() ? "it does not say why" : said.substr(0, said.find('\n')); }

    enum class Wait
    {
        read,
        write,
        exit
    };

    /// Waits until `deadline` (seconds since the start) for one thing, and takes text meanwhile. False: too late.
    bool wait(Wait what, double deadline)
    {
        for (;;)
        {
            if (what != Wait::exit && hasEnded()) return true; // whoever reads or writes now, finds out
            const double left = deadline - since(start);
            if (!(left > 0)) return false;
            pollfd files[] = {{process.fd, POLLIN, 0},
                              {text.read.fd, POLLIN, 0},
                              {what == Wait::read    ? answers.read.fd
                               : what == Wait::write ? questions.write.fd
                                                     : -1,
                               short(what == Wait::write ? POLLOUT : POLLIN), 0}};
            constexpr double longest = 1000; // milliseconds
            ::poll(files, 3, int(std::min(std::ceil(left * 1000), longest)));
            if (files[1].revents) drainText();
            if (files[2].revents) return true;
            if (files[0].revents) return true;
        }
    }

    double deadline(double seconds) const { return std::min(since(start) + seconds, limits.wallSeconds); }

    void tooLate(const std::string& did, double seconds)
    {
        late = since(start) >= limits.wallSeconds
                   ? fmt::format("it was stopped after {}", inSeconds(limits.wallSeconds))
                   : fmt::format("it {} within {}", did, inSeconds(seconds));
    }

    /// Signal and exit code of what ran inside.
    void ending(int code, Death& death) const
    {
        if (WIFSIGNALED(code)) death.signal = WTERMSIG(code);
        if (!WIFEXITED(code)) return;
        death.exitCode = WEXITSTATUS(code);
        constexpr int signals = 128, most = 64;
        if (boxed && death.exitCode > signals && death.exitCode <= signals + most)
            death.signal = death.exitCode - signals;
    }
};

Child::Child(const Command& command, const Limits& limits) : state(std::make_unique<State>(command, limits)) {}

Child::Child(const Box& box, const std::string& program, const Limits& limits)
{
    namespace fs = std::filesystem;
    if (::access(program.c_str(), X_OK) != 0) throw std::runtime_error(program + " is not a program");
    std::unique_ptr<TemporaryFolder> folder; ///< that it needs, if any
    auto path = fs::absolute(program).string();
    const bool isCopied = !canReach(box, path);
    if (isCopied || box.sandbox == Sandbox::chroot) folder = std::make_unique<TemporaryFolder>();
    if (isCopied)
    {
        const auto copy = folder->path + "/program";
        fs::copy_file(path, copy);
        constexpr auto mode = fs::perms(0555);
        fs::permissions(copy, mode);
        path = copy;
    }
    state = std::make_unique<State>(runCommand(box, limits, path, folder ? folder->path : ""), limits);
    state->folder = std::move(folder);
}

Child::~Child() = default;

bool Child::send(std::string_view bytes, double seconds)
{
    State& s = *state;
    const double deadline = s.deadline(seconds);
    const NoBrokenPipe guard;
    while (!bytes.empty())
    {
        if (s.end || s.flooded) return false;
        const auto count = ::write(s.questions.write.fd, bytes.data(), bytes.size());
        if (count >= 0)
        {
            bytes.remove_prefix(std::size_t(count));
            continue;
        }
        if (errno == EINTR) continue;
        if (errno != EAGAIN) return false;
        if (s.hasEnded()) return false;
        if (!s.wait(State::Wait::write, deadline))
        {
            s.tooLate("did not read its questions", seconds);
            return false;
        }
    }
    return true;
}

Child::Got Child::receive(std::string& to, std::size_t count, double seconds)
{
    State& s = *state;
    const double deadline = s.deadline(seconds);
    while (count > 0)
    {
        if (s.end || s.flooded) return Got::ended;
        const bool hasEnded = s.hasEnded(); // before reading: nothing can come after that
        char buffer[1 << 16];
        const auto got = ::read(s.answers.read.fd, buffer, std::min(count, sizeof buffer));
        if (got > 0)
        {
            to.append(buffer, std::size_t(got));
            count -= std::size_t(got);
            continue;
        }
        if (got < 0 && errno == EINTR) continue;
        s.endOfAnswers = got == 0;
        if (got == 0 || errno != EAGAIN || hasEnded) return Got::ended;
        if (!s.wait(State::Wait::read, deadline))
        {
            s.tooLate("did not answer", seconds);
            return Got::late;
        }
    }
    return Got::all;
}

Child::End Child::finish()
{
    State& s = *state;
    if (s.end) return *s.end;
    s.questions.write.close();
    constexpr double grace = 0.5;
    const bool isWrong = s.flooded || !s.late.empty();
    const double deadline = since(s.start) + grace;
    if (!isWrong)
        while (!s.hasEnded() && s.wait(State::Wait::exit, deadline))
        {
        }

    Death death;
    const bool endedByItself = !isWrong && !s.flooded && s.hasEnded();
    const int code = s.stop();
    // What is still in the pipe; all who could write are dead.
    constexpr int buffersInAPipe = 32;
    for (int i = 0; i < buffersInAPipe && s.text.read.fd >= 0; ++i) s.drainText();
    s.drainStatus();
    if (endedByItself) s.ending(code, death);
    if (endedByItself && (s.boxed ? s.reported("exit-code") < 0 : !s.statusText.empty()))
        throw std::runtime_error("the box failed: " + s.firstLine());
    death.flooded = s.flooded;
    death.closedAnswers = s.endOfAnswers;
    death.late = s.late;
    death.cpuSeconds = s.cpuSeconds;
    death.text = s.said;
    death.limits = s.limits;
    s.end = explainDeath(death);
    return *s.end;
}

std::string Child::text() const
{
    return state->said;
}

} // namespace rt::grade
