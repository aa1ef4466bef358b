// What a student's exercise is compiled with: precompiled once. It holds no solution, no expected value and no verdict.
#pragma once

#include "common/exercise.h"
#include "tests/lessons/lesson00_subject.h"
#include "tests/lessons/subject.h"

namespace rt
{

extern template Scene<double>::Scene(const SceneDescription&); // runner.student.cpp has it

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
