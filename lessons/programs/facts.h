// What is known of each lesson without its code: programs of exercises need no more.
#pragma once

#include <span>

#include "common/program/lesson_facts.h"

namespace rt
{

/// All lessons that have a tracer, 01 to 08, in order.
std::span<const LessonFacts> lessonFacts();

/// Those of one lesson; throws std::out_of_range if it has no tracer.
const LessonFacts& lessonFacts(int number);

/// The first lesson that models all that the scene requires; null if none does.
const LessonFacts* smallestFacts(const SceneDescription& scene);

/// "lesson 02 (mirrors)": the first lesson that models the feature.
std::string lessonThatBrings(Feature feature);

/// Throws SceneError if the lesson does not model all that the scene requires, unless forced: then it only says so.
void checkModels(const LessonFacts& lesson, const SceneDescription& scene, bool force);

} // namespace rt
