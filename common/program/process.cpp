#include "common/program/process.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <fmt/format.h>

#include "common/base/interrupt.h"
#include "common/program/spawn.h"

namespace rt
{

namespace
{

constexpr std::size_t errBytes = std::size_t(64) << 10;

/// A running program: the leader of its group. Kills the group and buries its leader at the latest when it goes out of scope.
class Child
{
public:
    explicit Child(pid_t started) : pid(started) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child()
    {
        int ignored = 0;
        if (pid > 0) end(ignored);
    }

    /// Has the leader ended? It stays a zombie, so that its number, which is the group's, is not given to another.
    bool hasEnded() const
    {
        siginfo_t info{};
        const int failed = ::waitid(P_PID, id_t(pid.load()), &info, WEXITED | WNOHANG | WNOWAIT);
        return (failed != 0 && errno != EINTR) || info.si_pid == pid;
    }

    /// False if somebody else, a handler of SIGCHLD, has taken the status away.
    bool end(int& status)
    {
        kill();
        forgetProcess(pid);
        const pid_t dead = pid.exchange(-1);
        pid_t buried = -1;
        do buried = ::waitpid(dead, &status, 0);
        while (buried < 0 && errno == EINTR);
        return buried > 0;
    }

private:
    void kill() const
    {
        if (const pid_t group = pid; group > 0) ::kill(-group, SIGKILL);
    }

