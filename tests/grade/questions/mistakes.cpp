// Comparing wrong answers with those of known mistakes. Nothing here needs a lesson or a mutant.
#include "tests/grade/questions/mistakes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/base/todo.h"
#include "tests/cases/cases.h"
#include "tests/grade/questions/in_float.h"
#include "tests/grade/questions/manifest.h"

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
            const bool near =
                std::isfinite(x) && std::isfinite(y) && std::abs(x - y) <= 1e-5 * std::max(1.0, std::abs(x));
            if (!equal && !near) return false;
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
    // A case of random lines fails on hundreds; the first tell mistakes apart as well as all (of 179 none is named otherwise).
    const auto count = std::min(check.failures.size(), std::size_t(16));
    for (std::size_t i = 0; i < count; ++i) evidence[key(i)] = check.failures[i].what + ": " + check.failures[i].got;
    if (!ended.empty()) evidence[key(count)] = ended;
}

/// Has a number that nobody meets by chance: 0.0406728807, and not 1 or 0.25.
bool isUnusual(const std::string& answer)
{
    int digits = 0;
    for (const char c : answer.substr(answer.rfind(": ") + 1)) // after the question
    {
        const bool isDigit = c >= '0' && c <= '9';
        digits = isDigit && (c != '0' || digits > 0) ? digits + 1 : isDigit || c == '.' ? digits : 0;
        if (digits >= 5 && c != '0') return true;
    }
    return false;
}

/// Which share of the questions that the student or the mutant answers wrongly do both answer alike; 0 if those are too few.
double explained(const Evidence& student, const Evidence& mutant)
{
    constexpr std::size_t fewest = 3; // fewer may have many reasons, unless they share an unusual number
    std::size_t same = 0, all = mutant.size();
    bool unusual = false;
    for (const auto& [question, answer] : student)
    {
        const auto theirs = mutant.find(question);
        if (theirs == mutant.end())
            ++all;
        else if (sameAnswer(theirs->second, answer))
        {
            ++same;
            unusual = unusual || isUnusual(answer);
        }
    }
    return same >= fewest || unusual ? double(same) / double(all) : 0;
}

bool belongs(const Exercise& exercise, const char* group)
{
    return std::any_of(exercise.cases.begin(), exercise.cases.end(), [&](const auto& groups) {
        return (" + " + groups + " + ").find(fmt::format(" + {} + ", group)) != std::string::npos;
    });
}

} // namespace

std::map<std::string, std::string> likelyMistakes(const WrongAnswers& wrong, const std::vector<KnownMistake>& known)
{
    constexpr double enough = 0.95;
    std::map<std::string, std::pair<double, int>> best;
    std::map<std::string, std::string> sentences;
    for (const auto& one : known)
    {
        // Where the mutant fails, so must the student, or the mistake is another one.
        const bool possible = std::all_of(one.evidence.begin(), one.evidence.end(), [&](const auto& theirs) {
            return wrong.evidence.contains(theirs.first) || wrong.unfinished.contains(theirs.first);
        });
        if (!possible) continue;
        std::map<std::string, double> shares;
        for (const auto& [exercise, evidence] : wrong.evidence)
        {
            const auto theirs = one.evidence.find(exercise);
            if (theirs == one.evidence.end() || wrong.unfinished.contains(exercise)) continue;
            if (const double share = explained(evidence, theirs->second); share >= enough) shares[exercise] = share;
        }
        // Of two that explain an exercise alike, the one that explains more of the others.
        for (const auto& [exercise, share] : shares)
            if (const std::pair rank(share, int(shares.size())); rank > best[exercise])
            {
                best[exercise] = rank;
                sentences[exercise] = one.mistake;
            }
    }
    return sentences;
}

WrongAnswers ownCasesAnswers(const Candidate& candidate, int lesson)
{
    WrongAnswers wrong;
    for (const auto& exercise : exercisesOf(lesson)) try
        {
            Evidence evidence;
            for (const auto& which : cases::ownCases(lesson))
                if (belongs(exercise, which.group)) addFailures(evidence, which, inFloat(candidate.tracer));
            if (lesson == 0)
                for (const auto& which : cases::geometryCases())
                    if (belongs(exercise, which.group)) addFailures(evidence, which, inFloat(candidate.geometry));
            if (!evidence.empty()) wrong.evidence[exercise.id] = evidence;
        }
        catch (const NotAttempted&)
        {
            wrong.unfinished.insert(exercise.id);
        }
    return wrong;
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
