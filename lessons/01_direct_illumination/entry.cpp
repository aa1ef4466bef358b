#include "lessons/entries.h"

#include "trace.h"

namespace rt::lesson01
{

namespace
{
struct Lesson
{
    static constexpr int number = 1;
    template <class Real, class Recorder>
    using Tracer = lesson01::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{
    .number = 1,
    .slug = "01_direct_illumination",
    .title = "direct illumination",
    .slides = "Whitted-style Ray Tracing, Pseudocode",
    .source = "lessons/01_direct_illumination/trace.h",
    .scene = "lessons/01_direct_illumination/scenes/diffuse_spheres.toml",
    .models = {Feature::direct},
    .render = renderLesson<Lesson>,
    .inspect = inspectLesson<Lesson>,
};

} // namespace rt::lesson01
