#include "lessons/entries.h"

#include "trace.h"

namespace rt::lesson02
{

namespace
{
struct Lesson
{
    static constexpr int number = 2;
    template <class Real, class Recorder>
    using Tracer = lesson02::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{
    .number = 2,
    .slug = "02_mirrors",
    .title = "mirrors",
    .slides = "Reflected Vector; Light Transport; Whitted-style Ray Tracing, Pseudocode",
    .source = "lessons/02_mirrors/trace.h",
    .scene = "lessons/02_mirrors/scenes/pure_specular.toml",
    .models = {Feature::direct, Feature::mirror},
    .render = renderLesson<Lesson>,
    .inspect = inspectLesson<Lesson>,
};

} // namespace rt::lesson02
