#include "common/base/interrupt.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace rt
{

namespace
{

constexpr int exitCode = 130;

std::atomic<bool> flag = false;
std::atomic<int> arrived = 0; // signals
std::atomic<int> wakeUp = -1; // descriptor by which the handler wakes the watcher
std::atomic<bool> isWatched = false, wasWritten = false, wasSaid = false;

/// Never destroyed: the watcher may need it while the program ends.
struct Shared
{
    std::mutex mutex;
    AfterInterrupt after;
    std::vector<const std::function<void()>*> undo;
};

Shared& shared()
{
    static auto* one = new Shared;
    return *one;
}

/// By hand, since buffers and locks of streams may be held by a thread that never gives them back.
void say(const std::string& sentence)
{
    const std::string line = sentence + "\n";
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) return;
}

std::string ownSentence()
{
    return wasWritten ? "interrupted" : "interrupted: nothing was written";
}

/// Who undoes may be waited for by nobody else: no lock is held meanwhile, but by those who would take something off the list.
[[noreturn]] void endFromOutside()
{
    auto& all = shared();
    const std::lock_guard lock(all.mutex);
    for (auto one = all.undo.rbegin(); one != all.undo.rend(); ++one) (**one)();
    if (!wasSaid.exchange(true)) say(all.after.words ? all.after.words() : ownSentence());
    ::_exit(exitCode);
}

void waitForSignal(int milliseconds)
{
    pollfd file{wakeUp, POLLIN, 0};
    while (::poll(&file, 1, milliseconds) < 0 && errno == EINTR)
    {
    }
    std::uint64_t count = 0;
    if (file.revents && ::read(wakeUp, &count, sizeof count) < 0) return;
}

void watch()
{
    while (arrived == 0) waitForSignal(-1);
    if (isWatched && arrived == 1)
    {
        const auto patience = [] {
            const std::lock_guard lock(shared().mutex);
            return shared().after.patience;
        }();
        waitForSignal(int(patience.count())); // or for the second signal
    }
    endFromOutside();
}

extern "C" void onSignal(int)
{
    constexpr int atOnce = 3; // the watcher itself may hang: in a folder of a network that is gone
    const int before = errno;
    if (++arrived >= atOnce) ::_exit(exitCode);
    if (isWatched) flag = true;
    const std::uint64_t one = 1;
    if (::write(wakeUp, &one, sizeof one) < 0) ::_exit(exitCode);
    errno = before;
}

} // namespace

const std::atomic<bool>& interrupted()
{
    return flag;
}

void endAtInterrupt()
{
    static std::once_flag once;
    std::call_once(once, [] {
        shared();
        wakeUp = ::eventfd(0, EFD_CLOEXEC);
        if (wakeUp < 0) return; // then signals end the program as they always do
        // The watcher takes no signal itself.
        sigset_t all, before;
        ::sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before);
        std::thread(watch).detach();
        ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
        struct sigaction action
        {
        };
        action.sa_handler = onSignal;
        action.sa_flags = SA_RESTART;
        ::sigemptyset(&action.sa_mask);
        for (const int number : {SIGINT, SIGTERM, SIGHUP})
        {
            struct sigaction old
            {
            };
            ::sigaction(number, nullptr, &old);
            if (number != SIGHUP || old.sa_handler != SIG_IGN) ::sigaction(number, &action, nullptr);
        }
    });
}

void watchInterrupt(AfterInterrupt after)
{
    endAtInterrupt();
    const std::lock_guard lock(shared().mutex);
    shared().after = std::move(after);
    isWatched = true;
}

int sayInterrupted(const std::string& words)
{
    if (!wasSaid.exchange(true)) say(words.empty() ? ownSentence() : words);
    return exitCode;
}

UndoAtInterrupt::UndoAtInterrupt(std::function<void()> what) : undo(std::move(what))
{
    const std::lock_guard lock(shared().mutex);
    shared().undo.push_back(&undo);
}

UndoAtInterrupt::~UndoAtInterrupt()
{
    const std::lock_guard lock(shared().mutex);
    auto& all = shared().undo;
    all.erase(std::find(all.begin(), all.end(), &undo));
}

void noteWritten()
{
    wasWritten = true;
}

} // namespace rt
