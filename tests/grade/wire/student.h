// What a student's exercise is compiled with: precompiled once. It holds no solution, no expected value and no verdict.
#pragma once

#include "common/exercise.h"
#include "tests/cases/lesson00_subject.h"
#include "tests/cases/subject.h"

namespace rt
{

// What no exercise changes is compiled once, in runner.student.cpp.
RAYTREE_SCENE(extern, double)
extern template class TreeRecorder<double>;

namespace grade
{

struct Student
{
    cases::Subject tracer;           ///< lessons 01 to 08
    cases::GeometrySubject geometry; ///< lesson 00
};

/// exercise.student.cpp, which is compiled with the student's file.
Student makeStudent();

} // namespace grade

} // namespace rt