    std::atomic<pid_t> pid;
    UndoAtInterrupt undo{[this] { kill(); }};
};

/// Limits that hold even when we are gone.
void limitResources(pid_t pid, double seconds)
{
    const rlimit noCore{0, 0};
    ::prlimit(pid, RLIMIT_CORE, &noCore, nullptr);
    const double all = (std::ceil(seconds) + 1) * std::max(1U, std::thread::hardware_concurrency());
    constexpr double most = 1e9;
    if (!(all < most)) return;
    const rlimit processor{rlim_t(all), rlim_t(all) + 1};
    ::prlimit(pid, RLIMIT_CPU, &processor, nullptr);
}

/// Appends what can be read now, until `text` has `most` bytes; closes the descriptor at the end of the file. False if there
/// was more than fits.
bool drain(Descriptor& from, std::string& text, std::size_t most)
{
    char buffer[1 << 16];
    while (from.fd >= 0)
    {
        const auto count = ::read(from.fd, buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0 && errno == EAGAIN) break;
        if (count <= 0)
        {
            from.close();
            break;
        }
        const auto fits = std::min(std::size_t(count), most - text.size());
        text.append(buffer, fits);
        if (fits < std::size_t(count)) return false;
        // Leave when there is less than a buffer full, so that a program that writes on and on does not keep us here.
        if (std::size_t(count) < sizeof buffer) break;
    }
    return true;
}

/// The same for text of which only the end is of interest; `all` counts what came. False if that is more than `most`.
bool drainTail(Descriptor& from, std::string& text, std::size_t& all, std::size_t most)
{
    const auto before = text.size();
    drain(from, text, text.max_size());
    all += text.size() - before;
    if (text.size() > 2 * errBytes) text.erase(0, text.size() - errBytes);
    return all <= most;
}

/// Until there is something to read, but not for long: somebody may stop us, or the program may end and leave its output to
/// a child of its own.
void waitForOutput(int out, int err, double seconds)
{
    const int longest = out < 0 && err < 0 ? 1 : 10; // milliseconds; with both closed it is about to end
    pollfd files[] = {{out, POLLIN, 0}, {err, POLLIN, 0}};
    ::poll(files, 2, int(std::clamp(std::ceil(seconds * 1000), 0.0, double(longest))));
}

std::string sizeText(std::size_t bytes)
{
    constexpr std::size_t KiB = 1024, MiB = KiB * KiB;
    if (bytes >= MiB && bytes % MiB == 0) return fmt::format("{} MiB", bytes / MiB);
    if (bytes >= KiB && bytes % KiB == 0) return fmt::format("{} KiB", bytes / KiB);
    return fmt::format("{} bytes", bytes);
}

/// The first line that says anything, without what would disturb a terminal or a label.
std::string firstLine(const std::string& text)
{
    constexpr std::size_t longest = 200;
    const char* blanks = " \t\r\n";
    const auto start = text.find_first_not_of(blanks);
    if (start == std::string::npos) return "";
    std::string line = text.substr(start, std::min(text.find('\n', start) - start, longest));
    line.erase(line.find_last_not_of(blanks) + 1);
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
    return line;
}

/// The last lines, joined to one: what a program says before it aborts often takes two.
std::string lastLines(const std::string& text)
{
    constexpr std::size_t most = 3;
    std::vector<std::string> lines;
    std::istringstream all(text);
    for (std::string line; std::getline(all, line);)
        if (auto words = firstLine(line); !words.empty()) lines.push_back(std::move(words));
    std::string joined;
    for (std::size_t i = lines.size() > most ? lines.size() - most : 0; i < lines.size(); ++i)
        joined += (joined.empty() ? "" : "; ") + lines[i];
    return joined;
}

} // namespace

ProcessResult runProcess(const std::vector<std::string>& argv, const ProcessLimits& limits)
{
    if (argv.empty() || argv[0].empty()) throw std::runtime_error("no program is named");
    for (const auto& word : argv)
        if (word.find('\0') != std::string::npos) throw std::runtime_error("a command cannot hold zero bytes");

    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    Pipe out(argv[0]), err(argv[0]);
    setNonBlocking(out.read);
    setNonBlocking(err.read);
    const int descriptors[] = {-1, out.write.fd, err.write.fd};
    const pid_t pid = startProcess(argv, descriptors);
    Child child(pid);
    limitResources(pid, limits.seconds);
    out.write.close();
    err.write.close();

    ProcessResult result;
    result.mostOutput = limits.outputBytes;
    std::size_t complaints = 0; // bytes of standard error
    const auto collect = [&] {
        const bool outFits = drain(out.read, result.out, limits.outputBytes);
        const bool errFits = drainTail(err.read, result.err, complaints, limits.outputBytes);
        result.tooMuchOutput = !outFits || !errFits;
    };
    for (;;)
    {
        // First whether it has ended, then what it wrote: nothing can come after that.
        const bool hasEnded = child.hasEnded();
        collect();
        result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (result.tooMuchOutput || hasEnded) break;
        result.stopped = limits.stop && *limits.stop;
        result.timedOut = !result.stopped && !(result.seconds < limits.seconds);
        if (result.stopped || result.timedOut) break;
        waitForOutput(out.read.fd, err.read.fd, limits.seconds - result.seconds);
    }
    const bool endedByItself = !result.tooMuchOutput && !result.stopped && !result.timedOut;
    int status = 0;
    const bool known = child.end(status);
    if (endedByItself && known && WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
    if (endedByItself && known && WIFSIGNALED(status)) result.signal = WTERMSIG(status);
    // What is still in the pipes; no more than that, should something that left the group go on writing.
    constexpr int buffersInAPipe = 32;
    for (int i = 0; i < buffersInAPipe && !result.tooMuchOutput; ++i) collect();
    if (result.err.size() > errBytes) result.err.erase(0, result.err.size() - errBytes);
    return result;
}

std::vector<std::string> splitCommand(const std::string& command)
{
    std::vector<std::string> words;
    bool inWord = false; // also in an empty one: ""
    char quote = 0;
    for (std::size_t i = 0; i < command.size(); ++i)
    {
        const char c = command[i];
        const bool isBlank = c == ' ' || c == '\t' || c == '\n';
        if (!quote && isBlank)
        {
            inWord = false;
            continue;
        }
        if (!inWord) words.emplace_back();
        inWord = true;
        if (c == quote)
            quote = 0;
        else if (!quote && (c == '\'' || c == '"'))
            quote = c;
        else if (c == '\\' && quote != '\'')
        {
            if (i + 1 == command.size()) throw std::runtime_error("the command ends with a \\ that nothing follows");
            const char next = command[i + 1];
            // In double quotes a backslash that does not protect anything is itself.
            if (quote && !std::strchr("\"\\$`", next)) words.back() += c;
            words.back() += next;
            ++i;
        }
        else
            words.back() += c;
    }
    if (quote) throw std::runtime_error(fmt::format("the command has a {} that is not closed: {}", quote, command));
    return words;
}

std::string describeFailure(const std::string& what, const ProcessResult& result)
{
    if (result.ok()) return "";
    if (result.stopped) return what + " was stopped";
    if (result.timedOut)
        return fmt::format("{} was stopped after {} s without an answer", what,
                           result.seconds < 9.5 ? fmt::format("{:.2g}", result.seconds)
                                                : fmt::format("{:.0f}", result.seconds));
    if (result.tooMuchOutput)
        return fmt::format("{} wrote more than {} to {}", what, sizeText(result.mostOutput),
                           result.out.size() < result.mostOutput ? "standard error" : "standard output");
    if (result.signal == SIGKILL) return what + " was killed from outside, perhaps for want of memory";
    if (result.signal != 0)
    {
        const auto words = lastLines(result.err);
        return fmt::format("{} crashed ({}){}{}", what, signalText(result.signal), words.empty() ? "" : ": ", words);
    }
    if (result.exitCode < 0) return what + " ended, it is not known how";
    const auto reason = firstLine(result.err);
    return fmt::format("{} ended with code {}{}{}", what, result.exitCode, reason.empty() ? "" : ": ", reason);
}

} // namespace rt
