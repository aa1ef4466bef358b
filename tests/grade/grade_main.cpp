// The program `grade`: a class of submissions in, a gradebook out.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <random>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "common/files/picture_file.h"
#include "common/files/scene_text.h"
#include "common/files/text_file.h"
#include "common/program/cli.h"
#include "common/program/guarded_main.h"
#include "tests/grade/box/temporary_folder.h"
#include "tests/grade/class_run.h"
#include "tests/grade/questions/manifest.h"
#include "tests/grade/report/files.h"
#include "tests/grade/report/text.h"

namespace rt::grade
{

namespace
{

enum GradeExit
{
    exitGraderError = 3,
    exitNoSandbox = 4
};

struct Options
{
    int lesson = -1;
    std::string submissions, submission, student, out, secret, term, shard, sandbox = "auto";
    int jobs = 1;
    double cpuSeconds = 10;
    bool resume = false, trusted = false, selfTestOnly = false;
};

void addOptions(CommandLine& app, Options& options)
{
    const auto lessons = exerciseLessons();
    app.option("lesson", options.lesson, fmt::format("number of the lesson, {} to {}", lessons.front(), lessons.back()))
        .check([lessons](const std::string& text) {
            for (const int lesson : lessons)
                if (std::to_string(lesson) == text) return std::string();
            return fmt::format("\"{}\" is no lesson with exercises, expected one of {}", text,
                               fmt::join(lessons, ", "));
        })
        .type("LESSON");
    const auto many = app.option("--submissions", options.submissions,
                                 "folder of the class: each entry is a student's folder, archive or file")
                          .type("DIR");
    const auto one =
        app.option("--submission", options.submission, "one student's folder, archive or file, in place of a class")
            .type("PATH")
            .excludes(many);
    app.option("--student", options.student, "with --submission: the student's name; default: the file's")
        .type("NAME")
        .needs(one);
    app.option("--out", options.out, "folder of the results").type("DIR");
    app.option("--secret", options.secret,
               "file of the course's secret, at least 16 bytes: it decides the hidden cases; default: made once, "
               "OUT/secret")
        .type("FILE");
    app.option("--term", options.term, "another term has other hidden cases").type("TEXT");
    app.option("--jobs", options.jobs, "submissions graded at the same time").range(1, 64).type("N").showsDefault();
    app.flag("--resume", options.resume, "keep results whose submission, grader, lesson and secret have not changed");
    app.option("--shard", options.shard, "grade only the i-th of n parts of the class; grade_merge joins them")
        .type("i/n");
    app.option("--cpu-seconds", options.cpuSeconds,
               "processor time that a student's program may take; wall time is 2.4 times that")
        .range(0.5, 600.0)
        .type("S")
        .showsDefault();
    app.option("--sandbox", options.sandbox, "auto takes bubblewrap, or chroot where that cannot run")
        .oneOf({"auto", "bubblewrap", "chroot", "none"})
        .showsDefault();
    app.flag("--i-trust-this-code", options.trusted, "with --sandbox none: run the submissions with your own rights");
    app.flag("--self-test", options.selfTestOnly, "only try whether the sandbox holds, and say so");
    app.footer("Writes OUT/gradebook.csv, class.html, junit.xml, and for each student results/NAME/results.json and\n"
               "reports/NAME.html; what is for the instructor only lies in OUT/instructor.\n\n"
               "Examples:\n"
               "  grade 6 --submissions class --out marks --secret course.secret --jobs 2\n"
               "  grade 6 --submissions class --out marks --secret course.secret --resume\n"
               "  grade 6 --submission anna.zip --out anna --secret course.secret\n"
               "Exit codes: 0 all graded, 2 bad input or usage, 3 the grader failed on some, 4 no sandbox,\n"
               "130 interrupted: the same line with --resume goes on.");
}

Shard shardOf(const std::string& text)
{
    Shard shard;
    if (text.empty()) return shard;
    int used = 0;
    const bool read = std::sscanf(text.c_str(), "%d/%d%n", &shard.part, &shard.of, &used) == 2;
    if (!read || std::size_t(used) != text.size() || shard.of < 1 || shard.part < 1 || shard.part > shard.of)
        throw UsageError("--shard",
                         fmt::format("expected i/n with 1 <= i <= n, as in 2/8, got \"{}\"", onOneLine(text)));
    return shard;
}

std::vector<Submission> submissionsOf(const Options& options)
{
    if (options.submission.empty())
    {
        auto all = listSubmissions(options.submissions);
        if (all.empty())
            throw std::runtime_error(options.submissions +
                                     ": there are no submissions in this folder, expected one entry a student");
        return all;
    }
    namespace fs = std::filesystem;
    const auto path = fs::absolute(options.submission).lexically_normal();
    const auto last = path.has_filename() ? path : path.parent_path();
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(last, ignored)))
        throw std::runtime_error(options.submission +
                                 ": there is no such file or folder, expected a student's submission");
    return {{options.student.empty() ? studentOf(last.string()) : options.student, last.string()}};
}

