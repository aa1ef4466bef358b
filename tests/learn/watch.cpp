#include "tests/learn/watch.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "common/program/program.h"
#include "tests/learn/show.h"
#include "tests/learn/terminal.h"

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

constexpr double pause = 0.3; ///< seconds between two looks at the file

/// Changes when the file is saved; editors that write anew and rename are noticed too.
struct Stamp
{
    fs::file_time_type time{};
    std::uintmax_t size = 0;

    bool operator==(const Stamp&) const = default;
};

std::optional<Stamp> stampOf(const std::string& path)
{
    std::error_code failed;
    const Stamp stamp{fs::last_write_time(path, failed), fs::file_size(path, failed)};
    return failed ? std::nullopt : std::optional(stamp);
}

void say(const std::string& text)
{
    std::cout << text << std::flush;
}

struct Watch
{
    Session& session;
    Look look;
    LessonRun run;
    std::optional<Stamp> stamp;

    Exercise current() const { return session.current(); }

    bool isRight(const Exercise& exercise) const
    {
        const auto found = run.attempts.find(exercise.id);
        return found != run.attempts.end() && found->second.outcome == Outcome::passed;
    }

    void show() const
    {
        const auto exercise = current();
        const char* term = std::getenv("TERM");
        const bool clears = isTerminal() && term && std::strcmp(term, "dumb") != 0;
        say((clears ? "\033[2J\033[H" : "\n") + progressLine(session) + "\n" + exerciseText(session, exercise, look) +
            "\n" + resultText(session, exercise, run, look) + (isRight(exercise) ? nextText(session, exercise) : "") +
            fmt::format("\nh hint  n next  p previous  r run again  q quit; waiting for {} to be saved\n",
                        shortened(session.fileOf(exercise.lesson))));
    }

    void runAgain()
    {
        const auto exercise = current();
        stamp = stampOf(session.fileOf(exercise.lesson));
        say(fmt::format("compiling {} ...\n", shortened(session.fileOf(exercise.lesson))));
        run = runLesson(session, exercise.lesson, exercise.id);
        note(session, run);
        show();
    }

    void go(const Exercise* exercise)
    {
        if (!exercise) return say("there is none\n");
        const bool sameFile = exercise->lesson == current().lesson;
        session.progress.current = exercise->id;
        saveProgress(session.stateFile, session.progress);
        if (!session.file.empty() && !sameFile) session.file.clear();
        const auto found = run.attempts.find(exercise->id);
        if (sameFile && found != run.attempts.end() && found->second.outcome != Outcome::notRun)
            show();
        else
            runAgain();
    }

    /// A save of a file whose exercise was right already is about another one of the same file.
    void saved()
    {
        const auto exercise = current();
        const auto standing = session.progress.of(exercise.id);
        const auto* next = session.nextToDo(exercise.id);
        if (standing == Standing::right && next && next->lesson == exercise.lesson) session.progress.current = next->id;
        runAgain();
    }

    /// False: the end.
    bool key(char key)
    {
        const auto exercise = current();
        switch (key)
        {
        case 'q':
            return false;
        case 'h':
            say(fmt::format("hint: {}\n", exercise.hint));
            break;
        case 'n':
            go(session.neighbour(exercise.id, 1));
            break;
        case 'p':
            go(session.neighbour(exercise.id, -1));
            break;
        case 'r':
            runAgain();
            break;
        default:
            break;
        }
        return true;
    }
};

/// An editor may be in the middle of a save: a file that cannot be read now is looked at again at its next change.
template <class Work>
bool patiently(const Work& work)
{
    try
    {
        return work();
    }
    catch (const std::runtime_error& error)
    {
        say(fmt::format("{}; waiting for it to be saved\n", error.what()));
        return true;
    }
}

} // namespace

int watch(Session& session)
{
    watchInterrupt({.words = [] { return std::string(); }});
    Keys keys;
    Watch watch{session, {showsColor(), showsPictures()}, {}, {}};
    patiently([&] { return watch.runAgain(), true; });
    while (!interrupted())
    {
        if (const auto key = keys.read(pause); key && !patiently([&] { return watch.key(*key); }))
        {
            saveProgress(session.stateFile, session.progress);
            return exitDone;
        }
        const auto now = stampOf(session.fileOf(watch.current().lesson));
        if (now && now != watch.stamp && !interrupted()) patiently([&] { return watch.saved(), true; });
    }
    say("\n");
    return exitInterrupted;
}

int once(Session& session, int lesson, const std::string& id)
{
    const Look look{showsColor(), false};
    const auto exercises = session.lesson(lesson);
    const auto run = runLesson(session, lesson, id.empty() ? exercises.front().id : id);
    note(session, run);
    bool allRight = run.compiled;
    for (const auto& exercise : exercises)
    {
        if (!id.empty() && exercise.id != id) continue;
        const auto found = run.attempts.find(exercise.id);
        allRight = allRight && found != run.attempts.end() && found->second.outcome == Outcome::passed;
        say(exerciseText(session, exercise, look) + resultText(session, exercise, run, look) + "\n");
        if (!run.compiled) break;
    }
    if (allRight) say(nextText(session, id.empty() ? exercises.back() : *session.find(id)));
    say(progressLine(session));
    return allRight ? exitDone : 1;
}

} // namespace rt::grade
