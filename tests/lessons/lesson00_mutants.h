// Known mistakes of lesson 00.
#pragma once

#include "tests/cases/lesson00_cases.h"

namespace rt::cases
{

struct GeometryMutant
{
    const char* mistake;
    const char* group; ///< of the cases that must fail; all others must pass
    std::function<void(lesson00::Functions&)> make;
};

std::vector<GeometryMutant> geometryMutants();

} // namespace rt::cases
