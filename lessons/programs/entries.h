// The entry of each lesson; each is defined in the lesson's own entry.cpp.
#pragma once

namespace rt
{

struct LessonEntry;

namespace lesson01
{
extern const LessonEntry entry;
}
namespace lesson02
{
extern const LessonEntry entry;
}
namespace lesson03
{
extern const LessonEntry entry;
}
namespace lesson04
{
extern const LessonEntry entry;
}
namespace lesson05
{
extern const LessonEntry entry;
}
namespace lesson06
{
extern const LessonEntry entry;
}
namespace lesson07
{
extern const LessonEntry entry;
}
namespace lesson08
{
extern const LessonEntry entry;
}
} // namespace rt
