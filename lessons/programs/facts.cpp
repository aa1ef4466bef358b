#include "lessons/programs/facts.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "common/files/scene_file.h"

namespace rt
{

namespace
{

bool models(const LessonFacts& lesson, Feature feature)
{
    return std::find(lesson.models.begin(), lesson.models.end(), feature) != lesson.models.end();
}

} // namespace

std::span<const LessonFacts> lessonFacts()
{
    static const std::vector<LessonFacts> all{
#include "lessons/facts_table.h"
    };
    return all;
}

const LessonFacts& lessonFacts(int number)
{
    for (const auto& lesson : lessonFacts())
        if (lesson.number == number) return lesson;
    throw std::out_of_range(fmt::format("there is no lesson {:02}", number));
}

const LessonFacts* smallestFacts(const SceneDescription& scene)
{
    const auto requirements = required(scene);
    for (const auto& lesson : lessonFacts())
        if (missing(requirements, lesson.models).empty()) return &lesson;
    return nullptr;
}

std::string lessonThatBrings(Feature feature)
{
    for (const auto& lesson : lessonFacts())
        if (models(lesson, feature)) return fmt::format("lesson {:02} ({})", lesson.number, lesson.title);
    return "a later lesson";
}

void checkModels(const LessonFacts& lesson, const SceneDescription& scene, bool force)
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