std::runtime_error notWritable(const std::string& out, const std::string& why)
{
    return std::runtime_error(
        fmt::format("{}: results cannot be written there ({}), expected a folder to write to", out, why));
}

/// Nothing is graded that cannot be written. Makes nothing yet.
void checkWritable(const std::string& out)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    auto at = fs::absolute(out).lexically_normal();
    while (!fs::exists(at, ignored) && at != at.parent_path()) at = at.parent_path();
    if (!fs::is_directory(at, ignored)) throw notWritable(out, at.string() + " is not a folder");
    if (::access(at.c_str(), W_OK | X_OK) != 0) throw notWritable(out, at.string() + " is read-only for this user");
}

void makeFolder(const std::string& out)
{
    std::error_code error;
    std::filesystem::create_directories(out, error);
    if (error) throw notWritable(out, error.message());
}

std::string ownSecret(const Options& options)
{
    return options.out + "/secret";
}

void makeSecret(const std::string& path)
{
    std::random_device device;
    std::string digits;
    for (int i = 0; i < 8; ++i) digits += fmt::format("{:08x}", device());
    constexpr mode_t ownerOnly = 077;
    const auto before = ::umask(ownerOnly);
    writeTextFile(path, digits + "\n");
    ::umask(before);
    std::cerr << fmt::format("grade: no --secret was given, so one was made: keep {} to grade the same way again\n",
                             path);
}

/// The course's secret, or the one that was made for these results; empty: it is still to be made.
std::string secretOf(const Options& options)
{
    constexpr std::size_t least = 16;
    const auto path = options.secret.empty() ? ownSecret(options) : options.secret;
    if (options.secret.empty() && !std::filesystem::exists(path))
    {
        if (!options.shard.empty())
            throw UsageError("--shard", "all parts of a class need the same secret; name its file with --secret");
        return "";
    }
    if (!std::filesystem::is_regular_file(path))
        throw std::runtime_error(path + ": there is no such file, expected the course's secret");
    auto secret = readTextFile(path);
    if (secret.size() < least)
        throw std::runtime_error(
            fmt::format("{} has {} bytes; a course's secret has at least {}, as from: head -c 32 /dev/urandom", path,
                        secret.size(), least));
    return secret;
}

/// The sandbox to use, tried out. Throws NoSandbox.
struct NoSandbox : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

Sandbox sandboxOf(const Options& options)
{
    if (options.sandbox == "none")
    {
        if (!options.trusted)
            throw UsageError("--sandbox",
                             "none runs the submissions with your own rights; say --i-trust-this-code if you mean it");
        return Sandbox::none;
    }
    if (options.sandbox == "auto")
    {
        std::string why;
        const auto best = bestSandbox(why);
        if (!best)
            throw NoSandbox(fmt::format("no sandbox works here: {}; nothing was run (--sandbox none "
                                        "--i-trust-this-code would run it unprotected)",
                                        why));
        if (*best != Sandbox::bubblewrap) std::cerr << fmt::format("grade: the sandbox is {}: {}\n", name(*best), why);
        return *best;
    }
    const auto sandbox = options.sandbox == "chroot" ? Sandbox::chroot : Sandbox::bubblewrap;
    if (const auto failure = selfTest({sandbox, 0}); !failure.empty())
        throw NoSandbox(fmt::format("the sandbox {} does not hold: {}; nothing was run", name(sandbox), failure));
    return sandbox;
}

