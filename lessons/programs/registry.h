// All lessons, in order.
#pragma once

#include <span>

#include "common/program/lesson_entry.h"
#include "lessons/programs/facts.h"

namespace rt
{

std::span<const LessonEntry* const> lessons();

/// The lesson of that number; null if there is none.
const LessonEntry* findLesson(int number);

/// The first lesson that models all that the scene requires; null if none does.
const LessonEntry* smallestLesson(const SceneDescription& scene);

} // namespace rt
