// Comparing wrong answers with those of known mistakes. Nothing here needs a lesson or a mutant.
#include "tests/grade/questions/mistakes.h"

#include <cmath>
#include <cstdlib>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/todo.h"
#include "tests/grade/questions/manifest.h"
#include "tests/grade/questions/question.h"
#include "tests/lessons/cases.h"

namespace rt::grade
{

namespace
{

/// The same words, and numbers that agree to five digits: a student may compute in float.
bool sameAnswer(const std::string& a, const std::string& b)
{
    const char *p = a.c_str(), *q = b.c_str();
    const auto startsNumber = [](const char* s) {
        if (*s == '-') ++s;
        return (*s >= '0' && *s <= '9') || std::string_view(s).starts_with("nan") ||
               std::string_view(s).starts_with("inf");
    };
    while (*p && *q)
    {
        if (startsNumber(p) && startsNumber(q))
        {
            char *pEnd = nullptr, *qEnd = nullptr;
            const double x = std::strtod(p, &pEnd), y = std::strtod(q, &qEnd);
            const bool equal = x == y || (std::isnan(x) && std::isnan(y));
            if (!equal && !(std::abs(x - y) <= 1e-5 * std::max(1.0, std::abs(x)))) return false;
            p = pEnd;
            q = qEnd;
        }
        else if (*p++ != *q++)
            return false;
    }
    return *p == *q;
}

template <class Case, class Subject>
void addFailures(Evidence& evidence, const Case& which, const Subject& subject)
{
    cases::Check check;
    std::string ended;
    try
    {
        which.run(check, subject);
    }
    catch (const NotAttempted&)
    {
        throw;
    }
    catch (const Died& died)
    {
        ended = name(died.outcome);
    }
    catch (const std::exception&)
    {
        ended = "threw";
    }
    const auto key = [&](std::size_t i) { return fmt::format("{}_{} {}", which.group, which.name, i); };
    for (std::size_t i = 0; i < check.failures.size(); ++i)
        evidence[key(i)] = check.failures[i].what + ": " + check.failures[i].got;
    if (!ended.empty()) evidence[key(check.failures.size())] = ended;
}

} // namespace

std::string likelyMistake(const std::string& exercise, const Evidence& evidence, const std::vector<KnownMistake>& known)
{
    // A single wrong answer may have many reasons.
    constexpr std::size_t fewest = 3;
    constexpr double share = 0.95;
    double best = 0;
    std::string sentence;
    for (const auto& one : known)
    {
        const auto found = one.evidence.find(exercise);
        if (found == one.evidence.end()) continue;
        std::size_t same = 0, all = found->second.size();
        for (const auto& [question, answer] : evidence)
        {
            const auto theirs = found->second.find(question);
            if (theirs == found->second.end())
                ++all;
            else if (sameAnswer(theirs->second, answer))
                ++same;
        }
        const double explained = double(same) / double(all);
        if (same < fewest || explained < share || explained <= best) continue;
        best = explained;
        sentence = "this looks like: " + one.mistake;
    }
    return sentence;
}

std::map<std::string, Evidence> ownCasesEvidence(const Candidate& candidate, int lesson)
{
    std::map<std::string, Evidence> all;
    for (const auto& exercise : exercisesOf(lesson)) try
        {
            Evidence evidence;
            const auto belongs = [&](const char* group) {
                for (const auto& groups : exercise.cases)
                    if ((" + " + groups + " + ").find(fmt::format(" + {} + ", group)) != std::string::npos) return true;
                return false;
            };
            for (const auto& which : cases::ownCases(lesson))
                if (belongs(which.group)) addFailures(evidence, which, inFloat(candidate.tracer));
            if (lesson == 0)
                for (const auto& which : cases::geometryCases())
                    if (belongs(which.group)) addFailures(evidence, which, inFloat(candidate.geometry));
            if (!evidence.empty()) all[exercise.id] = evidence;
        }
        catch (const NotAttempted&)
        {
            // What is not written is not a mistake.
        }
    return all;
}

std::vector<KnownMistake> mistakesFromJson(const std::string& json)
{
    try
    {
        std::vector<KnownMistake> all;
        const auto root = nlohmann::json::parse(json);
        if (root.at("version") != 1) throw std::runtime_error("its version is not 1");
        for (const auto& one : root.at("mistakes"))
            all.push_back({one.at("id"), one.at("mistake"), one.at("evidence").get<std::map<std::string, Evidence>>()});
        return all;
    }
    catch (const std::exception& error)
    {
        throw std::runtime_error(fmt::format("the file of known mistakes cannot be read: {}", error.what()));
    }
}

} // namespace rt::grade
