#include "tests/grade/report/feedback.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tests/grade/report/text.h"

namespace rt::grade
{

bool isFull(const CriterionResult& one)
{
    return one.outcome == Outcome::passed && one.points >= one.most;
}

std::string pointsText(double points)
{
    std::string text = fmt::format("{:.2f}", points == 0 ? 0 : points);
    if (!std::isfinite(points)) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string criterionName(const CriterionResult& one)
{
    return fmt::format("{}: {}{}", cleanLine(one.exercise), cleanLine(one.name), one.hidden ? " (hidden cases)" : "");
}

std::vector<std::string> criterionFeedback(const CriterionResult& one)
{
    std::vector<std::string> lines;
    if (!one.hidden)
    {
        if (one.outcome == Outcome::passed && one.passed == one.cases)
            lines.push_back(fmt::format("All {} cases passed.", one.cases));
        else
            lines.push_back(fmt::format("{} of {} cases passed: {}.", one.passed, one.cases, name(one.outcome)));
        if (one.example)
        {
            lines.push_back("First failing case: " + cleanLine(one.example->what));
            lines.push_back("Expected: " + cleanLine(one.example->expected));
            lines.push_back("Got: " + cleanLine(one.example->got));
            if (one.example->degrees && std::isfinite(*one.example->degrees))
                lines.push_back(fmt::format("Angle between them: {:.3g} degrees", *one.example->degrees));
        }
    }
    if (!one.mistake.empty()) lines.push_back("Likely mistake: " + cleanLine(one.mistake));
    if (!one.hidden && one.pictures)
    {
        const auto& shown = *one.pictures;
        lines.push_back(fmt::format("Worst pixel: {},{} of {}", shown.x, shown.y, cleanLine(shown.title)));
        if (!shown.divergence.empty()) lines.push_back("Ray trees differ: " + cleanLine(shown.divergence));
        if (!shown.command.empty()) lines.push_back("Look at it: " + cleanLine(shown.command));
    }
    return lines;
}

std::string stateSentence(const SubmissionResult& result)
{
    if (result.state == State::graded)
        return fmt::format("Graded: {} of {} points.", pointsText(result.points()), pointsText(result.most()));
    std::string state = name(result.state);
    state[0] = char(state[0] - 'a' + 'A');
    const auto reason = cleanLine(result.reason);
    return reason.empty() ? state + "." : state + ": " + reason;
}

std::vector<ExercisePoints> pointsByExercise(std::span<const CriterionResult> criteria)
{
    std::vector<ExercisePoints> exercises;
    for (const auto& one : criteria)
    {
        auto at = std::find_if(exercises.begin(), exercises.end(),
                               [&](const ExercisePoints& known) { return known.exercise == one.exercise; });
        if (at == exercises.end()) at = exercises.insert(at, {one.exercise});
        at->points += one.points;
        at->most += one.most;
    }
    return exercises;
}

} // namespace rt::grade
