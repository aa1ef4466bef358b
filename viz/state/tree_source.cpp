#include "viz/state/tree_source.h"

#include <filesystem>

#include <fmt/format.h>

namespace rt::viz
{

FeatureSet allFeatures()
{
    return {Feature::direct,     Feature::mirror,  Feature::partial,  Feature::sky,
            Feature::refraction, Feature::fresnel, Feature::policies, Feature::phong};
}

TreeSource lessonSource(const LessonEntry& lesson, Precision precision)
{
    TreeSource source;
    source.title = fmt::format("{:02}  {}", lesson.number, lesson.title);
    source.models = lesson.models;
    source.render = [&lesson, precision](const SceneDescription& scene, const RenderOptions& options) {
        return lesson.render(scene, precision, options);
    };
    source.inspect = [&lesson, precision](const SceneDescription& scene, const Probe& probe,
                                          const std::atomic<bool>& stop) {
        RayTree tree = lesson.inspect(scene, precision, probe, &stop);
        tree.source = lesson.source;
        return tree;
    };
    return source;
}

TreeSource fileSource(const RayTree& tree, const std::string& file)
{
    TreeSource source;
    source.title = std::filesystem::path(file).filename().string();
    source.models = allFeatures();
    source.isFixed = true;
    source.inspect = [tree](const SceneDescription&, const Probe&, const std::atomic<bool>&) { return tree; };
    return source;
}

TreeSource with(TreeSource source, const std::string& title, const std::function<void(SceneDescription&)>& change)
{
    TreeSource changed = source;
    changed.title = title;
    if (source.render)
        changed.render = [source, change](SceneDescription scene, const RenderOptions& options) {
            change(scene);
            return source.render(scene, options);
        };
    changed.inspect = [source, change](SceneDescription scene, const Probe& probe, const std::atomic<bool>& stop) {
        change(scene);
        return source.inspect(scene, probe, stop);
    };
    return changed;
}

} // namespace rt::viz
