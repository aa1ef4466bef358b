// Known mistakes of a lesson, compiled.
#pragma once

#include "tests/cases/subject.h"

namespace rt::cases
{

struct Mutant
{
    std::string id;
    std::string mistake;           ///< in words, for feedback
    std::vector<std::string> stub; ///< groups of cases of which each must fail
    bool endless;                  ///< may recurse for ever: stop at the first case that fails
    Subject subject;
};

/// The mutants of one lesson, from mutants.toml.
std::vector<Mutant> mutants(int lesson);

} // namespace rt::cases
