// ./raytree learn
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "common/program/cli.h"
#include "common/program/guarded_main.h"
#include "tests/grade/box/temporary_folder.h"
#include "tests/learn/show.h"
#include "tests/learn/terminal.h"
#include "tests/learn/watch.h"

namespace
{

using namespace rt;
using namespace rt::grade;

struct Options
{
    int lesson = -1, once = -1;
    std::string exercise, hint, file, state = projectFile(".raytree-learn.json");
    bool list = false, reset = false;
};

const Exercise& exerciseOf(const Session& session, const std::string& id)
{
    if (const auto* found = session.find(id)) return *found;
    std::string known;
    for (const auto& exercise : session.exercises) known += (known.empty() ? "" : ", ") + exercise.id;
    throw UsageError(fmt::format("there is no exercise \"{}\"; there are {}", id, known));
}

void needLesson(const Session& session, int lesson)
{
    if (session.lesson(lesson).empty()) throw UsageError(fmt::format("there is no exercise of lesson {} here", lesson));
}

int run(const Options& options)
{
    removeAbandonedFolders();
    std::string notice;
    if (options.reset)
    {
        std::filesystem::remove(options.state);
        std::cout << "progress is forgotten; your code is as it was\n";
        return exitDone;
    }
    Session session = openSession(options.state, notice);
    if (!notice.empty()) std::cerr << "learn: " << notice << '\n';
    session.file = options.file;
    if (!options.hint.empty())
    {
        std::cout << exerciseOf(session, options.hint).hint << '\n';
        return exitDone;
    }
    if (options.list)
    {
        std::cout << progressList(session, {showsColor(), false});
        return exitDone;
    }
    if (!options.exercise.empty())
    {
        const auto& exercise = exerciseOf(session, options.exercise);
        if (options.once >= 0 && exercise.lesson != options.once)
            throw UsageError(fmt::format("{} is not of lesson {}", exercise.id, options.once));
        session.progress.current = exercise.id;
    }
    const int lesson = options.once >= 0 ? options.once : options.lesson;
    if (lesson >= 0)
    {
        needLesson(session, lesson);
        if (options.exercise.empty() && session.current().lesson != lesson)
        {
            session.progress.current = session.lesson(lesson).front().id;
            for (const auto& exercise : session.lesson(lesson))
                if (session.progress.of(exercise.id) != Standing::right)
                {
                    session.progress.current = exercise.id;
                    break;
                }
        }
    }
    else if (!options.file.empty())
        throw UsageError("--file needs the number of its lesson");
    // Without a terminal there are no keys to wait for: it prints, and ends.
    if (options.once >= 0) return once(session, options.once, options.exercise);
    if (!isTerminal()) return once(session, session.current().lesson, session.current().id);
    return watch(session);
}

int learn(int argc, char** argv)
{
    CommandLine app("Shows which exercise is next, and says at each save of its file what is right and what is not.",
                    "learn");
    Options options;
    app.option("lesson", options.lesson, "go to this lesson; default: where you were").type("N");
    app.option("--once", options.once, "run the exercises of this lesson once").type("N");
    app.option("--exercise", options.exercise, "only this one, as 02-reflect").type("ID");
    app.flag("--list", options.list, "all exercises and how far you are");
    app.option("--hint", options.hint, "the hint of an exercise").type("ID");
    app.flag("--reset", options.reset, "forget the progress, not the code");
    app.option("--file", options.file, "in place of the lesson's exercise.h").existingFile();
    app.option("--state", options.state, "where the progress is kept; default: .raytree-learn.json of the project");
    app.footer("Keys: h hint, n next, p previous, r run again, q quit.\n"
               "Exit codes: 0 done, --once: all right; 1 --once: something is wrong or not attempted; 2 bad usage, 130 "
               "interrupted.");
    return runMain(app, argc, argv, [&] { return run(options); });
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return learn(argc, argv); });
}
