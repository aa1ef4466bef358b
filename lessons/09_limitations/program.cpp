#include <iostream>

#include <fmt/format.h>

#include "common/files/picture_file.h"
#include "common/files/scene_file.h"
#include "common/program/cli.h"
#include "common/tree/tree_growth.h"
#include "lessons/programs/entries.h"
#include "lessons/programs/facts.h"
#include "pairs.h"

namespace rt::lesson09
{

namespace
{

struct Options : TraceOptions
{
    std::string limitation;
    std::string out;
    double lightRadius = 0; ///< 0: the limitation's own
};

struct Picture
{
    Image image;
    std::string path;
};

void addOptions(CommandLine& app, Options& options)
{
    std::vector<std::string> names;
    for (const auto& limitation : limitations()) names.emplace_back(limitation.name);
    options.spp = 0;
    app.option("scene", options.scene, "scene file (TOML), with --limitation; default: the limitation's own scene")
        .type("SCENE.toml");
    app.option("--limitation", options.limitation, "what to compare; default: all five, each with its own scene")
        .oneOf(names);
    app.option("--light-radius", options.lightRadius, "of the spheres that lamps become; default: the limitation's")
        .range(1e-6, 1e6)
        .type("R");
    app.option("--spp", options.spp, "samples per pixel: paths in the reference; default: the limitation's")
        .range(1, 65536)
        .type("N");
    app.option("--size", options.size, "size of either half in pixels; default: the scene's").type("WxH");
    app.option("--threads", options.threads, "threads; default: one a core").range(1, 1024).type("N");
    app.option("--out", options.out, "where the pair goes, with --limitation: .png, .ppm, .exr or .hdr").type("FILE");
    app.footer(
        "Examples:\n"
        "  lesson09                                  five pairs, lesson09_shadows.png and so on; a minute or two\n"
        "  lesson09 --limitation caustic --light-radius 0.1 --spp 2048\n"
        "  lesson09 scene.toml --limitation indirect --out pair.exr\n"
        "Exit codes: 0 done, 2 bad input or usage, 130 interrupted.");
}

/// Both halves, with one progress bar: lesson 08 is the quicker one.
Image pair(const SceneDescription& scene, const Limitation& limitation, const Options& options)
{
    constexpr double leftShare = 0.1;
    const auto bar = progressBar(fmt::format("lesson 09, {}", limitation.name));
    RenderOptions render{.spp = options.spp > 0 ? options.spp : limitation.spp,
                         .threads = options.threads,
                         .progress = {},
                         .stop = &interrupted()};
    if (bar) render.progress = [&bar](double share) { bar(leftShare * share); };
    const Image left = lessonPicture(scene, limitation, render);
    if (bar) render.progress = [&bar](double share) { bar(leftShare + (1 - leftShare) * share); };
    const double radius = options.lightRadius > 0 ? options.lightRadius : limitation.lightRadius;
    return sideBySide(left, referencePicture(scene, limitation, radius, render));
}

/// Scenes are read and checked before anything is traced, and files are written when all is traced.
int run(const Options& options)
{
    if (options.limitation.empty() && !(options.scene.empty() && options.out.empty()))
        throw UsageError("--limitation", "is missing: a scene or --out is for one pair, not for all five");
    if (std::isnan(options.lightRadius)) throw UsageError("--light-radius", "expected a number, got nan");
    std::vector<const Limitation*> wanted;
    for (const auto& limitation : limitations())
        if (options.limitation.empty() || options.limitation == limitation.name) wanted.push_back(&limitation);

    std::vector<SceneDescription> scenes;
    std::vector<Picture> pictures;
    for (const auto* limitation : wanted)
    {
        Options own = options;
        if (own.scene.empty()) own.scene = projectFile(limitation->scene);
        scenes.push_back(loadScene(own));
        checkModels(lesson08::entry, scenes.back(), false);
        const auto warning = growthWarning(scenes.back(), lesson08::entry.models);
        if (!warning.empty()) std::cerr << warning << '\n';
        pictures.push_back({{}, options.out.empty() ? fmt::format("lesson09_{}.png", limitation->name) : options.out});
        checkWritable(pictures.back().path);
    }
    watchInterrupt();
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        pictures[i].image = pair(scenes[i], *wanted[i], options);
        if (interrupted()) return sayInterrupted();
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        writeImage(pictures[i].image, pictures[i].path);
        std::cerr << fmt::format("{}\n  left, lesson 08: {}\n  right, reference: {}\n  what brings it: {}\n",
                                 pictures[i].path, wanted[i]->left, wanted[i]->right, wanted[i]->method);
    }
    return exitDone;
}

} // namespace

int limitationsMain(int argc, char** argv)
{
    CommandLine app(
        "Lesson 09, Limitations: lesson 08's picture beside a brute-force reference. Lecture: \"Limitations of "
        "Whitted-style\".",
        "lesson09");
    Options options;
    addOptions(app, options);
    return runMain(app, argc, argv, [&] { return run(options); });
}

} // namespace rt::lesson09
