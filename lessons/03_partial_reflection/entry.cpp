#include "lessons/entries.h"

#include "trace.h"

namespace rt::lesson03
{

namespace
{
struct Lesson
{
    static constexpr int number = 3;
    template <class Real, class Recorder>
    using Tracer = lesson03::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{
    .number = 3,
    .slug = "03_partial_reflection",
    .title = "partial reflection",
    .slides = "Partially Reflective Surfaces",
    .source = "lessons/03_partial_reflection/trace.h",
    .scene = "lessons/03_partial_reflection/scenes/half_specular.toml",
    .models = {Feature::direct, Feature::mirror, Feature::partial},
    .render = renderLesson<Lesson>,
    .inspect = inspectLesson<Lesson>,
};

} // namespace rt::lesson03
