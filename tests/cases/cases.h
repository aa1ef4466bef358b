// All cases, by lesson. They are compiled once and run on any subject.
#pragma once

#include "tests/cases/scenes.h"

namespace rt::cases
{

std::vector<Case> directCases();
std::vector<Case> mirrorCases();
std::vector<Case> partialCases();
std::vector<Case> skyCases();
std::vector<Case> refractionCases();
std::vector<Case> fresnelCases();
std::vector<Case> capCases();
std::vector<Case> phongCases();

/// The cases that a lesson's own idea is about.
inline std::vector<Case> ownCases(int lesson)
{
    using Cases = std::vector<Case> (*)();
    static constexpr std::pair<int, Cases> all[] = {{1, directCases}, {2, mirrorCases},     {3, partialCases},
                                                    {4, skyCases},    {5, refractionCases}, {6, fresnelCases},
                                                    {7, capCases},    {8, phongCases}};
    for (const auto& [number, cases] : all)
        if (number == lesson) return cases();
    return {};
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
