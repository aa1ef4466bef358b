#include "viz/state/scene_watch.h"

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

namespace rt::viz
{

namespace
{

namespace fs = std::filesystem;

/// What changes with a file; of a file that is not there, nothing.
using Mark = std::pair<fs::file_time_type, std::uintmax_t>;

Mark markOf(const fs::path& file)
{
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    if (error) return {};
    return {time, fs::file_size(file, error)};
}

std::vector<fs::path> filesOf(const SceneDescription& scene)
{
    std::vector<fs::path> files{scene.file};
    const auto folder = files[0].parent_path();
    for (const auto& mesh : scene.meshes) files.push_back(folder / mesh.file);
    if (!scene.sky.imageFile.empty()) files.push_back(folder / scene.sky.imageFile);
    return files;
}

struct Watch
{
    std::vector<fs::path> files;
    std::vector<Mark> marks;

    explicit Watch(const SceneDescription& scene) : files(filesOf(scene)), marks(look()) {}

    std::vector<Mark> look() const
    {
        std::vector<Mark> now;
        for (const auto& file : files) now.push_back(markOf(file));
        return now;
    }
};

} // namespace

std::function<std::optional<SceneDescription>()> watchScene(const SceneDescription& scene,
                                                            const std::function<SceneDescription()>& load)
{
    return [watch = std::make_shared<Watch>(scene), load]() -> std::optional<SceneDescription> {
        auto now = watch->look();
        if (now == watch->marks) return std::nullopt;
        watch->marks = std::move(now); // before it is read: what is written meanwhile is noticed the next time
        SceneDescription changed = load();
        if (filesOf(changed) != watch->files) *watch = Watch(changed);
        return changed;
    };
}

} // namespace rt::viz
