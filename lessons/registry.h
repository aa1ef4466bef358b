// All lessons, in order.
#pragma once

#include <span>

#include "common/lesson_entry.h"

namespace rt
{

std::span<const LessonEntry* const> lessons();

/// The lesson of that number; null if there is none.
const LessonEntry* findLesson(int number);

/// The first lesson that models all that the scene requires; null if none does.
const LessonEntry* smallestLesson(const SceneDescription& scene);

/// "02 (mirrors)": the first lesson that models the feature.
std::string lessonThatBrings(Feature feature);

/// Throws SceneError if the lesson does not model all that the scene requires, unless forced: then it only says so.
void checkModels(const LessonEntry& lesson, const SceneDescription& scene, bool force);

} // namespace rt
