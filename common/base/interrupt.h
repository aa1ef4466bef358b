// Ctrl-C, SIGTERM and SIGHUP end a program: by itself if it looks at interrupted(), else from outside, wherever it is.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>

namespace rt
{

/// Set by the first of these signals after watchInterrupt().
const std::atomic<bool>& interrupted();

/// From now on a signal ends the program at once: with a sentence, exit code 130, and without half-written files. SIGHUP does
/// nothing if it was ignored before, as under nohup.
void endAtInterrupt();

struct AfterInterrupt
{
    /// So long the program has to end by itself, before it is ended from outside.
    std::chrono::milliseconds patience{100};
    /// What is then said; empty: the sentence of sayInterrupted(). Called from another thread.
    std::function<std::string()> words = {};
};

/// From now on somebody looks at interrupted(), and a signal gives the program time to end by itself. A second one ends it at
/// once.
void watchInterrupt(AfterInterrupt after = {});

/// `words`, or "interrupted: nothing was written", without its end if a file was; once, whoever says it first. Returns the exit
/// code.
int sayInterrupted(const std::string& words = "");

/// From outside a program is ended without destructors: what must be undone even so, the newest first. A file that is being
/// written, a child, the state of the terminal.
class UndoAtInterrupt
{
public:
    /// `undo` is called from another thread, while all others go on.
    explicit UndoAtInterrupt(std::function<void()> undo);
    ~UndoAtInterrupt();
    UndoAtInterrupt(const UndoAtInterrupt&) = delete;
    UndoAtInterrupt& operator=(const UndoAtInterrupt&) = delete;

private:
    std::function<void()> undo;
};

/// A file is about to get its new content: it is not true any more that nothing was written.
void noteWritten();

} // namespace rt
