#include "tests/grade/report/report_html.h"

#include <cmath>

#include <fmt/format.h>

#include "tests/grade/report/exercises.h"
#include "tests/grade/report/feedback.h"
#include "tests/grade/report/page.h"

namespace rt::grade
{

namespace
{

enum class Reader
{
    student,
    instructor
};

std::string pointsCells(double points, double most)
{
    return fmt::format("<td class=\"n\">{}</td><td class=\"n\">{}</td>", pointsText(points), pointsText(most));
}

std::string header(const SubmissionResult& result, Reader reader)
{
    std::string text = fmt::format(
        "<header class=\"card{}\">\n<p class=\"eyebrow\">raytree &middot; {}{}</p>\n<h1>{}</h1>\n",
        reader == Reader::instructor ? " warn" : "", lessonHtml(result.lesson),
        reader == Reader::instructor ? " &middot; <strong>for the instructor only</strong>" : "", html(result.student));
    if (result.state != State::graded)
        return text + fmt::format("<p class=\"score bad\">{}</p>\n</header>\n", html(stateSentence(result)));
    const double points = result.points(), most = result.most();
    return text +
           fmt::format("<p class=\"score\"><b>{}</b> of {} points <span class=\"dim\">{}</span></p>\n{}\n</header>\n",
                       pointsText(points), pointsText(most), percentText(points, most),
                       bar(most > 0 ? points / most : 0));
}

std::string unsafeNote(const SubmissionResult& result)
{
    if (result.sandbox != "none") return "";
    return "<p class=\"card warn\"><strong>Graded without a sandbox.</strong> Nothing kept this program from the rest "
           "of "
           "the machine.</p>\n";
}

std::string pointsTable(const SubmissionResult& result)
{
    if (result.criteria.empty()) return "";
    std::string text = "<section class=\"card\">\n<h2>Points</h2>\n<table>\n<thead><tr><th scope=\"col\">exercise</th>"
                       "<th scope=\"col\" class=\"graph\"><span></span></th><th scope=\"col\" class=\"n\">points</th>"
                       "<th scope=\"col\" class=\"n\">of</th></tr></thead>\n<tbody>\n";
    for (const auto& one : pointsByExercise(result.criteria))
    {
        const auto* facts = findExercise(one.exercise);
        text += fmt::format("<tr><th scope=\"row\">{}{}</th><td class=\"graph\">{}</td>{}</tr>\n",
                            html(facts ? facts->title : one.exercise),
                            facts ? "<small>" + html(one.exercise) + "</small>" : "",
                            bar(one.most > 0 ? one.points / one.most : 0), pointsCells(one.points, one.most));
    }
    return text + fmt::format("</tbody>\n<tfoot><tr><th scope=\"row\">together</th><td></td>{}</tr></tfoot>\n</table>\n"
                              "</section>\n",
                              pointsCells(result.points(), result.most()));
}

std::string row(const char* term, const std::string& text)
{
    return fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, html(text));
}

std::string pictureFeedback(const PictureTriple& all)
{
    std::string text = figures(all);
    text += fmt::format("<p>{}: the worst pixel is {}, {}{}</p>\n", html(all.title), all.x, all.y,
                        text.empty() ? "." : ", in the rings.");
    if (!all.divergence.empty()) text += fmt::format("<p>There the ray trees differ: {}</p>\n", html(all.divergence));
    if (!all.command.empty())
        text += "<p class=\"dim\">Look at both trees in the viewer:</p>\n" +
                htmlBlock(all.command, "command that opens the viewer", "command");
    return text;
}

std::string failing(const CriterionResult& one, Reader reader)
{
    const auto* facts = findExercise(one.exercise);
    std::string where = html(one.exercise);
    if (facts)
        where +=
            " &middot; " + html(facts->title) + (facts->slide.empty() ? "" : " &middot; slide: " + html(facts->slide));
    std::string text =
        fmt::format("<article class=\"class\">\n<div><h3><span>{}</span> <span class=\"badge{}\">{}</span></h3>\n"
                    "<p class=\"eyebrow\">{}</p></div>\n",
                    html(one.name), one.hidden ? "" : " bad", one.hidden ? "hidden cases" : name(one.outcome), where);
    if (!one.hidden || reader == Reader::instructor)
        text += fmt::format("<p>{} of {} cases passed{}, {} of {} points.</p>\n", one.passed, one.cases,
                            one.hidden ? std::string(": ") + name(one.outcome) : "", pointsText(one.points),
                            pointsText(one.most));
    else
        text += fmt::format("<p>{} of {} points. These cases stay secret.</p>\n", pointsText(one.points),
                            pointsText(one.most));
    if (!one.hidden && one.example)
    {
        text += "<dl class=\"case\">\n" + row("first failing case", one.example->what) +
                row("expected", one.example->expected) + row("got", one.example->got);
        if (one.example->degrees && std::isfinite(*one.example->degrees))
            text += row("angle between", fmt::format("{:.3g} degrees", *one.example->degrees));
        text += "</dl>\n";
    }
    if (!one.mistake.empty())
        text += fmt::format("<p class=\"note\"><strong>Likely mistake:</strong> {}</p>\n", html(one.mistake));
    if (!one.hidden && one.pictures) text += pictureFeedback(*one.pictures);
    return text + "</article>\n";
}

std::string whatWentWrong(const SubmissionResult& result, Reader reader)
{
    std::string text;
    for (const auto& one : result.criteria)
        if (!isFull(one)) text += failing(one, reader);
    if (text.empty()) return "";
    return "<section class=\"card\">\n<h2>What to look at</h2>\n" + text + "</section>\n";
}

std::string classTable(const SubmissionResult& result, Reader reader)
{
    if (result.criteria.empty()) return "";
    std::string text =
        "<section class=\"card\">\n<h2>All cases</h2>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"all cases\">\n<table>\n<thead><tr><th scope=\"col\">class of cases</th><th scope=\"col\">"
        "how it went</th><th scope=\"col\" class=\"n\">points</th><th scope=\"col\" class=\"n\">of</th></tr>"
        "</thead>\n<tbody>\n";
    for (const auto& one : result.criteria)
    {
        const bool full = isFull(one), told = !one.hidden || reader == Reader::instructor;
        const std::string how = told
                                    ? fmt::format("{}<small>{} of {}</small>", name(one.outcome), one.passed, one.cases)
                                    : std::string("hidden cases");
        text += fmt::format("<tr><th scope=\"row\">{}{}<small>{}</small></th><td class=\"{}\">{}</td>{}</tr>\n",
                            html(one.name), one.hidden && told ? " <span class=\"badge\">hidden</span>" : "",
                            html(one.exercise),
                            !told  ? "dim"
                            : full ? "good"
                                   : "bad",
                            how, pointsCells(one.points, one.most));
    }
    return text + "</tbody>\n</table>\n</div>\n</section>\n";
}

std::string compilerMessages(const SubmissionResult& result)
{
    if (result.compilerErrors.empty()) return "";
    std::string text = "<section class=\"card\">\n<h2>What the compiler says</h2>\n";
    for (std::size_t i = 0; i < result.compilerErrors.size(); ++i)
        text += htmlBlock(result.compilerErrors[i], fmt::format("compiler message {}", i + 1));
    return text + "</section>\n";
}

std::string remarks(const SubmissionResult& result)
{
    if (result.remarks.empty()) return "";
    std::string text = "<section class=\"card\">\n<h2>Remarks</h2>\n<ul>\n";
    for (const auto& remark : result.remarks) text += "<li>" + html(remark) + "</li>\n";
    return text + "</ul>\n</section>\n";
}

std::string footer()
{
    return "<footer>A class of cases earns its points in full or not at all; cases of pictures earn them in proportion "
           "once "
           "most pixels are right. Where two runs differed, the worse one counts.</footer>\n";
}

std::string instructorFacts(const SubmissionResult& result)
{
    return "<section class=\"card\">\n<h2>How it was graded</h2>\n<dl class=\"case\">\n" +
           row("sandbox", result.sandbox) +
           row("seconds", fmt::format("{:.2f} in all, {:.2f} of processor time to compile", result.seconds,
                                      result.compileSeconds)) +
           row("submission", result.key) + row("grader", result.grader) + "</dl>\n</section>\n";
}

std::string studentText(const SubmissionResult& result)
{
    return "<section class=\"card\">\n<h2>What the program printed</h2>\n" +
           (result.studentText.empty() ? std::string("<p class=\"dim\">Nothing.</p>\n")
                                       : htmlBlock(result.studentText, "what the program printed")) +
           "</section>\n";
}

std::string sections(const SubmissionResult& result, Reader reader)
{
    return header(result, reader) + unsafeNote(result) + compilerMessages(result) + pointsTable(result) +
           remarks(result) + whatWentWrong(result, reader) + classTable(result, reader);
}

} // namespace

std::string reportHtml(const SubmissionResult& result)
{
    return page(fmt::format("{} - lesson {:02} - raytree", result.student, result.lesson),
                sections(result, Reader::student) + footer());
}

std::string instructorHtml(const SubmissionResult& result)
{
    return page(fmt::format("For the instructor: {} - lesson {:02} - raytree", result.student, result.lesson),
                sections(result, Reader::instructor) + studentText(result) + instructorFacts(result));
}

} // namespace rt::grade
