#include "lessons/entries.h"

#include "trace.h"

namespace rt::lesson08
{

namespace
{
struct Lesson
{
    static constexpr int number = 8;
    template <class Real, class Recorder>
    using Tracer = lesson08::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{
    .number = 8,
    .slug = "08_phong",
    .title = "Phong",
    .slides = "Shading: Diffuse Material, Glossy Material, Phong Shading",
    .source = "lessons/08_phong/trace.h",
    .scene = "lessons/08_phong/scenes/exponents.toml",
    .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky, Feature::refraction, Feature::fresnel,
               Feature::policies, Feature::phong},
    .render = renderLesson<Lesson>,
    .inspect = inspectLesson<Lesson>,
};

} // namespace rt::lesson08
