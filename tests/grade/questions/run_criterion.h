// One criterion of questions put to one candidate.
#pragma once

#include "tests/grade/questions/mistakes.h"
#include "tests/grade/questions/question_set.h"

namespace rt::grade
{

struct CriterionRun
{
    int cases = 0, passed = 0;
    double credit = 0; ///< share of the criterion's points, in [0, 1]
    Outcome outcome = Outcome::passed;
    bool notAttempted = false;
    std::optional<Example> example; ///< the first failing case
    Evidence evidence;              ///< wrong answers; none for pictures
    std::optional<Image> picture;   ///< if it is wrong, and of the right size
    std::uint64_t fingerprint = 0;
    bool outOfTime = false; ///< the clock, not the program, decided what was answered: no run to compare with another
    bool gaveUp = false;    ///< it ended the program so often that no points were left to earn: the rest was not asked
};

/// Catches all that a candidate's functions throw. `stop` may be null. `strict`: one death is enough to give up.
CriterionRun runCriterion(const AskedCriterion& asked, const Candidate& candidate, const std::atomic<bool>* stop,
                          bool strict = false);

/// Of a criterion that was not asked at all.
CriterionRun notAsked(const AskedCriterion& asked);

/// The comparison for the student's eyes, at the counted pixel that is most wrong; asks the candidate for its ray tree there.
PictureTriple compareFor(const AskedCriterion& asked, const Image& got, const Candidate& candidate, int lesson);

} // namespace rt::grade
