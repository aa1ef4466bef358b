#include "tests/grade/wire/exercise_ids.h"

#include <stdexcept>

#include <fmt/format.h>
#include <toml++/toml.h>

namespace rt::grade
{

std::vector<std::string> exerciseIds(int lesson)
{
    std::vector<std::string> ids;
    try
    {
        const auto manifest = toml::parse_file(RAYTREE_SOURCE_DIR "/lessons/exercises.toml");
        if (const auto* exercises = manifest["exercise"].as_array())
            for (const auto& exercise : *exercises)
                if (const auto* entry = exercise.as_table(); entry && (*entry)["lesson"].value<int>() == lesson)
                    ids.push_back((*entry)["id"].value_or(std::string()));
    }
    catch (const toml::parse_error& error)
    {
        throw std::runtime_error(fmt::format("lessons/exercises.toml: {}", std::string(error.description())));
    }
    if (ids.empty())
        throw std::runtime_error(fmt::format("lessons/exercises.toml has no exercises of lesson {}", lesson));
    return ids;
}

} // namespace rt::grade
