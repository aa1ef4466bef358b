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
        {
            .number = 1,
            .slug = "01_direct_illumination",
            .title = "direct illumination",
            .slides = "Whitted-style Ray Tracing, Pseudocode",
            .source = "lessons/01_direct_illumination/trace.h",
            .scene = "lessons/01_direct_illumination/scenes/diffuse_spheres.toml",
            .models = {Feature::direct},
        },
        {
            .number = 2,
            .slug = "02_mirrors",
            .title = "mirrors",
            .slides = "Reflected Vector; Light Transport; Whitted-style Ray Tracing, Pseudocode",
            .source = "lessons/02_mirrors/trace.h",
            .scene = "lessons/02_mirrors/scenes/pure_specular.toml",
            .models = {Feature::direct, Feature::mirror},
        },
        {
            .number = 3,
            .slug = "03_partial_reflection",
            .title = "partial reflection",
            .slides = "Partially Reflective Surfaces",
            .source = "lessons/03_partial_reflection/trace.h",
            .scene = "lessons/03_partial_reflection/scenes/half_specular.toml",
            .models = {Feature::direct, Feature::mirror, Feature::partial},
        },
        {
            .number = 4,
            .slug = "04_hdr_sky",
            .title = "HDR sky",
            .slides = "Reflecting a HDR Sky",
            .source = "lessons/04_hdr_sky/trace.h",
            .scene = "lessons/04_hdr_sky/scenes/bowling_ball.toml",
            .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky},
        },
        {
            .number = 5,
            .slug = "05_refraction",
            .title = "refraction",
            .slides = "Dielectrics: Snell, critical angle, transmitted vector",
            .source = "lessons/05_refraction/trace.h",
            .scene = "lessons/05_refraction/scenes/glass_ball.toml",
            .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky, Feature::refraction},
        },
        {
            .number = 6,
            .slug = "06_fresnel",
            .title = "Fresnel",
            .slides = "Dielectrics: Fresnel, Schlick, conservation of energy",
            .source = "lessons/06_fresnel/trace.h",
            .scene = "lessons/06_fresnel/scenes/half_and_glass.toml",
            .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky, Feature::refraction,
                       Feature::fresnel},
        },
        {
            .number = 7,
            .slug = "07_recursion_caps",
            .title = "recursion caps",
            .slides = "Ray Tree; Cap recursion",
            .source = "lessons/07_recursion_caps/trace.h",
            .scene = "lessons/07_recursion_caps/scenes/mirror_box.toml",
            .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky, Feature::refraction,
                       Feature::fresnel, Feature::policies},
        },
        {
            .number = 8,
            .slug = "08_phong",
            .title = "Phong",
            .slides = "Shading: Diffuse Material, Glossy Material, Phong Shading",
            .source = "lessons/08_phong/trace.h",
            .scene = "lessons/08_phong/scenes/exponents.toml",
            .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky, Feature::refraction,
                       Feature::fresnel, Feature::policies, Feature::phong},
        },
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
