// All cases, by lesson. They are compiled once and run on any subject.
#pragma once

#include "tests/lessons/scenes.h"

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
    static constexpr Cases all[] = {directCases,     mirrorCases,  partialCases, skyCases,
                                    refractionCases, fresnelCases, capCases,     phongCases};
    return lesson >= 1 && lesson <= int(std::size(all)) ? all[lesson - 1]() : std::vector<Case>();
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
