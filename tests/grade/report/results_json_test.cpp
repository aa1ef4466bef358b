#include "tests/grade/report/results_json.h"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck.h>

#include "tests/grade/report/sample_results.h"
#include "tests/grade/report/text.h"

namespace rt::grade
{

namespace
{

using Json = nlohmann::json;

/// All that the file keeps of a class; pixels are not.
auto facts(const CriterionResult& one)
{
    const auto example = one.example.value_or(Example{});
    const auto shots = one.pictures.value_or(PictureTriple{});
    return std::make_tuple(one.exercise, one.name, one.hidden, one.cases, one.passed, one.points, one.most, one.outcome,
                           one.mistake, one.example.has_value(), example.what, example.expected, example.got,
                           example.degrees, one.pictures.has_value(), shots.title, shots.x, shots.y, shots.divergence,
                           shots.command);
}

void expectSame(const SubmissionResult& a, const SubmissionResult& b)
{
    const auto all = [](const SubmissionResult& r) {
        return std::tie(r.student, r.lesson, r.key, r.grader, r.state, r.reason, r.compilerErrors, r.remarks,
                        r.studentText, r.sandbox, r.seconds, r.compileSeconds);
    };
    RC_ASSERT(all(a) == all(b));
    RC_ASSERT(a.criteria.size() == b.criteria.size());
    for (std::size_t i = 0; i < a.criteria.size(); ++i) RC_ASSERT(facts(a.criteria[i]) == facts(b.criteria[i]));
}

/// Well-formed, with the characters that formats stumble over.
rc::Gen<std::string> text()
{
    return rc::gen::map(rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
                            "a", "\"", "\\", "\n", "\r", "\t", std::string(1, '\0'), "\x1b[31m", "<", "&", "]]>",
                            "=1+1", ",", "ü", "\u202e", "\u2028", "\uffff", "\U0001f600")),
                        [](const std::vector<std::string>& parts) {
                            std::string joined;
                            for (const auto& part : parts) joined += part;
                            return joined;
                        });
}

rc::Gen<double> amount()
{
    return rc::gen::map(rc::gen::arbitrary<double>(), [](double x) { return std::isfinite(x) ? std::abs(x) : 0.1; });
}

SubmissionResult anyResult()
{
    SubmissionResult result;
    result.student = *text();
    result.lesson = *rc::gen::inRange(0, 9);
    result.key = *text();
    result.grader = *text();
    result.state = State(*rc::gen::inRange(0, 4));
    result.reason = *text();
    result.compilerErrors = *rc::gen::container<std::vector<std::string>>(text());
    result.remarks = *rc::gen::container<std::vector<std::string>>(text());
    result.studentText = *text();
    result.sandbox = *text();
    result.seconds = *amount();
    result.compileSeconds = *amount();
    result.criteria.resize(*rc::gen::inRange<std::size_t>(0, 4));
    for (auto& one : result.criteria)
    {
        one.exercise = *text();
        one.name = *text();
        one.hidden = *rc::gen::arbitrary<bool>();
        one.cases = *rc::gen::inRange(0, 1000);
        one.passed = *rc::gen::inRange(0, one.cases + 1);
        one.most = *amount() / 8;
        one.points = one.most * *rc::gen::inRange(0, 8) / 7.0;
        if (one.points > one.most) one.points = one.most;
        one.outcome = Outcome(*rc::gen::inRange(0, 10));
        one.mistake = *text();
        if (one.hidden) continue;
        if (*rc::gen::arbitrary<bool>()) one.example = Example{*text(), *text(), *text(), {}};
        if (one.example && *rc::gen::arbitrary<bool>()) one.example->degrees = *amount();
        if (*rc::gen::arbitrary<bool>())
            one.pictures = PictureTriple{*text(), {}, {}, {}, *rc::gen::inRange(0, 99), 7, *text(), *text(), {}};
    }
    return result;
}

/// The sentence with which a changed file is refused; "" if it is read.
std::string refusal(const std::function<void(Json&)>& change)
{
    auto json = Json::parse(resultsJson(samples::partial("ada")));
    change(json["extra_data"]["raytree"]);
    try
    {
        resultFromJson(json.dump());
        return "";
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
}

} // namespace

TEST(ResultsJson, ReadsBackTheSame)
{
    EXPECT_TRUE(rc::check("whatever the result", [] {
        const auto result = anyResult();
        expectSame(resultFromJson(resultsJson(result)), result);
    }));
    expectSame(resultFromJson(resultsJson(samples::partial("ada"))), samples::partial("ada"));
}

