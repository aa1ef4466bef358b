// The entry of each lesson: lesson01::entry and so on. Each is defined in a file of its own, made of entry.cpp.in.
#pragma once

#include "lessons/list.h"

namespace rt
{

struct LessonEntry;

#define RAYTREE_ENTRY(number, NN)                                                                                      \
    namespace lesson##NN                                                                                               \
    {                                                                                                                  \
        extern const LessonEntry entry;                                                                                \
    }
RAYTREE_FOR_EACH_LESSON(RAYTREE_ENTRY)
#undef RAYTREE_ENTRY

} // namespace rt
