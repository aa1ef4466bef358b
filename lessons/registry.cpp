#include "lessons/registry.h"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "common/scene_file.h"
#include "lessons/entries.h"

namespace rt
{

std::span<const LessonEntry* const> lessons()
{
    static constexpr const LessonEntry* all[] = {&lesson01::entry, &lesson02::entry};
    return all;
}

const LessonEntry* findLesson(int number)
{
    for (const auto* lesson : lessons())
        if (lesson->number == number) return lesson;
    return nullptr;
}

const LessonEntry* smallestLesson(const SceneDescription& scene)
{
    const auto requirements = required(scene);
    for (const auto* lesson : lessons())
        if (missing(requirements, lesson->models).empty()) return lesson;
    return nullptr;
}

std::string lessonThatBrings(Feature feature)
{
    for (const auto* lesson : lessons())
        if (std::find(lesson->models.begin(), lesson->models.end(), feature) != lesson->models.end())
            return fmt::format("lesson {:02} ({})", lesson->number, lesson->title);
    return "a later lesson";
}

void checkModels(const LessonEntry& lesson, const SceneDescription& scene, bool force)
{
    for (const auto& [feature, because] : missing(required(scene), lesson.models))
    {
        const auto what = fmt::format("{}: {}: {} comes with {}; lesson {:02} models {} only", scene.file, because,
                                      name(feature), lessonThatBrings(feature), lesson.number, lesson.title);
        if (!force) throw SceneError(what + " (--force traces what it can)");
        std::cerr << what << "; traced without\n";
    }
}

} // namespace rt
