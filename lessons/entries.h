// The entry of each lesson; each is defined in the lesson's own entry.cpp.
#pragma once

#include "common/lesson_entry.h"

namespace rt
{
namespace lesson01
{
extern const LessonEntry entry;
}
namespace lesson02
{
extern const LessonEntry entry;
}
} // namespace rt
