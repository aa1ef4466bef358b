// The lecture's functions, for explanations.
#pragma once

#include "common/tree/explain.h"

namespace rt
{

/// Those of lessons 06 and 08, in double.
const LectureFormulas& lectureFormulas();

} // namespace rt
