#include "lessons/entries.h"

#include "trace.h"

namespace rt::lesson07
{

namespace
{
struct Lesson
{
    static constexpr int number = 7;
    template <class Real, class Recorder>
    using Tracer = lesson07::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{
    .number = 7,
    .slug = "07_recursion_caps",
    .title = "recursion caps",
    .slides = "Ray Tree; Cap recursion",
    .source = "lessons/07_recursion_caps/trace.h",
    .scene = "lessons/07_recursion_caps/scenes/mirror_box.toml",
    .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky, Feature::refraction, Feature::fresnel,
               Feature::policies},
    .render = renderLesson<Lesson>,
    .inspect = inspectLesson<Lesson>,
};

} // namespace rt::lesson07
