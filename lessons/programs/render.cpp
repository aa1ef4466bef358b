// `render`: the program of the smallest lesson that models all that a scene requires; says which one on standard error.
#include <iostream>

#include <fmt/format.h>

#include "common/files/scene_file.h"
#include "common/program/guarded_main.h"
#include "lessons/programs/formulas.h"
#include "lessons/programs/program.h"
#include "lessons/programs/registry.h"

namespace rt
{

namespace
{

int renderMain(int argc, char** argv)
{
    CommandLine app("Renders a scene with the first lesson that models all that it requires.", "render");
    LessonOptions options;
    addLessonOptions(app, options);
    footer(app, "render");
    app["scene"].required().help("scene file (TOML)");
    return runMain(app, argc, argv, [&] {
        const auto scene = loadScene(options);
        const auto* lesson = smallestLesson(scene);
        if (!lesson && !options.force) checkModels(*lessons().back(), scene, false);
        if (!lesson) lesson = lessons().back();
        std::cerr << fmt::format("lesson {:02} ({}) models all that {} requires\n", lesson->number, lesson->title,
                                 scene.file);
        return run(*lesson, scene, options, "render", lectureFormulas());
    });
}

} // namespace

} // namespace rt

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return rt::renderMain(argc, argv); });
}
