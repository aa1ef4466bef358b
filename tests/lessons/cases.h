// All cases, by lesson. They are compiled once and run on any subject.
#pragma once

#include "tests/lessons/subject.h"

namespace rt::cases
{

std::vector<Case> directCases();
std::vector<Case> mirrorCases();

/// The cases that a lesson's own idea is about.
inline std::vector<Case> ownCases(int lesson)
{
    switch (lesson)
    {
    case 1:
        return directCases();
    case 2:
        return mirrorCases();
    default:
        return {};
    }
}

/// What must hold for a lesson: its own cases and those of the lessons before it.
inline std::vector<Case> casesUpTo(int lesson)
{
    std::vector<Case> all;
    for (int number = 1; number <= lesson; ++number)
        for (const auto& which : ownCases(number)) all.push_back(which);
    return all;
}

} // namespace rt::cases
