#include "tests/learn/show.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "common/files/picture_file.h"
#include "common/files/scene_text.h"
#include "common/files/text_file.h"
#include "common/program/program.h"
#include "tests/learn/pictures.h"

namespace rt::grade
{

namespace
{

constexpr const char *red = "31", *green = "32", *yellow = "33", *bold = "1";
constexpr std::size_t mostErrors = 3, mostErrorLines = 5, mostPrinted = 5; ///< the last two in lines

std::string paint(const std::string& text, const char* how, const Look& look)
{
    return look.color ? fmt::format("\033[{}m{}\033[0m", how, text) : text;
}

std::string indented(const std::string& text)
{
    std::string result = "  ";
    for (const char c : text) result += c == '\n' ? std::string("\n  ") : std::string(1, c);
    return result;
}

/// The first lines of a text that others made, indented, each shortened to `longest` characters.
std::string linesText(const std::string& from, std::size_t most, std::size_t longest)
{
    std::string text;
    std::size_t lines = 0;
    for (std::size_t at = 0; at < from.size() && lines < most; ++lines)
    {
        const auto end = std::min(from.find('\n', at), from.size());
        text += indented(onOneLine(std::string_view(from).substr(at, end - at), longest)) + "\n";
        at = end + 1;
    }
    return text;
}

/// The triple as one file; its path, and how to ask about its worst pixel.
std::string pictureText(const Exercise& exercise, const PictureTriple& triple, const Look& look)
{
    namespace fs = std::filesystem;
    const fs::path path = projectFile("out/learn/" + exercise.id + ".png");
    fs::create_directories(path.parent_path());
    writeImage(sideBySide(triple, 4), path.string());
    const auto pixel = fmt::format("{} {} --pixel {},{}", exercise.lesson, triple.title, triple.x, triple.y);
    return fmt::format("\n{}expected, got, difference: {}\nthe worst pixel: {}\n",
                       look.pictures ? halfBlocks(triple) : "", shortened(path.string()),
                       isHandout() ? "./raytree exercise " + pixel + " --explain"
                                   : "./raytree view " + pixel + " --compare exercise");
}

std::string errorText(const LessonRun& run, const Look& look)
{
    std::string text = paint("does not compile", red, look);
    if (run.errors.empty()) return text + ": " + run.reason + "\n";
    text += '\n';
    // With the lines that led to it, where it is one of our files that does not compile.
    for (std::size_t i = 0; i < std::min(mostErrors, run.errors.size()); ++i)
        text += linesText(run.errors[i], mostErrorLines, 500);
    if (run.errors.size() > mostErrors) text += fmt::format("  and {} more\n", run.errors.size() - mostErrors);
    return text;
}

/// What the student's code printed, its first lines.
std::string printedText(const std::string& printed)
{
    const auto text = linesText(printed, mostPrinted, 200);
    return text.empty() ? "" : "\nyour code printed:\n" + text;
}

/// "wrong: 2 of 5 cases are right"; of a single case there is nothing to count.
std::string verdict(const Attempt& attempt)
{
    if (attempt.cases == 1) return std::string(name(attempt.outcome)) + "\n";
    return fmt::format("{}: {} of {} cases {} right\n", name(attempt.outcome), attempt.passed, attempt.cases,
                       attempt.passed == 1 ? "is" : "are");
}

std::string attemptText(const Session& session, const Exercise& exercise, const LessonRun& run, const Look& look)
{
    const auto& attempt = run.attempts.at(exercise.id);
    if (attempt.outcome == Outcome::passed)
        return paint(fmt::format("right: all {} cases\n", attempt.cases), green, look);
    if (attempt.outcome == Outcome::notRun) return paint("could not be tried\n", red, look);
    if (attempt.outcome == Outcome::notAttempted)
    {
        if (attempt.missing == exercise.id || !session.find(attempt.missing))
            return paint("not attempted yet\n", yellow, look);
        return paint(fmt::format("waits for {}: its cases need both\n", attempt.missing), yellow, look);
    }
    std::string text = paint(verdict(attempt), red, look);
    const auto& example = attempt.example;
    text += fmt::format("  {}\n  Slide: {}\n", attempt.name, attempt.slide);
    text += indented(fmt::format("{}\nexpected {}\ngot      {}\n", onOneLine(example.what, 500),
                                 onOneLine(example.expected, 500), onOneLine(example.got, 500)));
    text.resize(text.find_last_not_of(' ') + 1);
    if (!attempt.mistake.empty()) text += "  " + paint("this looks like: " + attempt.mistake, bold, look) + "\n";
    for (const auto& before : session.lesson(exercise.lesson))
    {
        if (before.id == exercise.id) break;
        if (const auto found = run.attempts.find(before.id);
            found != run.attempts.end() && found->second.outcome == Outcome::wrong)
            text += fmt::format("  {} is wrong too, and this may follow from it: mend it first\n", before.id);
    }
    return text;
}

} // namespace

std::string progressLine(const Session& session)
{
    double points = 0, most = 0;
    int right = 0;
    for (const auto& exercise : session.exercises)
    {
        const bool is = session.progress.of(exercise.id) == Standing::right;
        right += is;
        points += is ? exercise.points : 0;
        most += exercise.points;
    }
    const auto filled = std::size_t(30 * points / most);
    return fmt::format("[{}{}] {:g} of {:g} points, {} of {} exercises\n", std::string(filled, '#'),
                       std::string(30 - filled, '.'), points, most, right, session.exercises.size());
}

std::string progressList(const Session& session, const Look& look)
{
    std::string text = progressLine(session);
    for (const auto& exercise : session.exercises)
    {
        const auto standing = session.progress.of(exercise.id);
        const auto words = standing == Standing::right   ? paint("right        ", green, look)
                           : standing == Standing::wrong ? paint("wrong        ", red, look)
                                                         : "not attempted";
        text += fmt::format("{} {}  {:<14} {:g}  {}\n", exercise.id == session.current().id ? '>' : ' ', words,
                            exercise.id, exercise.points, exercise.title);
    }
    return text;
}

std::string exerciseText(const Session& session, const Exercise& exercise, const Look& look)
{
    const auto file = session.fileOf(exercise.lesson);
    const bool exists = std::filesystem::exists(file); // an editor may be about to write it
    const int line = exists ? todoLine(readTextFile(file), exercise.id) : 0;
    return fmt::format("{} ({:g} {})\nSlide: {}\n{}\n", paint(exercise.id + ", " + exercise.title, bold, look),
                       exercise.points, exercise.points == 1 ? "point" : "points", exercise.slide,
                       line ? fmt::format("{}:{}: the TODO", shortened(file), line) : shortened(file));
}

std::string nextText(const Session& session, const Exercise& exercise)
{
    const auto* next = session.nextToDo(exercise.id);
    return next ? fmt::format("next: {}, {}\n", next->id, next->title) : "all exercises are right: well done\n";
}

std::string resultText(const Session& session, const Exercise& exercise, const LessonRun& run, const Look& look)
{
    if (!run.compiled) return errorText(run, look);
    const auto found = run.attempts.find(exercise.id);
    if (found == run.attempts.end()) return "";
    const auto& attempt = found->second;
    std::string text = attemptText(session, exercise, run, look);
    if (attempt.pictures) text += pictureText(exercise, *attempt.pictures, look);
    for (const auto& remark : run.remarks) text += onOneLine(remark, 200) + "\n";
    return text + printedText(run.text);
}

} // namespace rt::grade
