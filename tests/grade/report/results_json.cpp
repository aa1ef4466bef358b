#include "tests/grade/report/results_json.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/grade/report/feedback.h"
#include "tests/grade/report/text.h"

namespace rt::grade
{

namespace
{

using OrderedJson = nlohmann::ordered_json;

constexpr int resultsVersion = 1;

/// Exact where it may be: a cut only if there is too much.
std::string kept(const std::string& text)
{
    std::string whole = repaired(text);
    return whole.size() <= textLimit ? whole : cleanText(whole);
}

double finite(double number, const char* field)
{
    if (!std::isfinite(number))
        throw std::runtime_error(fmt::format("the result's {} is {}, expected a finite number", field, number));
    return number;
}

/// Four decimals: enough for a reader, and no 0.30000000000000004.
double rounded(double number)
{
    const double result = std::round(number * 1e4) / 1e4;
    return result == 0 ? 0 : result;
}

OrderedJson texts(const std::vector<std::string>& all)
{
    OrderedJson array = OrderedJson::array();
    for (const auto& text : all) array.push_back(kept(text));
    return array;
}

OrderedJson exact(const CriterionResult& one)
{
    OrderedJson json{{"exercise", kept(one.exercise)},
                     {"name", kept(one.name)},
                     {"hidden", one.hidden},
                     {"cases", one.cases},
                     {"passed", one.passed},
                     {"points", finite(one.points, "points")},
                     {"most", finite(one.most, "most points")},
                     {"outcome", name(one.outcome)},
                     {"mistake", kept(one.mistake)}};
    if (one.example && !one.hidden)
    {
        const auto& [what, expected, got, degrees] = *one.example;
        json["example"] = {{"what", kept(what)}, {"expected", kept(expected)}, {"got", kept(got)}};
        // An angle to what is not a number is none.
        if (degrees && std::isfinite(*degrees)) json["example"]["degrees"] = *degrees;
    }
    if (one.pictures && !one.hidden)
        json["pictures"] = {{"title", kept(one.pictures->title)},
                            {"x", one.pictures->x},
                            {"y", one.pictures->y},
                            {"divergence", kept(one.pictures->divergence)},
                            {"command", kept(one.pictures->command)}};
    return json;
}

OrderedJson exact(const SubmissionResult& result)
{
    OrderedJson json{{"version", resultsVersion},
                     {"student", repaired(result.student)},
                     {"lesson", result.lesson},
                     {"key", kept(result.key)},
                     {"grader", kept(result.grader)},
                     {"state", name(result.state)},
                     {"reason", kept(result.reason)},
                     {"compiler_errors", texts(result.compilerErrors)},
                     {"classes", OrderedJson::array()},
                     {"remarks", texts(result.remarks)},
                     {"student_text", kept(result.studentText)},
                     {"sandbox", kept(result.sandbox)},
                     {"seconds", finite(result.seconds, "seconds")},
                     {"compile_seconds", finite(result.compileSeconds, "compile seconds")}};
    for (const auto& one : result.criteria) json["classes"].push_back(exact(one));
    return json;
}

std::string joined(const std::vector<std::string>& lines)
{
    std::string text;
    for (const auto& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

const char* visibility(HiddenTests hidden)
{
    return hidden == HiddenTests::visible ? "visible" : hidden == HiddenTests::never ? "hidden" : "after_published";
}

OrderedJson test(const CriterionResult& one, HiddenTests hidden)
{
    return {{"name", criterionName(one)},
            {"score", rounded(one.points)},
            {"max_score", rounded(one.most)},
            {"status", isFull(one) ? "passed" : "failed"},
            {"output", joined(criterionFeedback(one))},
            {"output_format", "text"},
            {"visibility", one.hidden ? visibility(hidden) : "visible"}};
}

OrderedJson tests(const SubmissionResult& result, HiddenTests hidden)
{
    OrderedJson array = OrderedJson::array();
    for (const auto& one : result.criteria) array.push_back(test(one, hidden));
    if (result.state == State::graded) return array;
    std::vector<std::string> lines = {stateSentence(result)};
    for (const auto& error : result.compilerErrors) lines.push_back(cleanText(error));
    array.push_back({{"name", result.state == State::notCompiled ? "Your file compiles" : "Your file can be graded"},
                     {"score", 0},
                     {"max_score", 0},
                     {"status", "failed"},
                     {"output", joined(lines)},
                     {"output_format", "text"},
                     {"visibility", "visible"}});
    return array;
}

/// Gradescope shows `output`, and may show a `score` given here, at once; it must not tell how hidden criteria went before these
/// are shown themselves. Without a `score` it adds up the tests, those that a student may see by then.
bool tellsTheSum(const SubmissionResult& result, HiddenTests hidden)
{
    return hidden == HiddenTests::visible ||
           std::none_of(result.criteria.begin(), result.criteria.end(), [](const auto& one) { return one.hidden; });
}

std::string publicSentence(const SubmissionResult& result)
{
    SubmissionResult shown;
    std::copy_if(result.criteria.begin(), result.criteria.end(), std::back_inserter(shown.criteria),
                 [](const auto& one) { return !one.hidden; });
    return fmt::format("Graded: {} of {} points for the public cases; hidden cases have {} more.",
                       pointsText(shown.points()), pointsText(shown.most()), pointsText(result.most() - shown.most()));
}

} // namespace

std::string resultsJson(const SubmissionResult& result, HiddenTests hidden)
{
    const bool whole = tellsTheSum(result, hidden);
    std::vector<std::string> lines = {whole ? stateSentence(result) : publicSentence(result)};
    for (const auto& remark : result.remarks) lines.push_back(cleanLine(remark));
    const double points = rounded(finite(result.points(), "points"));
    OrderedJson json{{"execution_time", rounded(finite(result.seconds, "seconds"))},
                     {"output", joined(lines)},
                     {"output_format", "text"},
                     {"test_output_format", "text"},
                     {"test_name_format", "text"},
                     {"visibility", "visible"},
                     {"stdout_visibility", "hidden"},
                     {"tests", tests(result, hidden)},
                     {"extra_data", {{"raytree", exact(result)}}}};
    if (whole) json["score"] = points;
    return json.dump(1, ' ', true) + "\n";
}

} // namespace rt::grade
