#include "tests/grade/report/gradebook_csv.h"

#include <algorithm>

#include <fmt/format.h>

#include "tests/grade/report/feedback.h"
#include "tests/grade/report/statistics.h"
#include "tests/grade/report/text.h"

namespace rt::grade
{

namespace
{

/// Signs that start a formula, the full-width ones too; some programs skip spaces before them.
bool looksLikeFormula(const std::string& text)
{
    const auto start = text.find_first_not_of(' ');
    if (start == text.npos) return false;
    for (const std::string sign : {"=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20"})
        if (text.compare(start, sign.size(), sign) == 0) return true;
    // Cleaned text has no control characters: a tab or a line end has become a space.
    return false;
}

std::string cell(std::string_view foreign)
{
    std::string text = cleanLine(foreign);
    if (looksLikeFormula(text)) text = "'" + text;
    if (text.find_first_of(",;\"\n ") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string joined(const std::vector<std::string>& parts, const char* between)
{
    std::string text;
    for (const auto& part : parts) text += (text.empty() ? "" : between) + cleanLine(part);
    return text;
}

} // namespace

std::string gradebookCsv(std::span<const SubmissionResult> results)
{
    const auto exercises = exercisesOf(results);
    const double most = mostOf(results);
    std::string text = "student,lesson,state,points,most,percent";
    for (const auto& exercise : exercises) text += "," + cell(exercise);
    text += ",sandbox,remarks\r\n";
    for (const auto& result : results)
    {
        const double points = result.points();
        text += fmt::format("{},{},{},{},{},{}", cell(result.student), result.lesson, cell(name(result.state)),
                            pointsText(points), pointsText(most),
                            most > 0 ? fmt::format("{:.1f}", 100 * points / most) : "0");
        const auto own = pointsByExercise(result.criteria);
        for (const auto& exercise : exercises)
        {
            const auto at =
                std::find_if(own.begin(), own.end(), [&](const auto& one) { return one.exercise == exercise; });
            text += "," + pointsText(at == own.end() ? 0 : at->points);
        }
        auto remarks = result.remarks;
        if (!result.reason.empty()) remarks.insert(remarks.begin(), result.reason);
        text += fmt::format(",{},{}\r\n", cell(result.sandbox), cell(joined(remarks, " ")));
    }
    return text;
}

} // namespace rt::grade