TEST(ResultsJson, OfHostileTextIsAsciiAndBounded)
{
    const auto text = resultsJson(samples::hostile());
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
    EXPECT_LT(text.size(), 400'000U);
    const auto again = resultsJson(resultFromJson(text));
    EXPECT_TRUE(Json::parse(text)["extra_data"] == Json::parse(again)["extra_data"]) << "what was cut stays as it is";
}

TEST(ResultsJson, SaysWhatGradescopeReads)
{
    const auto json = Json::parse(resultsJson(samples::partial("ada")));
    EXPECT_EQ(json["execution_time"], 2.375);
    EXPECT_EQ(json["stdout_visibility"], "hidden");
    EXPECT_FALSE(json.contains("leaderboard"));
    ASSERT_EQ(json["tests"].size(), 7U);
    EXPECT_EQ(json["tests"][0]["name"], "06-fresnel: into glass");
    EXPECT_EQ(json["tests"][0]["status"], "passed");
    EXPECT_EQ(json["tests"][1]["status"], "failed");
    EXPECT_EQ(json["tests"][1]["max_score"], 1.2);
    EXPECT_EQ(json["tests"][1]["visibility"], "visible");
    EXPECT_NE(json["tests"][1]["output"].get<std::string>().find("Got: Fr = 0.0204"), std::string::npos);
}

TEST(ResultsJson, SaysOfHiddenCasesOnlyTheNameThePointsAndTheMistake)
{
    auto result = samples::partial("ada");
    result.criteria[3].example = Example{"secret input", "secret expected", "secret got", {}};
    result.criteria[3].pictures = samples::pictures();
    const auto text = resultsJson(result);
    EXPECT_EQ(text.find("secret"), std::string::npos);
    const auto hidden = Json::parse(text)["tests"][3];
    EXPECT_EQ(hidden["output"], "Likely mistake: n1 and n2 are swapped");
    EXPECT_EQ(hidden["visibility"], "after_published");
    EXPECT_EQ(Json::parse(resultsJson(result, HiddenTests::never))["tests"][3]["visibility"], "hidden");
    EXPECT_EQ(Json::parse(resultsJson(result, HiddenTests::visible))["tests"][3]["visibility"], "visible");
}

TEST(ResultsJson, TellsNoSumThatHoldsHiddenCriteriaBeforeTheseAreShown)
{
    auto all = samples::partial("ada"), none = all;
    for (auto& one : none.criteria)
        if (one.hidden) one.points = 0;
    ASSERT_NE(all.points(), none.points());
    const auto seen = [](const SubmissionResult& result, HiddenTests hidden) {
        auto json = Json::parse(resultsJson(result, hidden));
        json.erase("extra_data");
        if (hidden == HiddenTests::visible) return json;
        auto& tests = json["tests"];
        for (auto test = tests.begin(); test != tests.end();)
            test = (*test)["visibility"] == "visible" ? test + 1 : tests.erase(test);
        return json;
    };
    for (const auto hidden : {HiddenTests::afterPublished, HiddenTests::never})
        EXPECT_EQ(seen(all, hidden), seen(none, hidden));
    EXPECT_EQ(seen(all, HiddenTests::visible)["score"], all.points());
    std::erase_if(all.criteria, [](const auto& one) { return one.hidden; });
    EXPECT_EQ(seen(all, HiddenTests::afterPublished)["score"], all.points());
}

TEST(ResultsJson, KeepsWhatTheProgramPrintedFromTheStudent)
{
    auto result = samples::partial("ada");
    result.studentText = "leaked 4711";
    auto json = Json::parse(resultsJson(result));
    json.erase("extra_data");
    EXPECT_EQ(json.dump().find("4711"), std::string::npos);
}

TEST(ResultsJson, SaysWhyNothingWasGraded)
{
    const auto json = Json::parse(resultsJson(samples::notCompiled("ada")));
    EXPECT_EQ(json["score"], 0);
    ASSERT_EQ(json["tests"].size(), 1U);
    EXPECT_EQ(json["tests"][0]["name"], "Your file compiles");
    EXPECT_NE(json["tests"][0]["output"].get<std::string>().find("refelct"), std::string::npos);
}

TEST(ResultsJson, RefusesPointsThatAreNotFinite)
{
    auto result = samples::partial("ada");
    result.criteria[0].points = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(resultsJson(result), std::runtime_error);
}

TEST(ResultFromJson, SaysWhatIsWrongInOneSentence)
{
    const std::string at = "extra_data.raytree";
    EXPECT_EQ(refusal([](Json&) {}), "");
    EXPECT_EQ(refusal([](Json& j) { j["version"] = 2; }),
              at + ".version: it is 2, expected 1, the version that this program reads");
    EXPECT_EQ(refusal([](Json& j) { j.erase("key"); }), at + ".key: it is missing, expected a value");
    EXPECT_EQ(refusal([](Json& j) { j["more"] = 1; }),
              at + ": there is an unknown field \"more\", expected none but those of version 1");
    EXPECT_EQ(refusal([](Json& j) { j["lesson"] = 6.5; }),
              at + ".lesson: it is 6.5, expected a whole number from 0 to 99");
    EXPECT_EQ(refusal([](Json& j) { j["lesson"] = -1; }),
              at + ".lesson: it is -1, expected a whole number from 0 to 99");
    EXPECT_EQ(refusal([](Json& j) { j["student"] = nullptr; }), at + ".student: it is null, expected a text");
    EXPECT_EQ(refusal([](Json& j) { j["state"] = "good"; }),
              at + ".state: it is \"good\", expected one of \"graded\", \"missing\", \"refused\", \"not compiled\"");
    EXPECT_EQ(refusal([](Json& j) { j["classes"][1]["points"] = 1.3; }),
              at + ".classes[1].points: it is 1.3, expected at most 1.2");
    EXPECT_EQ(refusal([](Json& j) { j["classes"][1]["points"] = nullptr; }),
              at + ".classes[1].points: it is null, expected a number that is not negative");
    EXPECT_EQ(refusal([](Json& j) { j["classes"][0]["passed"] = 41; }),
              at + ".classes[0].passed: it is 41, expected a whole number from 0 to 40");
    EXPECT_EQ(refusal([](Json& j) {
                  j["classes"][3]["example"] = {{"what", ""}, {"expected", ""}, {"got", ""}};
              }),
              at + ".classes[3].hidden: its cases are hidden, and one is shown, expected no example and no pictures");
    EXPECT_EQ(refusal([](Json& j) { j = Json::array(); }), at + ": it is [], expected an object");
    EXPECT_THROW(resultFromJson("{"), std::runtime_error);
    EXPECT_THROW(resultFromJson("{}"), std::runtime_error);
    EXPECT_THROW(resultFromJson("[]"), std::runtime_error);
    EXPECT_THROW(resultFromJson("{\"extra_data\":[]}"), std::runtime_error);
}

} // namespace rt::grade
