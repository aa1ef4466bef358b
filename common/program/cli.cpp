#include "common/program/cli.h"

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <mutex>

#include <fmt/format.h>
#include <unistd.h>

#include "common/base/ray_limit.h"
#include "common/files/picture_module.h"
#include "common/files/scene_file.h"

namespace rt
{

namespace
{

int wholeNumber(const std::string& text, const std::string& option, const char* expected)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw UsageError(option, fmt::format("expected {}, got \"{}\"", expected, text));
    return value;
}

std::array<int, 2> pairOf(const std::string& text, char separator, const std::string& option, const char* expected)
{
    const auto middle = text.find(separator);
    if (middle == std::string::npos) throw UsageError(option, fmt::format("expected {}, got \"{}\"", expected, text));
    return {wholeNumber(text.substr(0, middle), option, expected),
            wholeNumber(text.substr(middle + 1), option, expected)};
}

/// Becomes the front door that started us, if one did: it installs OpenImageIO, builds the module, and starts us again.
void askFrontDoor(int argc, char** argv)
{
    const char* door = std::getenv("RAYTREE_DOOR");
    if (!door) return;
    std::error_code error;
    std::string self = std::filesystem::read_symlink("/proc/self/exe", error).string();
    std::vector<char*> words{const_cast<char*>(door), const_cast<char*>("pictures"), error ? argv[0] : self.data()};
    words.insert(words.end(), argv + 1, argv + argc);
    words.push_back(nullptr);
    ::execv(door, words.data());
}

} // namespace

const char* name(Precision precision)
{
    constexpr const char* names[] = {"float", "double", "long-double"};
    return names[int(precision)];
}

Precision TraceOptions::precision() const
{
    return real == "float" ? Precision::floating : real == "double" ? Precision::doubled : Precision::longDouble;
}

void addTraceOptions(CommandLine& app, TraceOptions& options)
{
    app.option("scene", options.scene, "scene file (TOML); default: the lesson's first scene").type("SCENE.toml");
    app.option("--size", options.size, "size of the picture in pixels; default: the scene's").type("WxH");
    app.option("--real", options.real, "scalar type").oneOf({"float", "double", "long-double"}).showsDefault();
    app.option("--depth", options.depth,
               fmt::format(
                   "MAXDEPTH: rays of this depth are traced, deeper ones are not; glass doubles their number at each "
                   "depth, and a pixel that leads to more than {} rays is refused",
                   rayLimitText))
        .range(0, deepestTrace)
        .type("N");
    app.option("--fresnel", options.fresnel, "how glass splits light; default: the scene's")
        .oneOf({"exact", "schlick", "none"});
    app.option("--spp", options.spp, "samples per pixel").range(1, 65536).type("N").showsDefault();
    app.option("--threads", options.threads, "threads; default: one a core").range(1, 1024).type("N");
    const auto pixel =
        app.option("--pixel", options.pixel, "the ray tree of this pixel: x to the right, y down").type("x,y");
    app.option("--ray", options.ray, "the ray tree of one ray in world space")
        .type("ox,oy,oz,dx,dy,dz")
        .excludes(pixel);
}

std::vector<double> numbers(const std::string& text, std::size_t count, const std::string& option)
{
    std::vector<double> values;
    const auto wrong = [&] {
        return UsageError(option,
                          fmt::format("expected {} finite numbers separated by commas, got \"{}\"", count, text));
    };
    const char *at = text.data(), *end = at + text.size();
    while (true)
    {
        double value = 0;
        if (at != end && *at == '+') ++at;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || !std::isfinite(value)) throw wrong();
        values.push_back(value);
        if (next == end) break;
        if (*next != ',') throw wrong();
        at = next + 1;
    }
    if (values.size() != count) throw wrong();
    return values;
}

