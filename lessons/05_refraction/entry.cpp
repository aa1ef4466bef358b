#include "lessons/entries.h"

#include "trace.h"

namespace rt::lesson05
{

namespace
{
struct Lesson
{
    static constexpr int number = 5;
    template <class Real, class Recorder>
    using Tracer = lesson05::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{
    .number = 5,
    .slug = "05_refraction",
    .title = "refraction",
    .slides = "Dielectrics: Snell, critical angle, transmitted vector",
    .source = "lessons/05_refraction/trace.h",
    .scene = "lessons/05_refraction/scenes/glass_ball.toml",
    .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky, Feature::refraction},
    .render = renderLesson<Lesson>,
    .inspect = inspectLesson<Lesson>,
};

} // namespace rt::lesson05
