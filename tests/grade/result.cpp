#include "tests/grade/result.h"

namespace rt::grade
{

const char* name(Outcome outcome)
{
    switch (outcome)
    {
    case Outcome::passed:
        return "passed";
    case Outcome::wrong:
        return "wrong";
    case Outcome::notAttempted:
        return "not attempted";
    case Outcome::notDeterministic:
        return "not deterministic";
    case Outcome::crashed:
        return "crashed";
    case Outcome::timedOut:
        return "timed out";
    case Outcome::outOfMemory:
        return "out of memory";
    case Outcome::forbiddenCall:
        return "forbidden call";
    case Outcome::protocol:
        return "answer malformed";
    case Outcome::notRun:
        return "not run";
    }
    return "unknown";
}

const char* name(State state)
{
    switch (state)
    {
    case State::graded:
        return "graded";
    case State::missing:
        return "missing";
    case State::refused:
        return "refused";
    case State::notCompiled:
        return "not compiled";
    case State::graderError:
        return "grader error";
    }
    return "unknown";
}

} // namespace rt::grade
