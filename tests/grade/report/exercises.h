// What the manifest says of an exercise.
#pragma once

#include <string>

namespace rt::grade
{

struct ExerciseFacts
{
    std::string title; ///< "The share that is reflected, exactly"
    std::string slide; ///< a heading of the lecture
};

/// The exercise of lessons/exercises.toml with that id; null if there is none. Throws std::runtime_error if the file
/// cannot be read.
const ExerciseFacts* findExercise(const std::string& id);

} // namespace rt::grade
