// The mark that an exercise leaves where the student's code goes.
#pragma once

#include <stdexcept>
#include <string>

namespace rt
{

/// Thrown by an exercise that has not been attempted: neither right nor wrong. `id` is the exercise's id.
struct NotAttempted : std::logic_error
{
    explicit NotAttempted(const std::string& exercise)
        : std::logic_error("exercise " + exercise + " has not been attempted"), id(exercise)
    {
    }
    std::string id;
};

[[noreturn]] inline void todo(const char* id)
{
    throw NotAttempted(id);
}

} // namespace rt
