#include "tests/learn/session.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "common/files/text_file.h"
#include "common/program/program.h"
#include "tests/grade/box/compile.h"
#include "tests/grade/box/temporary_folder.h"
#include "tests/grade/questions/mistakes.h"
#include "tests/grade/wire/remote.h"

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

/// What known mistakes answer; none if the file is not there.
std::vector<KnownMistake> storedMistakes(int lesson)
{
    const auto path = projectFile(fmt::format("tests/grade/mistakes/{:02}.json", lesson));
    return fs::exists(path) ? mistakesFromJson(readTextFile(path)) : std::vector<KnownMistake>{};
}

void nameMistakes(std::map<std::string, Attempt>& attempts, const Candidate& candidate, int lesson)
{
    const bool wrong = std::any_of(attempts.begin(), attempts.end(),
                                   [](const auto& one) { return one.second.outcome == Outcome::wrong; });
    const auto known = wrong ? storedMistakes(lesson) : std::vector<KnownMistake>{};
    if (known.empty()) return;
    try
    {
        for (const auto& [id, mistake] : likelyMistakes(ownCasesAnswers(candidate, lesson), known))
            if (attempts[id].outcome == Outcome::wrong) attempts[id].mistake = mistake;
    }
    catch (const GraderError& error)
    {
        throw std::runtime_error(error.what());
    }
}

} // namespace

const Exercise& Session::current() const
{
    if (const auto* exercise = find(progress.current)) return *exercise;
    return exercises.front();
}

const Exercise* Session::find(const std::string& id) const
{
    for (const auto& exercise : exercises)
        if (exercise.id == id) return &exercise;
    return nullptr;
}

const Exercise* Session::neighbour(const std::string& id, int step) const
{
    const auto* exercise = find(id);
    const auto place = exercise ? exercise - exercises.data() + step : 0;
    return place >= 0 && place < std::ptrdiff_t(exercises.size()) ? &exercises[std::size_t(place)] : nullptr;
}

const Exercise* Session::nextToDo(const std::string& id) const
{
    const auto* exercise = find(id);
    const auto start = exercise ? std::size_t(exercise - exercises.data()) + 1 : 0;
    for (std::size_t i = 0; i < exercises.size(); ++i)
        if (const auto& one = exercises[(start + i) % exercises.size()]; progress.of(one.id) != Standing::right)
            return &one;
    return nullptr;
}

std::vector<Exercise> Session::lesson(int number) const
{
    std::vector<Exercise> some;
    for (const auto& exercise : exercises)
        if (exercise.lesson == number) some.push_back(exercise);
    return some;
}

std::string Session::fileOf(int lesson) const
{
    if (!file.empty()) return file;
    const auto start = fmt::format("{:02}_", lesson);
    for (const auto& entry : fs::directory_iterator(projectFile("lessons")))
        if (entry.path().filename().string().starts_with(start)) return (entry.path() / "exercise.h").string();
    throw std::runtime_error(fmt::format("there is no folder lessons/{}...", start));
}

Session openSession(const std::string& stateFile, std::string& notice)
{
    Session session;
    for (const int lesson : exerciseLessons())
        for (const auto& exercise : exercisesOf(lesson)) session.exercises.push_back(exercise);
    session.stateFile = stateFile;
    session.progress = loadProgress(stateFile, notice);
    if (!session.find(session.progress.current))
    {
        const auto* next = session.nextToDo("");
        session.progress.current = (next ? *next : session.exercises.back()).id;
    }
    return session;
}

LessonRun runLesson(const Session& session, int lesson, const std::string& first)
{
    const std::string text = readTextFile(session.fileOf(lesson));
    const Box box{Sandbox::none, 0};
    const TemporaryFolder folder;
    const auto compiled = compileSubmission(box, lesson, text, folder.path, Fill::pattern, Kit::whole);
    LessonRun run{compiled.ok, compiled.reason, compiled.errors, compiled.remarks, {}, ""};
    if (!compiled.ok) return run;
    Remote remote(box, compiled.program, lesson, Limits());
    const auto candidate = remote.candidate();
    run.attempts = runCases(candidate, session.lesson(lesson), first);
    nameMistakes(run.attempts, candidate, lesson);
    run.text = remote.text();
    return run;
}

void note(Session& session, const LessonRun& run)
{
    for (const auto& [id, attempt] : run.attempts)
        if (attempt.outcome != Outcome::notRun)
            session.progress.exercises[id] = attempt.outcome == Outcome::passed         ? Standing::right
                                             : attempt.outcome == Outcome::notAttempted ? Standing::notAttempted
                                                                                        : Standing::wrong;
    saveProgress(session.stateFile, session.progress);
}

int todoLine(const std::string& text, const std::string& id)
{
    const auto at = text.find("todo(\"" + id + "\")");
    return at == std::string::npos ? 0 : 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
}

bool isHandout()
{
    return fs::exists(projectFile(".raytree-handout"));
}

std::string shortened(const std::string& path)
{
    const auto relative = fs::path(path).lexically_relative(projectFile("")).string();
    return relative.empty() || relative.starts_with("..") ? path : relative;
}

} // namespace rt::grade
