#include "modelling.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "common/program/program.h"
#include "lessons/list.h"
#include "lessons/programs/registry.h"
#include "lessons/traces.h"

namespace rt::lesson10
{

namespace
{

/// A hit is a local variable of `trace`: how far apart are those of neighbouring depths?
struct StackRecorder : NoRecorder
{
    std::vector<const char*>* places;
    std::size_t* most;

    void ray(const Ray<double>& ray, const std::optional<Hit<double>>& hit)
    {
        const auto depth = std::size_t(ray.depth);
        places->resize(std::max(places->size(), depth + 1));
        (*places)[depth] = reinterpret_cast<const char*>(&hit);
        if (depth > 0) *most = std::max(*most, std::size_t((*places)[depth - 1] - (*places)[depth]));
    }
};

template <template <class, class> class Tracer>
std::size_t stackOf(const SceneDescription& description)
{
    const Scene<double> scene(description);
    std::vector<const char*> places;
    std::size_t most = 0;
    StackRecorder recorder;
    recorder.places = &places;
    recorder.most = &most;
    const TraceLimit limit(nullptr);
    Tracer<double, StackRecorder> tracer{scene, recorder};
    for (int y = 0; y < description.camera.height; y += 4)
        for (int x = 0; x < description.camera.width; x += 4) try
            {
                beginCameraRay();
                tracer.trace(scene.camera.ray(x, y));
            }
            catch (const TooManyRays&)
            {
                throw TooManyRays(pixelText(x, y), description.trace.maxDepth);
            }
    return most;
}

Pass timed(const LessonEntry& lesson, const SceneDescription& scene, const std::atomic<bool>& stop)
{
    Pass pass;
    const double start = threadSeconds();
    pass.image = lesson.render(scene, Precision::doubled, {.threads = 1, .progress = {}, .stop = &stop});
    pass.cpuSeconds = threadSeconds() - start;
    return pass;
}

} // namespace

std::vector<std::string> shippedScenes()
{
    namespace fs = std::filesystem;
    std::vector<std::string> files;
    const fs::path root = projectFile("");
    for (const auto& lesson : fs::directory_iterator(root / "lessons"))
        if (fs::is_directory(lesson.path() / "scenes"))
            for (const auto& file : fs::directory_iterator(lesson.path() / "scenes"))
                if (file.path().extension() == ".toml") files.push_back(fs::relative(file.path(), root).string());
    std::sort(files.begin(), files.end());
    return files;
}

std::size_t stackALevel(int lesson, const SceneDescription& scene)
{
#define RAYTREE_MEASURE(number, NN)                                                                                    \
    if (lesson == number) return stackOf<lesson##NN::Tracer>(scene);
    RAYTREE_FOR_EACH_LESSON(RAYTREE_MEASURE)
#undef RAYTREE_MEASURE
    throw std::out_of_range("no such lesson");
}

std::optional<ModelledScene> model(const SceneDescription& scene, bool ladder, int rounds, double seconds,
                                   const std::atomic<bool>& stop)
{
    ModelledScene result{.scene = scene.file, .width = scene.camera.width, .height = scene.camera.height};
    const auto* smallest = smallestLesson(scene);
    if (!smallest) return result;
    std::vector<const LessonEntry*> entries;
    for (const auto* lesson : lessons())
        if (lesson == smallest || (lesson->number > smallest->number && (ladder || lesson == lessons().back())))
            entries.push_back(lesson);
    std::vector<Image> images(entries.size());
    for (const auto* lesson : entries)
        result.lessons.push_back({.lesson = lesson->number,
                                  .cpuSeconds = infinity<double>,
                                  .bytesALevel = stackALevel(lesson->number, scene)});

    const auto start = std::chrono::steady_clock::now();
    const auto spent = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
    for (int round = 0; round < rounds && (round < 3 || spent() < seconds); ++round)
        for (std::size_t i = 0; i < entries.size(); ++i)
        {
            if (stop) return std::nullopt;
            const std::size_t turn = (i + std::size_t(round)) % entries.size(); // nobody always comes first
            Pass pass = timed(*entries[turn], scene, stop);
            result.lessons[turn].cpuSeconds = std::min(result.lessons[turn].cpuSeconds, pass.cpuSeconds);
            images[turn] = std::move(pass.image);
        }
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
        result.lessons[i].ratio = result.lessons[i].cpuSeconds / result.lessons[0].cpuSeconds;
        result.lessons[i].sameBits = images[i].pixels == images[0].pixels;
    }
    return result;
}

} // namespace rt::lesson10
