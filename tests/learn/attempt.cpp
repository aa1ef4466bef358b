#include "tests/learn/attempt.h"

#include <algorithm>
#include <cctype>

#include "common/base/todo.h"
#include "common/scene/camera.h"
#include "tests/cases/cases.h"
#include "tests/cases/lesson00_cases.h"
#include "tests/grade/questions/in_float.h"
#include "tests/learn/pictures.h"

namespace rt::grade
{

namespace
{

/// Cases in the order of their kinds: a known value says more than a picture.
template <class OneCase>
std::vector<OneCase> casesOf(const std::vector<OneCase>& all, const Exercise& exercise)
{
    std::vector<OneCase> some;
    for (const auto& one : all)
        for (const auto& groups : exercise.cases) // "Cutoff + Tint" are worth points together
            if ((" + " + groups + " + ").find(std::string(" + ") + one.group + " + ") != std::string::npos)
                some.push_back(one);
    std::stable_sort(some.begin(), some.end(), [](const auto& a, const auto& b) { return a.kind < b.kind; });
    return some;
}

/// Remembers the last picture, and throws NotAttempted where one is magenta for that reason.
cases::Subject watched(const cases::Subject& subject, Seen& seen)
{
    cases::Subject result = subject;
    if (subject.picture)
        result.picture = [&seen, picture = subject.picture, color = subject.color](const SceneDescription& scene) {
            seen = {scene, picture(scene)};
            const auto at = std::find(seen.picture.pixels.begin(), seen.picture.pixels.end(), magenta);
            if (at != seen.picture.pixels.end())
            {
                const auto i = int(at - seen.picture.pixels.begin());
                const auto ray =
                    Camera<double>(scene.camera).ray(i % seen.picture.width + 0.5, i / seen.picture.width + 0.5);
                color(scene, ray.O, ray.D);
            }
            return seen.picture;
        };
    return result;
}

template <class OneCase, class Subject>
void judge(Attempt& attempt, const OneCase& which, const Subject& subject, const Seen& seen)
{
    const auto fail = [&](Outcome outcome, const Example& example) {
        if (attempt.outcome != Outcome::passed) return;
        attempt.outcome = outcome;
        attempt.name = caseName(which.group, which.name);
        attempt.slide = which.slide;
        attempt.example = example;
    };
    ++attempt.cases;
    cases::Check check;
    try
    {
        which.run(check, subject);
    }
    catch (const NotAttempted& todo)
    {
        if (attempt.missing.empty()) attempt.missing = todo.id;
        return;
    }
    catch (const Died& died)
    {
        fail(died.outcome, {"the case ran", "to its end", died.what(), std::nullopt});
        return;
    }
    catch (const GraderError& error)
    {
        throw std::runtime_error(error.what());
    }
    catch (const std::exception& error)
    {
        check.failures.push_back({"the case ran", "to its end", error.what()});
    }
    if (check.failures.empty() && check.checked > 0)
    {
        ++attempt.passed;
        return;
    }
    const auto first =
        check.failures.empty() ? cases::Failure{"the case checks something", "true", "false"} : check.failures.front();
    fail(Outcome::wrong, {first.what, first.expected, first.got, std::nullopt});
    if (which.kind == cases::Kind::picture && !attempt.pictures) attempt.pictures = triple(first.what, seen);
}

/// The cases, until one ends the process: each endless loop costs seconds, and one is enough to know.
template <class OneCase, class Subject>
Attempt runAll(const std::vector<OneCase>& cases, const Subject& subject, const Seen& seen)
{
    Attempt attempt;
    attempt.outcome = Outcome::passed;
    for (const auto& which : cases)
    {
        judge(attempt, which, subject, seen);
        if (attempt.outcome > Outcome::notDeterministic) break;
    }
    if (attempt.outcome == Outcome::passed && !attempt.missing.empty()) attempt.outcome = Outcome::notAttempted;
    if (attempt.cases == 0) attempt.outcome = Outcome::notRun;
    return attempt;
}

/// The lesson's stored pictures belong to no single exercise. Every wrong one is shown the first picture that differs. If all
/// cases are right and a picture still differs, the exercise at hand is wrong.
void addPictures(std::map<std::string, Attempt>& attempts, const std::string& id, const std::vector<cases::Case>& own,
                 const cases::Subject& tracer, const Seen& seen)
{
    bool allPassed = true, wrong = false;
    for (const auto& [other, attempt] : attempts)
    {
        allPassed = allPassed && attempt.outcome == Outcome::passed;
        wrong = wrong || attempt.outcome == Outcome::wrong;
    }
    if (!wrong && !allPassed) return;
    std::vector<cases::Case> pictures;
    for (const auto& one : own)
        if (one.kind == cases::Kind::picture) pictures.push_back(one);
    auto result = runAll(pictures, tracer, seen);
    if (result.outcome == Outcome::passed || result.outcome == Outcome::notRun) return;
    for (auto& [other, attempt] : attempts)
        if (attempt.outcome == Outcome::wrong) attempt.pictures = result.pictures;
    if (!allPassed) return;
    auto& at = attempts.at(id);
    result.passed += at.passed;
    result.cases += at.cases;
    at = result;
}

} // namespace

std::map<std::string, Attempt> runCases(const Candidate& candidate, const std::vector<Exercise>& exercises,
                                        const std::string& first)
{
    Seen seen;
    const auto tracer = watched(inFloat(candidate.tracer), seen);
    const auto numbers = inFloat(candidate.geometry);
    const int lesson = exercises.empty() ? -1 : exercises.front().lesson;
    const auto geometry = lesson == 0 ? cases::geometryCases() : std::vector<cases::GeometryCase>();
    const auto own = cases::ownCases(lesson);

    auto order = exercises;
    std::stable_partition(order.begin(), order.end(), [&](const auto& exercise) { return exercise.id == first; });
    std::map<std::string, Attempt> attempts;
    bool died = false;
    for (const auto& exercise : order)
    {
        auto& attempt = attempts[exercise.id];
        if (died) continue;
        attempt = lesson == 0 ? runAll(casesOf(geometry, exercise), numbers, seen)
                              : runAll(casesOf(own, exercise), tracer, seen);
        died = attempt.outcome > Outcome::notDeterministic;
    }
    if (!died && !order.empty()) addPictures(attempts, order.front().id, own, tracer, seen);
    return attempts;
}

std::string caseName(const std::string& group, const std::string& name)
{
    std::string words = group + ": ";
    bool inNumber = false;
    for (const char c : name)
    {
        const bool digit = std::isdigit(static_cast<unsigned char>(c));
        if (words.back() != ' ' && (std::isupper(static_cast<unsigned char>(c)) || (digit && !inNumber))) words += ' ';
        words += char(std::tolower(static_cast<unsigned char>(c)));
        inNumber = digit;
    }
    return words;
}

} // namespace rt::grade
