// lessons/exercises.toml, read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt::grade
{

struct Exercise
{
    std::string id; ///< "06-fresnel"
    int lesson = 0;
    double points = 0; ///< > 0
    std::string title, slide, hint;
    std::vector<std::string> cases; ///< groups of the lesson's own cases, at least one
};

/// In the order of the text; `name` stands for the file in messages. Throws std::runtime_error: "name:line:column: what is
/// wrong, what is expected".
std::vector<Exercise> parseManifest(std::string_view text, const std::string& name);

/// The exercises of one lesson from the project's own manifest, which is read once. Throws as parseManifest does.
std::vector<Exercise> exercisesOf(int lesson);

/// The lessons that have exercises, in their order. Throws as parseManifest does.
std::vector<int> exerciseLessons();

} // namespace rt::grade
