#include "trade.h"

#include <filesystem>
#include <iostream>

#include <fmt/format.h>
#include <unistd.h>

#include "common/files/picture_file.h"
#include "common/files/scene_file.h"
#include "common/files/text_file.h"
#include "common/program/cli.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/registry.h"
#include "recommend.h"
#include "report.h"
#include "units.h"

namespace rt::lesson10
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* page = "slides-notes/10-speed-and-accuracy.md";
constexpr const char* plot = "slides-notes/pictures/10_pareto.svg";

struct Options : TraceOptions
{
    bool quick = false, modelling = false, notes = false;
    std::string out, budget, accuracy, against = "one";
    int samples = 0;
};

void addOptions(CommandLine& app, Options& options)
{
    app.option("scene", options.scene, "scene file (TOML); default: the seven scenes of lesson 10").type("SCENE.toml");
    app.flag("--quick", options.quick, "small pictures and few runs: under a minute");
    app.option("--out", options.out,
               "folder for the report, default out/trade; with --budget or --accuracy the picture's file")
        .type("DIR");
    const auto budget = app.option("--budget", options.budget,
                                   "recommend the most accurate setting that renders the scene in this CPU "
                                   "time of one thread, in ms or s, as in 100ms")
                            .type("TIME");
    const auto accuracy =
        app.option("--accuracy", options.accuracy, "recommend the fastest setting of at least this PSNR, as in 60dB")
            .type("DB");
    app.option("--against", options.against,
               "PSNR against the exact picture with the same samples (one), or against the picture "
               "of many samples (many)")
        .oneOf({"one", "many"})
        .showsDefault();
    app.option(
           "--samples", options.samples,
           "samples of the picture of many samples; default: 1024, 64 with --quick, 256 with --budget or --accuracy")
        .range(16, 65536)
        .type("N");
    app.option("--size", options.size,
               "size of the pictures; default: 320x240, 112x84 with --quick, the scene's with --budget or "
               "--accuracy")
        .type("WxH");
    const auto modelling =
        app.flag("--modelling", options.modelling, "only what it costs to model more than a scene requires");
    app.flag("--notes", options.notes, "also put the tables into the page of lesson 10").excludes(budget, accuracy);
    modelling.excludes(budget, accuracy);
    app.footer(
        "Examples:\n"
        "  trade --quick                             trade.csv, modelling.csv, trade.html and plots in out/trade\n"
        "  trade scene.toml --out mine               the study of one scene\n"
        "  trade scene.toml --budget 100ms           the most accurate picture in 100 ms of one thread\n"
        "  trade scene.toml --accuracy 60dB          the fastest picture of 60 dB\n"
        "Exit codes: 0 done, 2 bad input or usage, 4 the promise of --budget or --accuracy could not be kept, 130 "
        "interrupted.");
}

/// Throws unless the folder exists and is writable, or can be made.
void checkFolderCanBe(const std::string& folder)
{
    fs::path there = fs::absolute(folder);
    while (!fs::exists(there) && there != there.parent_path()) there = there.parent_path();
    if (!fs::is_directory(there))
        throw std::runtime_error(fmt::format("{}: expected a folder, but {} is a file", folder, there.string()));
    if (access(there.c_str(), W_OK) != 0)
        throw std::runtime_error(fmt::format("{}: the folder {} is not writable", folder, there.string()));
}

/// One line that replaces itself on a terminal, one line a step elsewhere.
struct Progressing
{
    bool terminal = isatty(STDERR_FILENO);

    void operator()(const std::string& what, double share) const
    {
        if (terminal)
            std::cerr << fmt::format("\r{:<50} {:3.0f}%{}", what, share * 100, share >= 1 ? "\n" : "") << std::flush;
        else if (share >= 1)
            std::cerr << what << '\n';
    }
};

int stopped()
{
    return sayInterrupted("\ninterrupted: nothing was written");
}

SceneDescription load(const Options& options, const std::string& file)
{
    TraceOptions own = options;
    own.scene = file;
    SceneDescription scene = loadScene(own);
    checkModels(lesson08::entry, scene, false);
    return scene;
}

