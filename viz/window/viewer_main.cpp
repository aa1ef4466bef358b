#include "viz/window/viewer_main.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "common/files/picture_file.h"
#include "common/files/scene_file.h"
#include "common/files/text_file.h"
#include "common/program/cli.h"
#include "common/tree/tree_growth.h"
#include "lessons/programs/registry.h"
#include "viz/export/export.h"
#include "viz/state/choose_source.h"
#include "viz/state/scene_watch.h"
#include "viz/state/script.h"
#include "viz/state/state.h"
#include "viz/state/tracer_source.h"
#include "viz/window/display.h"
#include "viz/window/display_probe.h"
#include "viz/window/own_display.h"
#include "viz/window/recording.h"
#include "viz/window/window.h"

namespace rt::viz
{

namespace
{

/// The lesson whose first scene is shown if neither a lesson nor a scene is named; 0: the last one.
constexpr int startLesson = 6;

struct ViewerOptions : TraceOptions
{
    std::string lesson; ///< its number; empty: the smallest that is sufficient
    std::string screenshot, exportTo, tracer, compare, record, play, state;
    std::optional<std::string> script;
    std::optional<std::string> windowSize; // empty: what suits screen and scale
    double scale = 0;                      // 0: what suits the screen
    std::string look = "dark";
    bool force = false;

    /// Files are all that is wanted: no window to use.
    bool isHeadless() const { return !screenshot.empty() || !exportTo.empty() || script; }
};

const LessonEntry& lessonOf(const std::string& text)
{
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    if (const auto* lesson = findLesson(number)) return *lesson;
    throw UsageError("N", whyNoLesson(number));
}

std::array<int, 2> windowSize(const std::string& text)
{
    std::array<int, 2> size{};
    const char* end = text.data() + text.size();
    const auto [middle, error] = std::from_chars(text.data(), end, size[0]);
    if (error == std::errc() && middle != end && *middle == 'x')
        if (const auto rest = std::from_chars(middle + 1, end, size[1]); rest.ec == std::errc() && rest.ptr == end)
            if (size[0] >= 640 && size[1] >= 400 && std::max(size[0], size[1]) <= largestWindow) return size;
    throw UsageError("--size-window", fmt::format("expected WxH from 640x400 to 8192x8192, got \"{}\"", text));
}

/// The scene of a tree from a file: the one that it names, if that can be read, or just a camera that looks along its ray.
SceneDescription sceneOf(const RayTree& tree, std::string& problem)
{
    // A stranger's file may name anything: only what looks like a scene is opened. (Files of /proc have no size.)
    const auto isScene = [](const std::filesystem::path& file) {
        std::error_code error;
        return file.extension() == ".toml" && std::filesystem::is_regular_file(file, error) &&
               std::filesystem::file_size(file, error) > 0 && !error;
    };
    for (const auto& file : {tree.scene, projectFile(tree.scene)})
        if (isScene(file))
        {
            try
            {
                return loadScene(file);
            }
            catch (const std::exception& error)
            {
                problem = error.what();
            }
        }
    if (problem.empty())
        problem = tree.scene.empty()
                      ? "the tree names no scene: only its rays are shown"
                      : fmt::format("the tree's scene {} is not there: only its rays are shown", tree.scene);
    SceneDescription scene;
    if (!tree.nodes.empty() && isFinite(tree.nodes[0].origin) && isFinite(tree.nodes[0].direction))
    {
        scene.camera.eye = tree.nodes[0].origin;
        scene.camera.target = scene.camera.eye + tree.nodes[0].direction;
        if (glm::length(cross(tree.nodes[0].direction, scene.camera.up)) < 1e-3 * glm::length(tree.nodes[0].direction))
            scene.camera.up = {0, 0, 1};
    }
    return scene;
}

Session sessionOfFile(const ViewerOptions& options, std::string& problem)
{
    Session session;
    RayTree tree;
    try
    {
        tree = rayTreeFromJson(readTextFile(options.scene));
    }
    catch (const std::exception& error)
    {
        const std::string said = error.what();
        throw std::runtime_error(said.starts_with(options.scene) ? said : options.scene + ": " + said);
    }
    session.scene = sceneOf(tree, problem);
    session.scene.trace.maxDepth = tree.maxDepth;
    if (tree.pixel)
    {
        auto& camera = session.scene.camera;
        // What a stranger's file says may lie outside the picture.
        session.probe = std::array{std::clamp((*tree.pixel)[0], 0, camera.width - 1),
                                   std::clamp((*tree.pixel)[1], 0, camera.height - 1)};
    }
    else if (!tree.nodes.empty())
        session.probe = GivenRay{tree.nodes[0].origin, tree.nodes[0].direction};
    session.source = fileSource(tree, options.scene);
    return session;
}

Session chooseSession(ViewerOptions options, std::string& problem)
{
    if (options.scene.ends_with(".json"))
    {
        if (!options.tracer.empty() || !options.compare.empty())
            throw UsageError(options.compare.empty() ? "--tracer" : "--compare",
                             "expected a scene, not the file of a ray tree");
        return sessionOfFile(options, problem);
    }
    const LessonEntry* lesson = options.lesson.empty() ? nullptr : &lessonOf(options.lesson);
    if (!lesson && options.scene.empty()) lesson = startLesson ? findLesson(startLesson) : lessons().back();
    if (options.scene.empty()) options.scene = projectFile(lesson->scene);
    Session session;
    session.scene = loadScene(options);
    if (!lesson)
    {
        lesson = smallestLesson(session.scene);
        if (lesson && options.tracer.empty())
            std::cerr << fmt::format("lesson {:02} ({}) models all that {} requires\n", lesson->number, lesson->title,
                                     session.scene.file);
        if (!lesson) lesson = lessons().back();
    }
    session.render.spp = options.spp;
    session.render.threads = options.threads;
    if (options.tracer.empty())
    {
        checkModels(*lesson, session.scene, options.force);
        for (const auto& warning :
             {growthWarning(session.scene, lesson->models), cutoffWarning(session.scene, lesson->models)})
            if (!warning.empty()) std::cerr << warning << '\n';
        session.source = lessonSource(*lesson, options.precision());
        if (options.isHeadless()) session.render.progress = progressBar(fmt::format("lesson {:02}", lesson->number));
    }
    else
        session.source = tracerSource(options.tracer);
    if (!options.compare.empty()) compareWith(session, options.compare, *lesson, options.precision());
    session.probe = probe(options, session.scene);
    session.reread = watchScene(session.scene, [options, lesson] {
        auto scene = loadScene(options);
        if (options.tracer.empty()) checkModels(*lesson, scene, options.force);
        return scene;
    });
    return session;
}

void exportAndTell(const std::string& path, Controller& controller)
{
    if (controller.isRefining()) controller.wait(); // a coarse picture is no result
    const auto files = exportTo(path, controller);
    std::string list;
    for (const auto& file : files) list += (list.empty() ? "" : ", ") + file;
    std::cerr << list << ": written\n";
    // The window has one line for it.
    controller.say(files.size() == 1 ? list + ": written" : fmt::format("{}: {} files written", path, files.size()),
                   Tone::done);
}

/// A window that is made when it is first needed: exports and states need none.
class LateWindow
{
public:
    LateWindow(Controller& shown, const WindowPlace& where, bool isOnScreen)
        : controller(shown), place(where), onScreen(isOnScreen)
    {
    }

