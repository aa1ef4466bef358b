// The ids of a lesson's exercises.
#pragma once

#include <string>
#include <vector>

namespace rt::grade
{

/// From lessons/exercises.toml, in its order. Throws std::runtime_error if it cannot be read.
std::vector<std::string> exerciseIds(int lesson);

} // namespace rt::grade