int recommendFor(const Options& options)
{
    Wish wish{.seconds = {},
              .decibels = {},
              .many = options.against == "many",
              .manySamples = options.samples > 0 ? options.samples : 256};
    const auto quantity = [](const std::string& option, auto parse, const std::string& text) {
        try
        {
            return parse(text);
        }
        catch (const std::invalid_argument& error)
        {
            throw UsageError(option, error.what());
        }
    };
    if (!options.budget.empty()) wish.seconds = quantity("--budget", parseTime, options.budget);
    if (!options.accuracy.empty()) wish.decibels = quantity("--accuracy", parseDecibels, options.accuracy);
    const std::string out = options.out.empty() ? "trade.png" : options.out;
    checkWritable(out);
    const auto scene = load(options, options.scene.empty() ? projectFile(studyScenes().front()) : options.scene);
    watchInterrupt();
    const auto found = recommend(
        scene, wish, [](const std::string& line) { std::cerr << line << '\n'; }, interrupted());
    if (!found) return stopped();
    const auto& last = found->tried.back();
    writeImage(found->image, out);
    std::cout << fmt::format("{}: {}\n  {}\n  {} of CPU time on one thread, {} against {}\n",
                             last.kept ? "recommended" : "not kept, the nearest", describe(last.setting),
                             asOptions(last.setting), timeText(last.seconds), decibelText(last.decibels),
                             wish.many ? fmt::format("{} samples a pixel", wish.manySamples) : "the exact picture");
    std::cerr << out << '\n';
    return last.kept ? int(exitDone) : exitPromiseBroken;
}

std::vector<std::string> write(const Report& report, const std::string& folder)
{
    fs::create_directories(folder);
    std::vector<std::string> written;
    const auto file = [&](const std::string& name, const std::string& text) {
        written.push_back((fs::path(folder) / name).string());
        writeTextFile(written.back(), text);
    };
    if (!report.modelled.empty()) file("modelling.csv", modellingCsv(report));
    if (!report.studies.empty()) file("trade.csv", csv(report));
    for (const auto& study : report.studies)
    {
        file(fmt::format("pareto_{}.svg", study.name), svg(study, false));
        file(fmt::format("pareto_{}_samples.svg", study.name), svg(study, true));
    }
    if (report.studies.size() > 1)
    {
        const auto all = overAll(report.studies);
        file("pareto_all.svg", svg(all, false));
        file("pareto_all_samples.svg", svg(all, true));
    }
    file("trade.html", html(report));
    return written;
}

int studyAll(const Options& options)
{
    const std::string folder = options.out.empty() ? "out/trade" : options.out;
    checkFolderCanBe(folder);
    Plan plan = options.quick ? Plan::quickOne() : Plan();
    if (options.samples > 0) plan.manySamples = options.samples;

    std::vector<std::string> files;
    if (!options.scene.empty())
        files = {options.scene};
    else
        for (const auto& file : studyScenes()) files.push_back(projectFile(file));
    std::vector<SceneDescription> scenes, modelled;
    for (const auto& file : files) scenes.push_back(load(options, file));
    if (!options.size.empty())
    {
        plan.width = scenes[0].camera.width;
        plan.height = scenes[0].camera.height;
    }
    if (options.scene.empty())
        for (const auto& file : shippedScenes())
        {
            modelled.push_back(resized(loadScene(projectFile(file)), plan.width, plan.height));
            modelled.back().file = file;
        }
    else
        modelled.push_back(resized(scenes[0], plan.width, plan.height));
    if (options.notes) checkWritable(projectFile("slides-notes/pictures/10.png"));

    watchInterrupt();
    const Progressing progress;
    Report report{.machine = thisMachine(), .quick = options.quick, .studies = {}, .modelled = {}};
    if (!options.modelling)
        for (std::size_t i = 0; i < scenes.size(); ++i)
        {
            const std::string what = fmt::format("{}/{} {}", i + 1, scenes.size(), fs::path(files[i]).stem().string());
            auto measured = study(
                scenes[i], plan, [&](double share) { progress(what, share); }, interrupted());
            if (!measured) return stopped();
            report.studies.push_back(std::move(*measured));
        }
    for (std::size_t i = 0; i < modelled.size(); ++i)
    {
        auto one = model(modelled[i], !options.quick, options.quick ? 12 : 60, options.quick ? 0.4 : 8, interrupted());
        if (!one) return stopped();
        if (!one->lessons.empty()) report.modelled.push_back(std::move(*one));
        progress("what modelling more costs", double(i + 1) / double(modelled.size()));
    }
    const auto written = write(report, folder);
    if (options.notes)
    {
        writeTextFile(projectFile(page), replaceSection(readTextFile(projectFile(page)), "tables", markdown(report)));
        if (!report.studies.empty()) writeTextFile(projectFile(plot), svg(overAll(report.studies), false));
    }
    for (const auto& file : written) std::cout << file << '\n';
    return exitDone;
}

} // namespace

int tradeMain(int argc, char** argv)
{
    CommandLine app("Measures what each approximation costs and buys; or, with --budget or --accuracy, recommends a "
                    "setting for a scene, "
                    "renders it and checks the promise.",
                    "trade");
    Options options;
    addOptions(app, options);
    return runMain(app, argc, argv, [&] {
        return options.budget.empty() && options.accuracy.empty() ? studyAll(options) : recommendFor(options);
    });
}

} // namespace rt::lesson10