    Window& operator()()
    {
        if (window) return *window;
        window = std::make_unique<Window>(controller, place, onScreen);
        window->exportAll = [this] {
            try
            {
                exportAndTell("raytree-export", controller);
            }
            catch (const std::exception& error)
            {
                controller.say(error.what());
            }
        };
        return *window;
    }

private:
    Controller& controller;
    WindowPlace place;
    bool onScreen;
    std::unique_ptr<Window> window;
};

ScriptHost scriptHost(Controller& controller, LateWindow& window)
{
    ScriptHost host{.controller = controller};
    host.exportTo = [&](const std::string& path) { exportAndTell(path, controller); };
    host.shot = [&](const std::string& file) {
        controller.wait(); // what keys and clicks have begun
        if (interrupted()) throw Stopped();
        writeImage(window().picture(), file);
    };
    host.key = [&](const std::string& key) { window().press(key); };
    // VTK counts from the lower left corner.
    const auto up = [&](int x, int y) {
        const auto [width, height] = window().size();
        if (x < 0 || y < 0 || x >= width || y >= height)
            throw std::runtime_error(fmt::format("the window has {} x {} pixels, counted from 0", width, height));
        return height - 1 - y;
    };
    host.click = [&, up](int x, int y) { window().click(x, up(x, y)); };
    host.drag = [&, up](int fromX, int fromY, int toX, int toY) {
        window().dragFrom(fromX, up(fromX, fromY), toX, up(toX, toY));
    };
    host.hover = [&, up](int x, int y) { window().hover(x, up(x, y)); };
    host.wheel = [&, up](int x, int y, bool forward) { window().wheel(x, up(x, y), forward); };
    host.resize = [&](int width, int height) {
        if (std::min(width, height) < 1 || std::max(width, height) > largestWindow)
            throw std::runtime_error("a window has 1 to 8192 pixels each way");
        window().resize(width, height);
    };
    return host;
}

/// What options and recording say. Without them the window is as large as the design; the scale may then still follow from
/// the screen, and is 0.
WindowPlace askedWindow(const ViewerOptions& options)
{
    WindowPlace place;
    place.scale = options.scale;
    if (!options.play.empty())
        if (const auto recorded = checkRecording(options.play))
        {
            place = *recorded;
            if (options.scale > 0) place.scale = options.scale;
        }
    if (options.windowSize)
    {
        const auto [width, height] = windowSize(*options.windowSize);
        place.width = width;
        place.height = height;
    }
    return place;
}

/// Completes what was asked for: pictures do not depend on the screen.
WindowPlace completed(WindowPlace place, double scale)
{
    if (!(place.scale > 0)) place.scale = scale;
    if (place.width > 0) return place;
    place.width = std::min(largestWindow, int(std::lround(designWidth * place.scale)));
    place.height = std::min(largestWindow, int(std::lround(designHeight * place.scale)));
    return place;
}

/// No part of the window, nor of its frame, is beside the screen or behind a panel.
WindowPlace onScreen(WindowPlace place, const ViewerOptions& options, const DisplayFacts& display)
{
    place = completed(place, fittingScale(display.scale, display.area, display.frame));
    auto shown = placeWindow(place.width, place.height, display.area, display.frame);
    shown.scale = place.scale;
    const bool isCut = shown.width < place.width || shown.height < place.height;
    if (isCut && (options.windowSize || !options.play.empty()))
        std::cerr << fmt::format("viewer: the screen has no room for a window of {}x{} pixels: it gets {}x{}\n",
                                 place.width, place.height, shown.width, shown.height);
    return shown;
}

/// A display that can draw: the user's or one of our own; or it says what both lack. `isMapped`: the window is shown, so
/// the screen must have room for it.
DisplayFacts displayForPicture(std::optional<OwnDisplay>& own, WindowPlace& place, bool isMapped)
{
    place = completed(place, 1);
    const auto users = askDisplay(isMapped);
    const bool hasRoom = !isMapped || (users.area.width >= place.width && users.area.height >= place.height);
    if (interrupted() || (users.lacks.empty() && hasRoom)) return users;
    std::string why;
    try
    {
        own.emplace(place.width, place.height);
        auto facts = askDisplay(false);
        if (facts.lacks.empty()) return facts;
        why = facts.lacks + " (Debian's package for drawing is libgl1-mesa-dri)";
        own.reset();
    }
    catch (const std::runtime_error& error)
    {
        why = error.what();
    }
    auto facts = users;
    if (!facts.lacks.empty())
        facts.lacks += fmt::format(", and an X server of the viewer's own cannot draw the picture either: {}", why);
    return facts;
}

int view(const ViewerOptions& options)
{
    if (!options.screenshot.empty()) checkWritable(options.screenshot);
    if (!options.exportTo.empty()) checkExport(options.exportTo);
    for (const auto& file : {options.state, options.record})
        if (!file.empty()) checkFolder(file);
    WindowPlace place = askedWindow(options);
    const auto script = options.script.value_or("");
    const bool isFile = script.find_first_of(";\n") == std::string::npos && std::filesystem::is_regular_file(script);
    const auto commands = parseScript(isFile ? readTextFile(script) : script);

    const bool drawn = !options.screenshot.empty() || !options.play.empty() || needsWindow(commands);
    DisplayFacts display;
    std::optional<OwnDisplay> own;
    if (!options.isHeadless())
    {
        display = askDisplay(true);
        if (display.lacks.empty()) place = onScreen(place, options, display);
    }
    else if (drawn)
        display = displayForPicture(own, place, !options.play.empty());

    std::string problem;
    Session session = chooseSession(options, problem);
    if (interrupted()) return exitInterrupted;
    if (!display.lacks.empty())
    {
        std::cerr << "viewer: " << display.lacks
                  << (options.isHeadless() ? "\n"
                                           : ", so no window can be opened; --screenshot FILE.png, --export FOLDER and "
                                             "--script need none\n");
        return exitNoDisplay;
    }
    // A recording is worth a longer wait: it is written when the window has closed.
    constexpr std::chrono::milliseconds tillRecorded{2000};
    watchInterrupt(options.record.empty() ? AfterInterrupt() : AfterInterrupt{.patience = tillRecorded});
    session.render.stop = &interrupted();
    session.paintsLater = !options.isHeadless();
    Controller controller(std::move(session));
    if (options.isHeadless()) controller.wait();
    if (interrupted()) return sayInterrupted();
    if (!problem.empty()) controller.say(problem);
    const auto& source = controller.source();
    const bool noPicture = source.render && !source.isSlow && controller.picture().width == 0; // too many rays
    if (options.isHeadless() && (noPicture || controller.tree().nodes.empty()) && !controller.message().empty())
        throw std::runtime_error(controller.message());
    if (options.look == "light") controller.toggleLook();

    endWithDisplay();
    // Replayed events need a window that can be clicked.
    LateWindow window(controller, place, !options.isHeadless() || !options.play.empty());
    if (!options.play.empty()) window().replay(options.play);
    runScript(commands, scriptHost(controller, window));
    if (!options.screenshot.empty())
    {
        controller.wait();
        if (interrupted()) return sayInterrupted();
        writeImage(window().picture(), options.screenshot);
        std::cerr << fmt::format("{}: {}x{} pixels\n", options.screenshot, place.width, place.height);
    }
    // After the picture, which is not about the files.
    if (!options.exportTo.empty()) exportAndTell(options.exportTo, controller);
    if (!options.isHeadless()) window().run(options.record);
    if (options.isHeadless()) controller.wait(); // what has been played may have begun another picture
    if (!options.state.empty()) writeTextFile(options.state, stateJson(controller));
    return interrupted() ? sayInterrupted("interrupted") : int(exitDone);
}

} // namespace

int viewerMain(int argc, char** argv)
{
    CommandLine app("Shows a scene, the rays of one pixel in space, and each ray's formulas with its numbers.",
                    "viewer");
    ViewerOptions options;
    const auto isNumber = [](const std::string& text) {
        const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
        return digits ? std::string() : "expected the number of a lesson, got \"" + text + "\"";
    };
    const auto isScale = [](const std::string& text) {
        double scale = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), scale);
        const bool isGood = error == std::errc() && end == text.data() + text.size() && scale >= smallestScale &&
                            scale <= largestScale; // NaN is not
        return isGood ? std::string()
                      : fmt::format("expected a number from {} to {}, got \"{}\"", smallestScale, largestScale, text);
    };
    app.option("lesson", options.lesson, "number of a lesson; default: the first that models the scene")
        .check(isNumber)
        .type("N");
    app.triesNextPlace();
    addTraceOptions(app, options);
    app.option("--screenshot", options.screenshot, "write a picture of the window and exit; needs no display")
        .type("FILE.png");
    app.option("--size-window", options.windowSize,
               "size of the window in pixels; default: 1600x900 times the scale. A window is never larger than the "
               "screen has room for, a picture is")
        .type("WxH");
    app.option("--scale", options.scale,
               "pixels for each pixel of the design, of letters, lines and panes; default: for a window the largest of "
               "Xft.dpi / 96, GDK_SCALE and QT_SCALE_FACTOR, for a picture 1")
        .check(isScale)
        .type("X");
    app.option("--export", options.exportTo,
               "write the ray tree as .json, .vtp, .glb, .gltf or .html, or all of them into a folder, and exit")
        .type("PATH");
    app.option("--tracer", options.tracer,
               "show what this program traces: it is called with the scene and --tree json or --out FILE")
        .type("CMD");
    app.option("--compare", options.compare,
               "a second tree over the first: exercise, exact, schlick, float, double, long-double, depth=N, "
               "lesson=N, a ray tree's .json file, or a program")
        .type("WHAT");
    app.option("--script", options.script, "commands to run, or a file of them, and exit; see below").type("TEXT|FILE");
    app.option("--record", options.record, "write what is done in the window to a file")
        .excludes(app["--screenshot"], app["--export"], app["--script"])
        .type("FILE");
    app.option("--play", options.play, "do in the window what was recorded, at the size that it had then").type("FILE");
    app.option("--state", options.state, "at the end, write what is selected and shown as JSON").type("FILE");
    app.option("--look", options.look, "colours of the window").oneOf({"dark", "light"}).showsDefault();
    app.flag("--force", options.force, "show a scene that needs a later lesson, as far as this one can");
    app.footer("The scene may also be a .json file that holds a ray tree.\n"
               "Examples:\n"
               "  viewer                              a scene with a pixel already chosen\n"
               "  viewer 2                            lesson 02 on its own first scene\n"
               "  viewer scene.toml --pixel 320,240   with the first lesson that models all of it\n"
               "  viewer 2 --screenshot view.png      the same as a file\n"
               "  viewer 6 --compare schlick          exact Fresnel against Schlick's approximation\n"
               "  viewer 6 --tracer 'build/release/bin/exercise06'\n"
               "  viewer 6 --export out               the tree for ParaView, Blender and a browser\n"
               "  viewer 6 --script 'pick 320 240; step 5; state out.json; shot out.png'\n"
               "Commands of a script:\n" +
               scriptHelp() +
               "Keys: press h in the window. Exit codes: 0 done, 2 bad input or usage, 3 no display that can draw.");
    return runMain(app, argc, argv, [&] { return view(options); });
}

} // namespace rt::viz
