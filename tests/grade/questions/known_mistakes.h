// The mutants as candidates, and what they answer. Not in a hand-out: they are solutions with one thing wrong.
#pragma once

#include "tests/grade/questions/mistakes.h"

namespace rt::grade
{

struct MutantCandidate
{
    std::string id, mistake;
    bool endless = false; ///< may recurse for ever: never asked here
    Candidate candidate;
};

std::vector<MutantCandidate> mutantCandidates(int lesson);

/// What each mutant that ends answers to all public questions, pictures excepted. Computed once for each lesson, when first
/// needed; thread-safe.
const std::vector<KnownMistake>& knownMistakes(int lesson);

} // namespace rt::grade
