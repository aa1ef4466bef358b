#include "tests/grade/report/junit_xml.h"

#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "tests/grade/report/feedback.h"
#include "tests/grade/report/text.h"

namespace rt::grade
{

namespace
{

void set(pugi::xml_node node, const char* attribute, const std::string& value)
{
    node.append_attribute(attribute).set_value(value.c_str());
}

void addCase(pugi::xml_node suite, const CriterionResult& one)
{
    auto test = suite.append_child("testcase");
    set(test, "classname", cleanLine(one.exercise));
    set(test, "name", cleanLine(one.name) + (one.hidden ? " (hidden cases)" : ""));
    if (isFull(one)) return;
    auto failure = test.append_child("failure");
    set(failure, "type", one.hidden ? "hidden cases" : name(one.outcome));
    set(failure, "message", fmt::format("{} of {} points", pointsText(one.points), pointsText(one.most)));
    std::string text;
    for (const auto& line : criterionFeedback(one)) text += line + "\n";
    failure.text().set(text.c_str());
}

void addSuite(pugi::xml_node root, const SubmissionResult& result)
{
    auto suite = root.append_child("testsuite");
    set(suite, "name", cleanLine(result.student));
    int failures = 0;
    for (const auto& one : result.criteria) failures += isFull(one) ? 0 : 1;
    const bool graded = result.state == State::graded;
    set(suite, "tests", fmt::format("{}", result.criteria.size() + (graded ? 0 : 1)));
    set(suite, "failures", fmt::format("{}", failures));
    set(suite, "errors", graded ? "0" : "1");
    set(suite, "time", fmt::format("{:.3f}", result.seconds));
    for (const auto& one : result.criteria) addCase(suite, one);
    if (graded) return;
    auto test = suite.append_child("testcase");
    set(test, "classname", fmt::format("lesson {:02}", result.lesson));
    set(test, "name", "can be graded");
    auto error = test.append_child("error");
    set(error, "type", name(result.state));
    set(error, "message", stateSentence(result));
    std::string text;
    for (const auto& message : result.compilerErrors) text += cleanText(message) + "\n";
    error.text().set(text.c_str());
}

} // namespace

std::string junitXml(std::span<const SubmissionResult> results)
{
    pugi::xml_document document;
    auto declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    auto root = document.append_child("testsuites");
    set(root, "name", "raytree");
    for (const auto& result : results) addSuite(root, result);
    std::ostringstream text;
    document.save(text, " ");
    return text.str();
}

} // namespace rt::grade
