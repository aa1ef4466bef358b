#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/files/text_file.h"
#include "tests/grade/report/results_json.h"
#include "tests/grade/report/text.h"

namespace rt::grade
{

namespace
{

using Json = nlohmann::json;

constexpr int mostLesson = 99, mostCount = 1'000'000'000, mostSide = 1'000'000;

[[noreturn]] void refuse(const std::string& field, const std::string& found, const std::string& expected)
{
    throw std::runtime_error(fmt::format("{}: {}, expected {}", field, found, expected));
}

std::string shown(const Json& value)
{
    return cleanLine(value.dump(-1, ' ', true, Json::error_handler_t::replace), 160);
}

/// An object whose fields are taken one by one; what nobody took is refused.
class Fields
{
public:
    Fields(const Json& object, std::string place) : json(object), path(std::move(place))
    {
        if (!json.is_object()) refuse(path, "it is " + shown(json), "an object");
    }

    const Json* find(const std::string& key)
    {
        taken.insert(key);
        const auto at = json.find(key);
        return at == json.end() ? nullptr : &*at;
    }

    const Json& get(const std::string& key)
    {
        const Json* value = find(key);
        if (!value) refuse(field(key), "it is missing", "a value");
        return *value;
    }

    std::string text(const std::string& key) { return text(get(key), field(key)); }

    static std::string text(const Json& value, const std::string& name)
    {
        if (!value.is_string()) refuse(name, "it is " + shown(value), "a text");
        return value.get<std::string>();
    }

    std::vector<std::string> texts(const std::string& key)
    {
        std::vector<std::string> all;
        for (const auto& value : array(key)) all.push_back(text(value, fmt::format("{}[{}]", field(key), all.size())));
        return all;
    }

    const Json& array(const std::string& key)
    {
        const Json& value = get(key);
        if (!value.is_array()) refuse(field(key), "it is " + shown(value), "an array");
        return value;
    }

    bool truth(const std::string& key)
    {
        const Json& value = get(key);
        if (!value.is_boolean()) refuse(field(key), "it is " + shown(value), "true or false");
        return value.get<bool>();
    }

    int count(const std::string& key, int most)
    {
        const Json& value = get(key);
        if (!value.is_number_integer() || value < 0 || value > most)
            refuse(field(key), "it is " + shown(value), fmt::format("a whole number from 0 to {}", most));
        return value.get<int>();
    }

    double number(const std::string& key)
    {
        const Json& value = get(key);
        if (!value.is_number() || !std::isfinite(value.get<double>()) || value.get<double>() < 0)
            refuse(field(key), "it is " + shown(value), "a number that is not negative");
        return value.get<double>();
    }

    template <class Enum>
    Enum word(const std::string& key, Enum last)
    {
        const std::string value = text(key);
        std::string known;
        for (int i = 0; i <= int(last); ++i)
        {
            if (value == name(Enum(i))) return Enum(i);
            known += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", name(Enum(i)));
        }
        refuse(field(key), "it is " + shown(value), "one of " + known);
    }

    void done() const
    {
        for (const auto& [key, value] : json.items())
            if (!taken.contains(key))
                refuse(path, "there is an unknown field " + shown(key), "none but those of version 1");
    }

    std::string field(const std::string& key) const { return path + "." + key; }

private:
    const Json& json;
    std::string path;
    std::set<std::string> taken;
};

Example exampleFrom(Fields fields)
{
    Example example{fields.text("what"), fields.text("expected"), fields.text("got"), {}};
    if (fields.find("degrees")) example.degrees = fields.number("degrees");
    fields.done();
    return example;
}

PictureTriple picturesFrom(Fields fields)
{
    PictureTriple pictures;
    pictures.title = fields.text("title");
    pictures.x = fields.count("x", mostSide);
    pictures.y = fields.count("y", mostSide);
    pictures.divergence = fields.text("divergence");
    pictures.command = fields.text("command");
    fields.done();
    return pictures;
}

CriterionResult criterionFrom(Fields fields)
{
    CriterionResult one;
    one.exercise = fields.text("exercise");
    one.name = fields.text("name");
    one.hidden = fields.truth("hidden");
    one.cases = fields.count("cases", mostCount);
    one.passed = fields.count("passed", one.cases);
    one.most = fields.number("most");
    one.points = fields.number("points");
    if (one.points > one.most)
        refuse(fields.field("points"), fmt::format("it is {}", one.points), fmt::format("at most {}", one.most));
    one.outcome = fields.word("outcome", Outcome::notRun);
    one.mistake = fields.text("mistake");
    if (const Json* example = fields.find("example")) one.example = exampleFrom({*example, fields.field("example")});
    if (const Json* shots = fields.find("pictures")) one.pictures = picturesFrom({*shots, fields.field("pictures")});
    if (one.hidden && (one.example || one.pictures))
        refuse(fields.field("hidden"), "its cases are hidden, and one is shown", "no example and no pictures");
    fields.done();
    return one;
}

SubmissionResult resultFrom(Fields fields)
{
    const Json& version = fields.get("version");
    if (version != 1)
        refuse(fields.field("version"), "it is " + shown(version), "1, the version that this program reads");
    SubmissionResult result;
    result.student = fields.text("student");
    result.lesson = fields.count("lesson", mostLesson);
    result.key = fields.text("key");
    result.grader = fields.text("grader");
    result.state = fields.word("state", State::notCompiled);
    result.reason = fields.text("reason");
    result.compilerErrors = fields.texts("compiler_errors");
    for (const auto& one : fields.array("classes"))
        result.criteria.push_back(
            criterionFrom({one, fmt::format("{}[{}]", fields.field("classes"), result.criteria.size())}));
    result.remarks = fields.texts("remarks");
    result.studentText = fields.text("student_text");
    result.sandbox = fields.text("sandbox");
    result.seconds = fields.number("seconds");
    result.compileSeconds = fields.number("compile_seconds");
    fields.done();
    return result;
}

} // namespace

SubmissionResult resultFromJson(const std::string& text)
{
    Json json;
    try
    {
        json = Json::parse(text);
    }
    catch (const Json::exception& error)
    {
        refuse("results.json", "it is not JSON (" + cleanLine(error.what(), 200) + ")",
               "a results.json of this grader");
    }
    const auto at = Json::json_pointer("/extra_data/raytree");
    if (!json.contains(at)) refuse("extra_data.raytree", "it is missing", "a results.json of this grader");
    return resultFrom({json.at(at), "extra_data.raytree"});
}

SubmissionResult readResult(const std::string& path)
{
    const std::string text = readTextFile(path);
    try
    {
        return resultFromJson(text);
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
    }
}

} // namespace rt::grade
