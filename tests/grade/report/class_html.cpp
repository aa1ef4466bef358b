#include "tests/grade/report/class_html.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "tests/grade/report/feedback.h"
#include "tests/grade/report/page.h"
#include "tests/grade/report/statistics.h"

namespace rt::grade
{

namespace
{

std::string students(std::size_t count)
{
    return fmt::format("{} student{}", count, count == 1 ? "" : "s");
}

std::string header(std::span<const SubmissionResult> results, double most)
{
    std::map<State, int> states;
    double sum = 0;
    std::size_t unsafe = 0;
    for (const auto& result : results)
    {
        ++states[result.state];
        sum += result.points();
        unsafe += result.sandbox == "none" ? 1 : 0;
    }
    std::string counts;
    for (const auto& [state, count] : states)
        counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, name(state));
    std::string text =
        fmt::format("<header class=\"card\">\n<p class=\"eyebrow\">raytree &middot; for the instructor</p>\n"
                    "<h1>{}</h1>\n",
                    results.empty() ? "No submissions" : lessonHtml(results[0].lesson));
    if (!results.empty())
    {
        const double mean = sum / double(results.size());
        text +=
            fmt::format("<p class=\"score\"><b>{}</b> of {} points on average <span class=\"dim\">{}</span></p>\n{}\n"
                        "<p>{}: {}.</p>\n",
                        pointsText(mean), pointsText(most), percentText(mean, most), bar(most > 0 ? mean / most : 0),
                        students(results.size()), counts);
    }
    text += "</header>\n";
    if (unsafe > 0)
        text += fmt::format("<p class=\"card warn\"><strong>Graded without a sandbox:</strong> {}.</p>\n",
                            students(unsafe));
    return text;
}

std::string histogramHtml(std::span<const SubmissionResult> results, double most)
{
    const auto bins = histogram(results, most);
    const int highest = std::max(1, *std::max_element(bins.begin(), bins.end()));
    std::string text =
        "<section class=\"card\">\n<h2>How the points are spread</h2>\n<p class=\"dim\">Graded submissions by "
        "their share of the points, in percent.</p>\n<ul class=\"histogram\">\n";
    for (std::size_t i = 0; i < bins.size(); ++i)
    {
        const double height = 100.0 * bins[i] / highest;
        text +=
            fmt::format("<li><svg viewBox=\"0 0 10 100\" preserveAspectRatio=\"none\" aria-hidden=\"true\"><rect "
                        "class=\"track\" width=\"10\" height=\"100\"/><rect class=\"fill\" y=\"{:.1f}\" width=\"10\" "
                        "height=\"{:.1f}\"/></svg>{}<span>{}<i>&ndash;{} %</i></span></li>\n",
                        100 - height, height, bins[i], 10 * i, 10 * (i + 1));
    }
    return text + "</ul>\n</section>\n";
}

std::string outcomesText(const std::map<Outcome, int>& outcomes)
{
    std::string text;
    for (const auto& [outcome, count] : outcomes)
        if (outcome != Outcome::passed) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name(outcome));
    return text;
}

std::string difficulty(std::span<const SubmissionResult> results)
{
    const auto all = classStatistics(results);
    if (all.empty()) return "";
    std::string text =
        "<section class=\"card\">\n<h2>How hard it was</h2>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"classes of cases\">\n<table class=\"wide\">\n<caption>The hardest first: how many earned "
        "all points of a class of cases, and the mean of the points.</caption>\n<thead><tr><th scope=\"col\" "
        "class=\"w\">class of cases</th><th scope=\"col\" class=\"graph\"><span></span></th><th scope=\"col\" "
        "class=\"n\">full "
        "marks</th><th scope=\"col\" class=\"n\">mean</th><th scope=\"col\">how the others failed</th></tr></thead>\n"
        "<tbody>\n";
    for (const auto& one : all)
        text += fmt::format(
            "<tr><th scope=\"row\">{}{}<small>{}</small></th><td class=\"graph\">{}</td><td class=\"n\">{} of "
            "{}</td><td class=\"n\">{:.0f} %</td><td>{}</td></tr>\n",
            html(one.name), one.hidden ? " <span class=\"badge\">hidden</span>" : "", html(one.exercise),
            bar(double(one.full) / one.students), one.full, one.students, 100 * one.share, outcomesText(one.outcomes));
    return text + "</tbody>\n</table>\n</div>\n</section>\n";
}

std::string mistakes(std::span<const SubmissionResult> results)
{
    const auto all = commonMistakes(results);
    if (all.empty()) return "";
    std::string text =
        "<section class=\"card\">\n<h2>Common mistakes</h2>\n<table>\n<thead><tr><th scope=\"col\">looks like"
        "</th><th scope=\"col\" class=\"n\">students</th></tr></thead>\n<tbody>\n";
    for (const auto& one : all)
        text += fmt::format("<tr><th scope=\"row\">{}<small>{}</small></th><td class=\"n\">{}</td></tr>\n",
                            html(one.mistake), html(one.exercise), one.students);
    return text + "</tbody>\n</table>\n</section>\n";
}

std::string link(const std::function<std::string(const std::string&)>& address, const std::string& student,
                 const std::string& text)
{
    const std::string target = address ? address(student) : "";
    return target.empty() ? text : fmt::format("<a href=\"{}\">{}</a>", html(target), text);
}

std::string studentTable(std::span<const SubmissionResult> results, double most, const PageLinks& links)
{
    if (results.empty()) return "";
    std::string text =
        "<section class=\"card\">\n<h2>Students</h2>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"students\">\n<table class=\"wide\">\n<thead><tr><th scope=\"col\" class=\"w\">student</th>"
        "<th scope=\"col\">state</th><th scope=\"col\" class=\"graph\"><span></span></th><th scope=\"col\" "
        "class=\"n\">points</th><th scope=\"col\" class=\"n\">of</th><th scope=\"col\">remarks</th></tr></thead>\n"
        "<tbody>\n";
    for (const auto& result : results)
    {
        const bool graded = result.state == State::graded;
        const std::string more = link(links.instructor, result.student, "for the instructor");
        text += fmt::format(
            "<tr><th scope=\"row\">{}{}</th><td class=\"state {}\">{}</td><td class=\"graph\">{}</td><td class=\"n\">{}"
            "</td><td class=\"n\">{}</td><td>",
            link(links.student, result.student, html(result.student)),
            more.front() == '<' ? "<small>" + more + "</small>" : "", graded ? "" : "bad", name(result.state),
            bar(most > 0 ? result.points() / most : 0), pointsText(result.points()), pointsText(most));
        std::string all = html(graded ? "" : result.reason);
        for (const auto& remark : result.remarks) all += (all.empty() ? "" : "<br>") + html(remark);
        text += all + "</td></tr>\n";
    }
    return text + "</tbody>\n</table>\n</div>\n</section>\n";
}

} // namespace

std::string classHtml(std::span<const SubmissionResult> results, const PageLinks& links)
{
    const double most = mostOf(results);
    const auto title = results.empty()
                           ? std::string("No submissions - raytree")
                           : fmt::format("Lesson {:02}, {} - raytree", results[0].lesson, students(results.size()));
    return page(title, header(results, most) + histogramHtml(results, most) + difficulty(results) + mistakes(results) +
                           studentTable(results, most, links));
}

} // namespace rt::grade
