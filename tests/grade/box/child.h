// A student's process, or a compiler, in its box: bytes in, bytes out, text, and how it ended.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "tests/grade/box/box.h"
#include "tests/grade/result.h"

namespace rt::grade
{

/// Reads questions from descriptor 0, writes answers to 3 and text to 1 and 2. Nothing of it survives this object. To be used
/// and ended in the thread that made it: bubblewrap ends with that thread.
class Child
{
public:
    /// Starts it. Throws std::runtime_error, a grader's error and no student's, if it cannot be.
    Child(const Box& box, const std::string& program, const Limits& limits);
    Child(const Command& command, const Limits& limits);
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child();

    /// All of it within so many seconds; false: it is gone, or does not read.
    bool send(std::string_view bytes, double seconds);

    enum class Got
    {
        all,
        ended, ///< it closed descriptor 3 before that, most likely by ending
        late   ///< not within the time, or its wall time is over
    };
    /// Appends exactly `count` bytes of its answers, fewer if it does not return `all`. Nobody reads more than is asked for, so
    /// that a flood of answers stops by itself.
    Got receive(std::string& to, std::size_t count, double seconds);

    /// Standard output and error joined, cut at the limit: foreign text. All of it is there only after finish().
    std::string text() const;

    struct End
    {
        Outcome outcome =
            Outcome::passed;   ///< passed: it ended by itself with code 0, or we ended it and nothing was wrong
        std::string sentence;  ///< without a full stop: "it crashed (segmentation fault)"; empty: nothing to say
        bool byItself = false; ///< had it ended before, or soon after its questions did?
        int exitCode = -1;     ///< if it ended by itself and not by a signal
        double cpuSeconds = 0;
    };
    /// Closes its questions, gives it half a second to end, then kills all of it, and says why it had ended. Throws
    /// std::runtime_error if not the program but its box failed.
    End finish();

private:
    struct State;
    std::unique_ptr<State> state;
};

} // namespace rt::grade
