#include "lessons/programs/registry.h"

#include "lessons/programs/entries.h"

namespace rt
{

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
    const auto* facts = smallestFacts(scene);
    return facts ? findLesson(facts->number) : nullptr;
}

} // namespace rt
