// Checked access to the tables of a scene file, for scene_file.cpp: every value is read with its type, its range and its
// place, and every fault becomes one sentence.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

// The library, not the headers alone: those assert on input such as "[[[", unless built without assertions.
#ifndef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 0
#endif

#include <fmt/format.h>
#include <toml++/toml.h>

#include "common/files/scene_file.h"
#include "common/files/scene_text.h"

namespace rt
{

/// What a number may be; `words` completes the sentence "expected a number".
struct NumberRange
{
    double least, most;
    bool endsIncluded;
    const char* words;

    bool contains(double x) const
    {
        return std::isfinite(x) && (endsIncluded ? x >= least && x <= most : x > least && x < most);
    }
};

inline constexpr NumberRange anyNumber{-infinity<double>, infinity<double>, true, ""};
inline constexpr NumberRange positiveNumber{0, infinity<double>, false, " greater than 0"};
inline constexpr NumberRange notNegative{0, infinity<double>, true, " of at least 0"};
inline constexpr NumberRange zeroToOne{0, 1, true, " from 0 to 1"};

inline constexpr std::array<std::string_view, 2> skyMappingWords{"latlong", "angular"}; ///< in the order of SkyMapping

/// A number as TOML writes it: shortest digits that read back to the same double, never mistaken for a whole number.
inline std::string tomlNumber(double x)
{
    std::string digits = fmt::format("{}", x);
    return digits.find_first_of(".en") == digits.npos ? digits + ".0" : digits;
}

/// What stands in the file, after "got".
inline std::string described(const toml::node& node)
{
    if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
    if (const auto* number = node.as_floating_point()) return tomlNumber(number->get());
    if (const auto* yes = node.as_boolean()) return yes->get() ? "true" : "false";
    if (node.is_string()) return "a string";
    if (node.is_array_of_tables()) return "an array of tables";
    if (const auto* array = node.as_array())
        return array->empty() ? "an empty array" : fmt::format("an array of {}", array->size());
    if (node.is_table()) return "a table";
    return "a date or time";
}

/// One table of a scene file. Asking for a key makes it known; finish() then refuses the keys that nobody asked for, and
/// the table if a required one is absent. The `read` functions leave `out` alone and return false if the key is absent.
class SceneTable
{
public:
    /// `title` is the table's name in messages, such as "[camera]".
    SceneTable(const std::string& fileName, const toml::table& source, std::string tableTitle)
        : file(fileName), table(source), title(std::move(tableTitle))
    {
    }

    [[noreturn]] void fail(const toml::source_position& place, std::string_view sentence) const
    {
        throw SceneError(message(place, sentence));
    }

    std::string message(const toml::source_position& place, std::string_view sentence) const
    {
        return fmt::format("{}:{}:{}: {}", file, place.line, place.column, sentence);
    }

    [[noreturn]] void wrong(std::string_view key, const toml::source_position& place, std::string_view expected,
                            std::string_view got) const
    {
        fail(place, fmt::format("{} in {}: expected {}, got {}", inQuotes(key), title, expected, got));
    }

    /// Where the key's value stands; where the table stands if the key is absent.
    toml::source_position place(std::string_view key) const
    {
        const auto* value = table.get(key);
        return value ? value->source().begin : table.source().begin;
    }

    /// Where the key itself stands; it must be there.
    toml::source_position placeOfKey(std::string_view key) const { return table.find(key)->first.source().begin; }

    bool has(std::string_view key) const { return table.contains(key); }

    const toml::node* find(std::string_view key)
    {
        known.push_back(key);
        return table.get(key);
    }

    bool read(std::string_view key, std::string& out)
    {
        const auto* value = find(key);
        if (!value) return false;
        if (!value->is_string()) wrong(key, value->source().begin, "a string", described(*value));
        out = value->as_string()->get();
        return true;
    }

    bool read(std::string_view key, double& out, const NumberRange& range = anyNumber)
    {
        const auto* value = find(key);
        if (value) out = number(key, *value, range, fmt::format("a number{}", range.words), "");
        return value != nullptr;
    }

    bool read(std::string_view key, Vec3<double>& out, const NumberRange& range = anyNumber)
    {
        const auto* value = find(key);
        if (value) out = triple(key, *value, range);
        return value != nullptr;
    }

    bool read(std::string_view key, std::array<Vec3<double>, 3>& out)
    {
        const auto* value = find(key);
        if (!value) return false;
        const auto& array = arrayOf(key, *value, 3, "an array of 3 points, each an array of 3 numbers");
        for (std::size_t i = 0; i < 3; ++i) out[i] = triple(key, array[i], anyNumber);
        return true;
    }

    bool read(std::string_view key, int& out, int least, int most)
    {
        const auto* value = find(key);
        if (value) out = whole(key, *value, least, most, "");
        return value != nullptr;
    }

    /// Two whole numbers, x from least to mostX and y from least to mostY.
    bool read(std::string_view key, int& x, int& y, int least, int mostX, int mostY)
    {
        const auto* value = find(key);
        if (!value) return false;
        const auto& array = arrayOf(key, *value, 2, "an array of 2 whole numbers");
        x = whole(key, array[0], least, mostX, " as the first of 2");
        y = whole(key, array[1], least, mostY, " as the second of 2");
        return true;
    }

