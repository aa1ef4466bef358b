#include "lessons/entries.h"

#include "trace.h"

namespace rt::lesson06
{

namespace
{
struct Lesson
{
    static constexpr int number = 6;
    template <class Real, class Recorder>
    using Tracer = lesson06::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{
    .number = 6,
    .slug = "06_fresnel",
    .title = "Fresnel",
    .slides = "Dielectrics: Fresnel, Schlick, conservation of energy",
    .source = "lessons/06_fresnel/trace.h",
    .scene = "lessons/06_fresnel/scenes/half_and_glass.toml",
    .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky, Feature::refraction, Feature::fresnel},
    .render = renderLesson<Lesson>,
    .inspect = inspectLesson<Lesson>,
};

} // namespace rt::lesson06
