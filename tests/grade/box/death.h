// How a process ended, in words.
#pragma once

#include <cstddef>
#include <string>

#include "tests/grade/box/child.h"

namespace rt::grade
{

/// What is known about the end of a process.
struct Death
{
    int signal = 0;    ///< that ended it; 0: none
    int exitCode = -1; ///< -1: it did not end by itself
    bool flooded = false;
    bool closedAnswers = false; ///< and went on
    std::string late;           ///< the reason, if it was too late
    double cpuSeconds = 0;
    std::string text; ///< what it printed, which may be why it was aborted
    Limits limits;
};

Child::End explainDeath(const Death& death);

std::string inSeconds(double seconds); ///< "2.4 s"
std::string inMiB(std::size_t bytes);  ///< "512 MiB"

} // namespace rt::grade
