#include "lessons/registry.h"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "common/scene_file.h"
#include "lessons/entries.h"

namespace rt
{

namespace
{

bool models(const LessonEntry& lesson, Feature feature)
{
    return std::find(lesson.models.begin(), lesson.models.end(), feature) != lesson.models.end();
}

} // namespace

std::span<const LessonEntry* const> lessons()
{
    static constexpr const LessonEntry* all[] = {&lesson01::entry, &lesson02::entry, &lesson03::entry,
                                                 &lesson04::entry, &lesson05::entry, &lesson06::entry,
                                                 &lesson07::entry, &lesson08::entry};
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
        if (models(*lesson, feature)) return fmt::format("lesson {:02} ({})", lesson->number, lesson->title);
    return "a later lesson";
}

void checkModels(const LessonEntry& lesson, const SceneDescription& scene, bool force)
{
    for (const auto& [feature, because] : missing(required(scene), lesson.models))
    {
        // A glass ball in lesson 05 is glass as far as it has been taught: worth a word, not a refusal.
        if (feature == Feature::fresnel && models(lesson, Feature::refraction))
        {
            std::cerr << fmt::format("{}: lesson {:02} transmits all that it can; the reflected share comes with {}\n",
                                     scene.file, lesson.number, lessonThatBrings(feature));
            continue;
        }
        const auto what = fmt::format("{}: {}: {} comes with {}; lesson {:02} models {} only", scene.file, because,
                                      name(feature), lessonThatBrings(feature), lesson.number, lesson.title);
        if (!force) throw SceneError(what + " (--force traces what it can)");
        std::cerr << what << "; traced without\n";
    }
}

} // namespace rt
