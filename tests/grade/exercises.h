// The lessons' exercises as candidates in our own process, for tests.
#pragma once

#include "tests/grade/candidate.h"

namespace rt::grade
{

/// Written as the lesson has it. Throws std::out_of_range for a lesson that has none.
Candidate solved(int lesson);

/// As students get it: each of its functions throws NotAttempted. Throws std::out_of_range, too.
Candidate untouched(int lesson);

} // namespace rt::grade