std::string summary(const SubmissionResult& result)
{
    if (result.state != State::graded) return fmt::format("{}: {}", name(result.state), cleanLine(result.reason, 120));
    return fmt::format("{:.2f} of {:g}", result.points(), result.most());
}

/// A line for each student on a terminal; JSON lines on standard output elsewhere.
void show(const ClassProgress& progress)
{
    const auto& result = *progress.result;
    if (isatty(STDOUT_FILENO))
        fmt::print("{:4}/{} {:24} {}{}\n", progress.done, progress.of, cleanLine(result.student, 24), summary(result),
                   progress.kept ? " (kept)" : "");
    else
        fmt::print("{}\n", nlohmann::json{{"done", progress.done},
                                          {"of", progress.of},
                                          {"student", cleanLine(result.student)},
                                          {"state", name(result.state)},
                                          {"points", std::round(result.points() * 1e6) / 1e6},
                                          {"most", std::round(result.most() * 1e6) / 1e6},
                                          {"kept", progress.kept}}
                               .dump());
    std::fflush(stdout);
}

int run(const Options& options)
{
    removeAbandonedFolders();
    if (options.selfTestOnly)
    {
        const auto sandbox = sandboxOf(options);
        fmt::print("the sandbox {} holds\n", name(sandbox));
        return exitDone;
    }
    if (options.lesson < 0) throw UsageError("LESSON is required");
    if (options.submissions.empty() == options.submission.empty()) throw UsageError("--submissions is required");
    if (options.out.empty()) throw UsageError("--out is required");

    const auto submissions = submissionsOf(options);
    ClassSetting setting;
    setting.shard = shardOf(options.shard);
    setting.out = options.out;
    setting.jobs = options.jobs;
    setting.resume = options.resume;
    setting.setting.lesson = options.lesson;
    setting.setting.secret = {secretOf(options), options.term};
    checkWritable(options.out);
    setting.setting.sandbox = sandboxOf(options);
    makeFolder(options.out);
    if (setting.setting.secret.course.empty())
    {
        makeSecret(ownSecret(options));
        setting.setting.secret.course = secretOf(options);
    }
    setting.setting.limits.cpuSeconds = options.cpuSeconds;
    setting.setting.limits.wallSeconds = 2.4 * options.cpuSeconds;
    setting.setting.grader = graderHash();

    std::atomic<std::size_t> finished = 0;
    const auto interruption = [&finished, all = countOf(submissions, setting.shard)] {
        return fmt::format("grade: interrupted after {} of {}; the same command with --resume goes on", finished.load(),
                           all);
    };
    watchInterrupt({.words = interruption});
    const auto done = gradeClass(submissions, setting, interrupted(), [&](const ClassProgress& progress) {
        finished = progress.done;
        show(progress);
    });
    if (done.interrupted) return sayInterrupted(interruption());
    writeClass(options.out, done.results);
    std::cerr << fmt::format("grade: {} graded, {} kept; {}/gradebook.csv and class.html\n", done.graded, done.kept,
                             options.out);
    return done.graderErrors ? int(exitGraderError) : int(exitDone);
}

int gradeMain(int argc, char** argv)
{
    CommandLine app(
        "Grades a class: each submission is compiled and asked in a sandbox; what is right is decided outside.",
        "grade");
    Options options;
    addOptions(app, options);
    return runMain(app, argc, argv, [&] {
        try
        {
            return run(options);
        }
        catch (const NoSandbox& error)
        {
            std::cerr << "grade: " << error.what() << '\n';
            return int(exitNoSandbox);
        }
    });
}

} // namespace

} // namespace rt::grade

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::grade::gradeMain(argc, argv); });
}
