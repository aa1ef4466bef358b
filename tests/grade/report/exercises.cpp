#include "tests/grade/report/exercises.h"

#include <map>
#include <stdexcept>

#include <toml++/toml.h>

#include "common/files/text_file.h"

namespace rt::grade
{

namespace
{

std::map<std::string, ExerciseFacts> readManifest()
{
    const std::string path = RAYTREE_SOURCE_DIR "/lessons/exercises.toml";
    try
    {
        std::map<std::string, ExerciseFacts> all;
        const auto manifest = toml::parse(readTextFile(path));
        for (const auto& entry : *manifest["exercise"].as_array())
        {
            const auto& table = *entry.as_table();
            all[table["id"].value_or(std::string())] = {table["title"].value_or(std::string()),
                                                        table["slide"].value_or(std::string())};
        }
        return all;
    }
    catch (const toml::parse_error& error)
    {
        throw std::runtime_error(path + ": " + std::string(error.description()) +
                                 ", expected the manifest of exercises");
    }
}

} // namespace

const ExerciseFacts* findExercise(const std::string& id)
{
    static const auto all = readManifest();
    const auto at = all.find(id);
    return at == all.end() ? nullptr : &at->second;
}

} // namespace rt::grade
