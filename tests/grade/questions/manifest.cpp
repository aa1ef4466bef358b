#include "tests/grade/questions/manifest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "common/files/scene_text.h"
#include "common/files/text_file.h"

namespace rt::grade
{

namespace
{

constexpr std::array<std::string_view, 7> keys{"id", "lesson", "points", "title", "slide", "hint", "cases"};

/// One [[exercise]], with the words for what is wrong with it.
struct Entry
{
    const std::string& file;
    const toml::table& table;

    [[noreturn]] void fail(const toml::node& at, const std::string& what) const
    {
        const auto& place = at.source().begin;
        throw std::runtime_error(fmt::format("{}:{}:{}: {}", file, place.line, place.column, what));
    }

    const toml::node& need(std::string_view key) const
    {
        if (const auto* node = table.get(key)) return *node;
        fail(table,
             fmt::format("an exercise without `{}`, expected {}", key, listed({keys.begin(), keys.end()}, "and")));
    }

    std::string text(std::string_view key) const
    {
        const auto value = need(key).value_exact<std::string>();
        if (!value || value->empty()) fail(need(key), fmt::format("`{}` is not a text, expected one in quotes", key));
        return *value;
    }

    double number(std::string_view key, double least, double most) const
    {
        const auto value = need(key).value<double>();
        if (!value || !(*value >= least && *value <= most))
            fail(need(key), fmt::format("`{}` is not a number from {} to {}", key, least, most));
        return *value;
    }

    std::vector<std::string> texts(std::string_view key) const
    {
        const auto* array = need(key).as_array();
        if (!array || array->empty())
            fail(need(key), fmt::format("`{}` is not a list, expected at least one text", key));
        std::vector<std::string> all;
        for (const auto& node : *array)
        {
            const auto value = node.value_exact<std::string>();
            if (!value) fail(node, fmt::format("an entry of `{}` is not a text, expected one in quotes", key));
            all.push_back(*value);
        }
        return all;
    }
};

/// The project's own.
const std::vector<Exercise>& manifest()
{
    static const auto all = [] {
        const std::string path = std::string(RAYTREE_SOURCE_DIR) + "/lessons/exercises.toml";
        return parseManifest(readTextFile(path), "lessons/exercises.toml");
    }();
    return all;
}

} // namespace

std::vector<Exercise> parseManifest(std::string_view text, const std::string& name)
{
    toml::table root;
    try
    {
        root = toml::parse(text);
    }
    catch (const toml::parse_error& error)
    {
        const auto& place = error.source().begin;
        throw std::runtime_error(fmt::format("{}:{}:{}: not valid TOML: {}", name, place.line, place.column,
                                             onOneLine(error.description(), 500)));
    }
    const auto* list = root["exercise"].as_array();
    if (!list || list->empty()) throw std::runtime_error(name + ":1:1: no exercises, expected [[exercise]]");
    std::vector<Exercise> all;
    for (const auto& node : *list)
    {
        if (!node.is_table()) Entry{name, root}.fail(node, "`exercise` is not a table, expected [[exercise]]");
        const Entry entry{name, *node.as_table()};
        for (const auto& [key, value] : entry.table)
            if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
                entry.fail(value, fmt::format("unknown key {}{}", inQuotes(key.str()),
                                              didYouMean(key.str(), {keys.begin(), keys.end()})));
        Exercise exercise{entry.text("id"),
                          int(entry.number("lesson", 0, 99)),
                          entry.number("points", 0.5, 1000),
                          entry.text("title"),
                          entry.text("slide"),
                          entry.text("hint"),
                          entry.texts("cases")};
        if (!exercise.id.starts_with(fmt::format("{:02}-", exercise.lesson)))
            entry.fail(entry.need("id"), fmt::format("the id {} does not begin with its lesson, expected {:02}-...",
                                                     exercise.id, exercise.lesson));
        for (const auto& other : all)
            if (other.id == exercise.id) entry.fail(entry.need("id"), "two exercises have the id " + exercise.id);
        all.push_back(exercise);
    }
    return all;
}

std::vector<Exercise> exercisesOf(int lesson)
{
    std::vector<Exercise> some;
    for (const auto& exercise : manifest())
        if (exercise.lesson == lesson) some.push_back(exercise);
    return some;
}

std::vector<int> exerciseLessons()
{
    std::set<int> lessons;
    for (const auto& exercise : manifest()) lessons.insert(exercise.lesson);
    return {lessons.begin(), lessons.end()};
}

} // namespace rt::grade
