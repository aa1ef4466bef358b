#include "lessons/programs/program.h"

#include <iostream>

#include <fmt/format.h>

#include "common/files/picture_file.h"
#include "common/files/scene_file.h"
#include "common/tree/explain.h"
#include "common/tree/tree_growth.h"
#include "lessons/programs/program_main.h"

namespace rt
{

namespace
{

void printTree(const LessonEntry& lesson, const SceneDescription& scene, const LessonOptions& options,
               const LectureFormulas& formulas)
{
    const Probe chosen = probe(options, scene);
    RayTree tree = lesson.inspect(scene, options.precision(), chosen, &interrupted());
    tree.source = lesson.source;
    if (const auto warning = firstContradiction(tree); !warning.empty()) std::cerr << warning << '\n';
    const bool isOfPixel = std::holds_alternative<std::array<int, 2>>(chosen);
    if (isOfPixel && options.spp > 1)
        (options.tree == "json" ? std::cerr : std::cout) << fmt::format(
            "the tree of the ray through the pixel's centre; the picture has the mean of {} samples\n", options.spp);
    if (options.tree == "json") std::cout << toJson(tree);
    if (options.tree == "text" || (options.tree.empty() && !options.explain)) std::cout << toText(tree);
    if (options.explain) (options.tree == "json" ? std::cerr : std::cout) << explain(tree, scene, formulas);
}

int renderPicture(const LessonEntry& lesson, const SceneDescription& scene, const LessonOptions& options,
                  const std::string& path)
{
    const RenderOptions render{.spp = options.spp,
                               .threads = options.threads,
                               .progress = progressBar(fmt::format("lesson {:02}", lesson.number)),
                               .stop = &interrupted()};
    const Image image = lesson.render(scene, options.precision(), render);
    if (interrupted()) return sayInterrupted();
    writeImage(image, path);
    std::cerr << fmt::format("{}: {}x{} pixels, lesson {:02} {}, {}\n", path, image.width, image.height, lesson.number,
                             lesson.title, options.real);
    return exitDone;
}

} // namespace

void addLessonOptions(CommandLine& app, LessonOptions& options)
{
    addTraceOptions(app, options);
    app.option("--out", options.out, "where the picture goes: .png, .ppm (8-bit sRGB), .exr or .hdr (linear)")
        .type("FILE");
    app.option("--tree", options.tree, "print the ray tree of --pixel, --ray or the scene's own pixel")
        .oneOf({"text", "json"});
    app.flag("--explain", options.explain, "print each formula of that tree with its numbers");
    app.flag("--force", options.force, "trace a scene that needs a later lesson, as far as this one can");
}

void footer(CommandLine& app, const std::string& command)
{
    app.footer(fmt::format("Examples:\n"
                           "  {0}                                       its own first scene, to {1}.png\n"
                           "  {0} scene.toml --size 1024x768 --out picture.exr\n"
                           "  {0} --pixel 320,240 --tree text           why has this pixel its colour?\n"
                           "  {0} --ray 0,1,5,0,0,-1 --tree json        one ray, for other programs\n"
                           "Exit codes: 0 done, 2 bad input or usage, 130 interrupted.",
                           command, app.program()));
}

int run(const LessonEntry& lesson, const SceneDescription& scene, const LessonOptions& options,
        const std::string& command, const LectureFormulas& formulas)
{
    checkModels(lesson, scene, options.force);
    const bool wantsPicture = !options.wantsTree() || !options.out.empty();
    const auto picture = options.out.empty() ? command + ".png" : options.out;
    if (wantsPicture) checkWritable(picture);
    for (const auto& warning : {growthWarning(scene, lesson.models), cutoffWarning(scene, lesson.models)})
        if (!warning.empty()) std::cerr << warning << '\n';
    watchInterrupt();
    if (options.wantsTree()) printTree(lesson, scene, options, formulas);
    return wantsPicture ? renderPicture(lesson, scene, options, picture) : int(exitDone);
}

int programMain(const LessonEntry& lesson, const std::string& program, const char* what,
                const LectureFormulas& formulas, int argc, char** argv, const std::vector<ExtraOption>& extra)
{
    CommandLine app(fmt::format("{} {:02}, {}. Lecture: {}.", what, lesson.number, lesson.title, lesson.slides),
                    program);
    LessonOptions options;
    addLessonOptions(app, options);
    std::vector<std::string> values(extra.size());
    for (std::size_t i = 0; i < extra.size(); ++i)
        app.option(extra[i].name, values[i], extra[i].help).type(extra[i].type);
    footer(app, program);
    return runMain(app, argc, argv, [&] {
        for (std::size_t i = 0; i < extra.size(); ++i)
            if (!values[i].empty())
            {
                extra[i].run(values[i]);
                return int(exitDone);
            }
        if (options.scene.empty()) options.scene = projectFile(lesson.scene);
        return run(lesson, loadScene(options), options, program, formulas);
    });
}

} // namespace rt