    /// One of the words; an enum's values stand in the same order.
    template <class Enum, std::size_t n>
    bool read(std::string_view key, Enum& out, const std::array<std::string_view, n>& words)
    {
        std::string word;
        if (!read(key, word)) return false;
        const auto found = std::find(words.begin(), words.end(), word);
        if (found == words.end())
        {
            const std::vector<std::string_view> all(words.begin(), words.end());
            wrong(key, place(key), listed(all, "or"), inQuotes(word) + didYouMean(word, all));
        }
        out = static_cast<Enum>(found - words.begin());
        return true;
    }

    /// A table inside this one, written as `form`; nullptr if absent.
    const toml::table* child(std::string_view key, std::string_view form)
    {
        const auto* value = find(key);
        if (value && !value->is_table())
            wrong(key, value->source().begin, fmt::format("a table, {}", form), described(*value));
        return value ? value->as_table() : nullptr;
    }

    /// The tables [[key]], in the order of the file.
    std::vector<const toml::table*> children(std::string_view key)
    {
        const auto* value = find(key);
        if (!value) return {};
        const std::string expected = fmt::format("tables, each headed [[{}]]", key);
        if (!value->is_array()) wrong(key, value->source().begin, expected, described(*value));

        std::vector<const toml::table*> tables;
        for (const auto& element : *value->as_array())
        {
            if (!element.is_table()) wrong(key, element.source().begin, expected, described(element));
            tables.push_back(element.as_table());
        }
        return tables;
    }

    /// Notes where the table's values stand, as fields of `owner`: `sphere0` gives `sphere0.radius`.
    void notePlaces(FieldPlaces& places, const std::string& owner) const
    {
        for (const auto& [key, value] : table)
        {
            const auto& begin = value.source().begin;
            places.emplace(owner + "." + std::string(key.str()), TextPlace{int(begin.line), int(begin.column)});
        }
    }

    void require(std::initializer_list<std::string_view> keys) { required = keys; }

    /// Refuses two keys that contradict each other, at the later one.
    void refuseBoth(std::string_view one, std::string_view other, std::string_view expected) const
    {
        if (!has(one) || !has(other)) return;
        if (placeOfKey(one) < placeOfKey(other)) std::swap(one, other);
        fail(placeOfKey(one), fmt::format("{} in {} beside {}, {}", inQuotes(one), title, inQuotes(other), expected));
    }

    /// Refuses a key that means nothing without the other one.
    void refuseWithout(std::string_view one, std::string_view other, std::string_view expected) const
    {
        if (!has(one) || has(other)) return;
        fail(placeOfKey(one), fmt::format("{} in {} without {}, {}", inQuotes(one), title, inQuotes(other), expected));
    }

    void finish() const
    {
        const toml::key* unknown = nullptr; // toml++ sorts the keys; the first in the file is the one to tell
        for (const auto& [key, value] : table)
        {
            const bool isKnown = std::find(known.begin(), known.end(), key.str()) != known.end();
            if (!isKnown && (!unknown || key.source().begin < unknown->source().begin)) unknown = &key;
        }
        if (unknown)
        {
            const auto& value = *table.get(unknown->str());
            const char* kind = value.is_table() || value.is_array_of_tables() ? "table" : "key";
            auto hint = didYouMean(unknown->str(), known);
            if (hint.empty()) hint = fmt::format(", expected {}", listed(known, "or"));
            fail(unknown->source().begin,
                 fmt::format("unknown {} {} in {}{}", kind, inQuotes(unknown->str()), title, hint));
        }
        for (const auto key : required)
            if (!table.contains(key))
                fail(table.source().begin,
                     fmt::format("missing key {} in {}, expected {}", inQuotes(key), title, listed(required, "and")));
    }

    const std::string& file;
    const toml::table& table;
    const std::string title;

private:
    const toml::array& arrayOf(std::string_view key, const toml::node& value, std::size_t size,
                               std::string_view expected) const
    {
        const auto* array = value.as_array();
        if (!array || array->size() != size) wrong(key, value.source().begin, expected, described(value));
        return *array;
    }

    double number(std::string_view key, const toml::node& value, const NumberRange& range, std::string_view expected,
                  std::string_view where) const
    {
        const auto x = value.value<double>(); // a whole number is a number, too
        const bool isNumber = value.is_number() && x;
        if (!isNumber || !range.contains(*x))
            wrong(key, value.source().begin, expected, described(value).append(where));
        return *x;
    }

    Vec3<double> triple(std::string_view key, const toml::node& value, const NumberRange& range) const
    {
        const auto expected =
            fmt::format("an array of 3 numbers{}{}", range.words[0] == 0 ? "" : ", each", range.words);
        const auto& array = arrayOf(key, value, 3, expected);
        return {number(key, array[0], range, expected, " as the first"),
                number(key, array[1], range, expected, " as the second"),
                number(key, array[2], range, expected, " as the third")};
    }

    int whole(std::string_view key, const toml::node& value, int least, int most, std::string_view where) const
    {
        const auto* integer = value.as_integer();
        if (!integer || integer->get() < least || integer->get() > most)
            wrong(key, value.source().begin, fmt::format("a whole number from {} to {}{}", least, most, where),
                  described(value));
        return int(integer->get());
    }

    std::vector<std::string_view> known, required;
};

} // namespace rt
