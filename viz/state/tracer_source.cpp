#include "viz/state/tracer_source.h"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "common/base/interrupt.h"
#include "common/files/picture_file.h"
#include "common/program/process.h"

namespace rt::viz
{

namespace
{

using Words = std::vector<std::string>;

/// A folder of its own that goes away with everything in it.
class ScratchFolder
{
public:
    ScratchFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "raytree-XXXXXX").string();
        if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder could be made");
        path = pattern;
    }
    ~ScratchFolder() { remove(); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path path;

private:
    void remove() const
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }

    UndoAtInterrupt undo{[this] { remove(); }};
};

Words sceneWords(const SceneDescription& scene)
{
    return {scene.file,
            "--size",
            fmt::format("{}x{}", scene.camera.width, scene.camera.height),
            "--depth",
            std::to_string(scene.trace.maxDepth),
            "--fresnel",
            scene.trace.fresnel == FresnelModel::schlick ? "schlick"
            : scene.trace.fresnel == FresnelModel::none  ? "none"
                                                         : "exact"};
}

Words probeWords(const Probe& probe)
{
    if (const auto* pixel = std::get_if<std::array<int, 2>>(&probe))
        return {"--pixel", fmt::format("{},{}", (*pixel)[0], (*pixel)[1])};
    const auto& [o, d] = std::get<GivenRay>(probe);
    return {"--ray", fmt::format("{},{},{},{},{},{}", o.x, o.y, o.z, d.x, d.y, d.z)};
}

Words operator+(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::string run(const std::string& title, const Words& words, const ProcessLimits& limits)
{
    const auto result = runProcess(words, limits);
    if (result.stopped) return "";
    if (!result.ok()) throw std::runtime_error(describeFailure(title, result));
    return result.out;
}

} // namespace

TreeSource tracerSource(const std::string& command, double seconds)
{
    const Words program = splitCommand(command);
    if (program.empty()) throw std::runtime_error("the tracer's command is empty");
    TreeSource source;
    source.title = std::filesystem::path(program[0]).filename().string();
    source.models = allFeatures();
    source.isSlow = true;
    source.inspect = [=, title = source.title](const SceneDescription& scene, const Probe& probe,
                                               const std::atomic<bool>& stop) {
        ProcessLimits limits;
        limits.seconds = seconds;
        limits.stop = &stop;
        const auto json = run(title, program + sceneWords(scene) + probeWords(probe) + Words{"--tree", "json"}, limits);
        if (stop) return RayTree();
        try
        {
            return rayTreeFromJson(json);
        }
        catch (const std::exception& error)
        {
            throw std::runtime_error(fmt::format("{} wrote no ray tree: {}", title, error.what()));
        }
    };
    source.render = [=, title = source.title](const SceneDescription& scene, const RenderOptions& options) {
        const ScratchFolder folder;
        const auto file = (folder.path / "picture.exr").string();
        ProcessLimits limits;
        limits.seconds = 10 * seconds;
        limits.stop = options.stop;
        run(title, program + sceneWords(scene) + Words{"--out", file}, limits);
        if (options.stop && *options.stop) return Image();
        if (!std::filesystem::exists(file)) return Image(); // it traces, but does not paint
        Image image = readImage(file);
        if (image.width != scene.camera.width || image.height != scene.camera.height)
            throw std::runtime_error(fmt::format("{} made a picture of {} x {} pixels, expected {} x {}", title,
                                                 image.width, image.height, scene.camera.width, scene.camera.height));
        return image;
    };
    return source;
}

} // namespace rt::viz
