#include <iostream>

#include <fmt/format.h>

#include "common/files/picture_file.h"
#include "common/files/scene_file.h"
#include "common/program/cli.h"
#include "exhibits.h"
#include "lessons/09_limitations/pairs.h"
#include "subject.h"

namespace rt::lesson10
{

namespace
{

struct Options : TraceOptions
{
    std::string exhibit;
    std::string out;
};

void addOptions(CommandLine& app, Options& options)
{
    std::vector<std::string> names;
    for (const auto& exhibit : exhibits()) names.emplace_back(exhibit.name);
    app.option("scene", options.scene, "scene file (TOML), with --exhibit; default: the exhibit's own scene")
        .type("SCENE.toml");
    app.option("--exhibit", options.exhibit, "which poor choice; default: all, each in its own scene").oneOf(names);
    app.option("--size", options.size, "size of either half in pixels; default: the scene's").type("WxH");
    app.option("--threads", options.threads, "threads; default: one a core").range(1, 1024).type("N");
    app.option("--out", options.out, "where the pair goes, with --exhibit: .png, .ppm, .exr or .hdr").type("FILE");
    app.footer("Examples:\n"
               "  lesson10                                  all pairs, lesson10_acne.png and so on\n"
               "  lesson10 --exhibit acne --size 640x480 --out acne.png\n"
               "  lesson10 scene.toml --exhibit lost_shells\n"
               "What the choices cost and buy: trade --help.\n"
               "Exit codes: 0 done, 2 bad input or usage, 130 interrupted.");
}

/// Scenes are read and checked before anything is traced, and files are written when all is traced.
int run(const Options& options)
{
    if (options.exhibit.empty() && !(options.scene.empty() && options.out.empty()))
        throw UsageError("--exhibit", "is missing: a scene or --out is for one pair, not for all");
    struct Pair
    {
        const Exhibit* exhibit;
        SceneDescription scene;
        std::string path;
        Image image;
        int poor = 0, good = 0;
    };
    std::vector<Pair> pairs;
    for (const auto& exhibit : exhibits())
    {
        if (!options.exhibit.empty() && options.exhibit != exhibit.name) continue;
        Options own = options;
        if (own.scene.empty()) own.scene = projectFile(exhibit.scene);
        pairs.push_back({&exhibit,
                         loadScene(own),
                         options.out.empty() ? fmt::format("lesson10_{}.png", exhibit.name) : options.out,
                         {}});
        checkWritable(pairs.back().path);
    }
    watchInterrupt();
    const auto bar = progressBar("lesson 10");
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        auto& [exhibit, scene, path, image, poor, good] = pairs[i];
        const RenderOptions render{.threads = options.threads, .progress = {}, .stop = &interrupted()};
        const auto half = [&](const Setting& setting) { return prepare(scene, setting)->render(render); };
        image = lesson09::sideBySide(half(exhibit->poorSetting), half(exhibit->goodSetting));
        if (interrupted()) return sayInterrupted();
        poor = countFault(scene, *exhibit, exhibit->poorSetting);
        good = countFault(scene, *exhibit, exhibit->goodSetting);
        if (bar) bar(double(i + 1) / double(pairs.size()));
    }
    for (const auto& pair : pairs)
    {
        writeImage(pair.image, pair.path);
        std::cerr << fmt::format("{}\n  left, {}: {}\n  right, {}: {}\n  {}: {} left, {} right\n", pair.path,
                                 describe(pair.exhibit->poorSetting), pair.exhibit->poor,
                                 describe(pair.exhibit->goodSetting), pair.exhibit->good, name(pair.exhibit->fault),
                                 pair.poor, pair.good);
    }
    return exitDone;
}

} // namespace

int exhibitsMain(int argc, char** argv)
{
    CommandLine app("Lesson 10, Speed and accuracy: poor choices, each beside what cures it.", "lesson10");
    Options options;
    addOptions(app, options);
    return runMain(app, argc, argv, [&] { return run(options); });
}

} // namespace rt::lesson10
