// Lesson 00 is functions of numbers, without scenes: it has cases of its own.
#pragma once

#include "common/base/todo.h"
#include "tests/cases/check.h"
#include "tests/cases/lesson00_subject.h"

namespace rt::cases
{

/// Like Case. Groups are one for each exercise; a group asks only the function that it is about.
struct GeometryCase
{
    const char* group;
    const char* name;
    const char* slide;
    Kind kind;
    void (*run)(Check&, const GeometrySubject&);
};

std::vector<GeometryCase> geometryCases();

/// Runs one case; a case that throws anything but NotAttempted has failed.
Check runCase(const GeometryCase& which, const GeometrySubject& subject);

} // namespace rt::cases