SceneDescription loadScene(const TraceOptions& options)
{
    SceneDescription scene = loadScene(options.scene);
    for (const auto& warning : scene.warnings) std::cerr << warning << '\n';
    if (!options.size.empty())
    {
        const auto [width, height] = pairOf(options.size, 'x', "--size", "WxH, as in 640x480");
        if (width < 1 || height < 1 || width > largestSide || height > largestSide ||
            width * std::int64_t(height) > mostPixels)
            throw UsageError("--size", "each side is 1 to 65536 pixels, and there are at most 2^28 pixels");
        auto& camera = scene.camera;
        if (camera.pixelX >= 0) camera.pixelX = int(std::int64_t(camera.pixelX) * width / camera.width);
        if (camera.pixelY >= 0) camera.pixelY = int(std::int64_t(camera.pixelY) * height / camera.height);
        camera.width = width;
        camera.height = height;
    }
    if (options.depth >= 0) scene.trace.maxDepth = options.depth;
    if (options.fresnel == "exact") scene.trace.fresnel = FresnelModel::exact;
    if (options.fresnel == "schlick") scene.trace.fresnel = FresnelModel::schlick;
    if (options.fresnel == "none") scene.trace.fresnel = FresnelModel::none;
    return scene;
}

Probe probe(const TraceOptions& options, const SceneDescription& scene)
{
    if (!options.ray.empty())
    {
        const auto v = numbers(options.ray, 6, "--ray");
        const GivenRay ray{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
        if (ray.direction == Vec3<double>(0)) throw UsageError("--ray", "the direction must not be zero");
        return ray;
    }
    if (options.pixel.empty()) return scene.pixel();
    const auto pixel = pairOf(options.pixel, ',', "--pixel", "x,y, as in 320,240");
    if (pixel[0] < 0 || pixel[1] < 0 || pixel[0] >= scene.camera.width || pixel[1] >= scene.camera.height)
        throw UsageError("--pixel", fmt::format("{},{} is outside the picture of {}x{} pixels", pixel[0], pixel[1],
                                                scene.camera.width, scene.camera.height));
    return pixel;
}

int runMain(CommandLine& app, int argc, char** argv, const std::function<int()>& work)
{
    endAtInterrupt();
    try
    {
        return app.parse(argc, argv) ? work() : int(exitDone);
    }
    catch (const Stopped&)
    {
        return sayInterrupted();
    }
    catch (const std::bad_alloc&)
    {
        std::cerr << app.program() << ": out of memory\n";
    }
    catch (const SceneError& error)
    {
        std::cerr << error.what() << '\n';
    }
    catch (const UsageError& error)
    {
        std::cerr << app.program() << ": " << error.what() << " (see --help)\n";
    }
    catch (const NeedsOpenImageIO& error)
    {
        std::cerr << error.what() << '\n';
        askFrontDoor(argc, argv);
        return exitNeedsOpenImageIO;
    }
    catch (const std::exception& error)
    {
        std::cerr << app.program() << ": " << error.what() << '\n';
    }
    return exitBadInput;
}

std::function<void(double)> progressBar(const std::string& title)
{
    if (!isatty(STDERR_FILENO)) return {};
    struct State
    {
        std::mutex mutex;
        std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
        int shown = -1;
    };
    return [title, state = std::make_shared<State>()](double share) {
        const std::lock_guard lock(state->mutex);
        const auto elapsed = std::chrono::steady_clock::now() - state->start;
        const int percent = int(share * 100);
        if (percent <= state->shown || (elapsed < std::chrono::milliseconds(500) && state->shown < 0)) return;
        state->shown = percent;
        const auto filled = std::size_t(percent * 40 / 100);
        std::cerr << fmt::format("\r{} [{}{}] {:3}%{}", title, std::string(filled, '#'), std::string(40 - filled, ' '),
                                 percent, percent == 100 ? "\n" : "")
                  << std::flush;
    };
}

std::string projectFile(const std::string& relative)
{
    return std::string(RAYTREE_SOURCE_DIR) + "/" + relative;
}

} // namespace rt
