// A student's program as a candidate: each call is a question to a process in a box.
#pragma once

#include <memory>
#include <string>

#include "tests/grade/box/box.h"
#include "tests/grade/candidate.h"

namespace rt::grade
{

/// Starts a process at the first question, and another one after each that ended, hung or did not keep to the protocol.
/// Copies share the processes. To be used in one thread, the one that asks.
class Remote
{
public:
    /// `program`: an exercise of this lesson (0 to 8) linked with the runner. A question may take wallSeconds / 12, a picture or
    /// the start of a process 5/12 of them (a picture no more than other questions once one hung); all together wallSeconds.
    Remote(const Box& box, const std::string& program, int lesson, const Limits& limits);

    /// Its functions, those that the lesson has, throw what the student's exercise did: NotAttempted with an id of this lesson,
    /// or std::runtime_error with the text of an exception, which is foreign. Died: see there; after 20 deaths, when the
    /// time is used up, or when three processes in a row did not even start to answer, they throw Died with notRun and start
    /// nothing. GraderError: the box failed.
    Candidate candidate() const;

    /// The same in a new process that knows nothing of what was asked before, with all its deaths and time before it again.
    Candidate afresh() const;

    /// Ends the process, if there is one, and gives what they printed: 4 KiB of each of the first four. Foreign.
    std::string text();

    int deaths() const; ///< since it was made, or asked afresh

private:
    struct State;
    std::shared_ptr<State> state;
};

/// Remote(...).candidate()
Candidate remoteCandidate(const Box& box, const std::string& program, int lesson, const Limits& limits);

} // namespace rt::grade
