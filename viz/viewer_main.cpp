#include "viz/viewer_main.h"

#include <algorithm>
#include <charconv>
#include <iostream>

#include <fmt/format.h>

#include "common/cli.h"
#include "common/image.h"
#include "lessons/registry.h"
#include "viz/display.h"
#include "viz/fonts.h"
#include "viz/window.h"

namespace rt::viz
{

namespace
{

/// The lesson whose first scene is shown if neither a lesson nor a scene is named; 0: the last one.
constexpr int startLesson = 6;

struct ViewerOptions : TraceOptions
{
    std::string lesson; ///< its number; empty: the smallest that is sufficient
    std::string screenshot;
    std::string windowSize = "1600x900";
    bool force = false;
};

const LessonEntry& lessonOf(const std::string& text)
{
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    if (const auto* lesson = findLesson(number)) return *lesson;
    std::string known;
    for (const auto* lesson : lessons()) known += fmt::format("{}{}", known.empty() ? "" : ", ", lesson->number);
    throw CLI::ValidationError("N", fmt::format("there is no lesson {}; there are {}", text, known));
}

std::array<int, 2> windowSize(const std::string& text)
{
    std::array<int, 2> size{};
    const char* end = text.data() + text.size();
    const auto [middle, error] = std::from_chars(text.data(), end, size[0]);
    if (error == std::errc() && middle != end && *middle == 'x')
        if (const auto rest = std::from_chars(middle + 1, end, size[1]); rest.ec == std::errc() && rest.ptr == end)
            if (size[0] >= 640 && size[1] >= 400 && size[0] <= 8192 && size[1] <= 8192) return size;
    throw CLI::ValidationError("--size-window",
                               fmt::format("expected WxH from 640x400 to 8192x8192, got \"{}\"", text));
}

Session chooseSession(ViewerOptions options)
{
    const LessonEntry* lesson = options.lesson.empty() ? nullptr : &lessonOf(options.lesson);
    if (!lesson && options.scene.empty()) lesson = startLesson ? findLesson(startLesson) : lessons().back();
    if (options.scene.empty()) options.scene = projectFile(lesson->scene);
    Session session;
    session.scene = loadScene(options);
    session.precision = options.precision();
    if (!lesson)
    {
        lesson = smallestLesson(session.scene);
        if (lesson)
            std::cerr << fmt::format("lesson {:02} ({}) models all that {} requires\n", lesson->number, lesson->title,
                                     session.scene.file);
        else
            lesson = lessons().back();
    }
    checkModels(*lesson, session.scene, options.force);
    session.lesson = lesson;
    session.render.spp = options.spp;
    session.render.threads = options.threads;
    session.render.progress = progressBar(fmt::format("lesson {:02}", lesson->number));
    session.probe = probe(options, session.scene);
    return session;
}

int view(const ViewerOptions& options, char** argv)
{
    const auto [width, height] = windowSize(options.windowSize);
    const bool toFile = !options.screenshot.empty();
    if (toFile) checkWritable(options.screenshot);
    const bool display = hasDisplay();
    if (toFile && !display) restartWithDisplay(argv, width, height);

    Session session = chooseSession(options);
    if (!display)
    {
        std::cerr << (toFile
                          ? "viewer: a screenshot needs a display or the program xvfb-run (Debian's package is xvfb)\n"
                          : "viewer: there is no display to open a window on; --screenshot FILE.png needs none\n");
        return exitNoDisplay;
    }
    checkFonts();
    Controller controller(std::move(session));
    Window window(controller, width, height, !toFile);
    if (!toFile)
    {
        window.run();
        return exitDone;
    }
    writeImage(window.picture(), options.screenshot);
    std::cerr << fmt::format("{}: {}x{} pixels\n", options.screenshot, width, height);
    return exitDone;
}

} // namespace

int viewerMain(int argc, char** argv)
{
    CLI::App app("Shows a scene, the rays of one pixel in space, and each ray's formulas with its numbers.", "viewer");
    ViewerOptions options;
    const auto isNumber = [](const std::string& text) {
        const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
        return digits ? std::string() : "expected the number of a lesson, got \"" + text + "\"";
    };
    app.add_option("lesson", options.lesson, "number of a lesson; default: the first that models the scene")
        ->check(CLI::Validator(isNumber, ""))
        ->type_name("N");
    app.validate_positionals();
    addTraceOptions(app, options);
    app.add_option("--screenshot", options.screenshot, "write a picture of the window and exit; needs no display")
        ->type_name("FILE.png");
    app.add_option("--size-window", options.windowSize, "size of the window in pixels")
        ->type_name("WxH")
        ->capture_default_str();
    app.add_flag("--force", options.force, "show a scene that needs a later lesson, as far as this one can");
    app.footer("Examples:\n"
               "  viewer                              a scene with a pixel already chosen\n"
               "  viewer 2                            lesson 02 on its own first scene\n"
               "  viewer scene.toml --pixel 320,240   with the first lesson that models all of it\n"
               "  viewer 2 --screenshot view.png      the same as a file\n"
               "Keys: press h in the window. Exit codes: 0 done, 2 bad input or usage, 3 no display.");
    return runMain(app, argc, argv, [&] { return view(options, argv); });
}

} // namespace rt::viz
