// Whoever is asked: a student's process, a lesson, a mutant. Lesson 00 is functions of numbers, the others are tracers.
#pragma once

#include "tests/lessons/lesson00_cases.h"
#include "tests/lessons/subject.h"

namespace rt::grade
{

struct Candidate
{
    cases::Subject tracer;           ///< lessons 01 to 08; its functions are empty in lesson 00
    cases::GeometrySubject geometry; ///< lesson 00; empty functions otherwise
};

/// The lesson itself, in double: what the answers of a student are compared with. Lesson 00 to 08.
Candidate reference(int lesson);

} // namespace rt::grade
