#include "lessons/programs/registry.h"

#include "lessons/programs/entries.h"

namespace rt
{

std::span<const LessonEntry* const> lessons()
{
#define RAYTREE_ENTRY(number, NN) &lesson##NN::entry,
    static constexpr const LessonEntry* all[] = {RAYTREE_FOR_EACH_LESSON(RAYTREE_ENTRY)};
#undef RAYTREE_ENTRY
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
