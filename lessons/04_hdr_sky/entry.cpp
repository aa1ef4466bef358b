#include "lessons/entries.h"

#include "trace.h"

namespace rt::lesson04
{

namespace
{
struct Lesson
{
    static constexpr int number = 4;
    template <class Real, class Recorder>
    using Tracer = lesson04::Tracer<Real, Recorder>;
};
} // namespace

const LessonEntry entry{
    .number = 4,
    .slug = "04_hdr_sky",
    .title = "HDR sky",
    .slides = "Reflecting a HDR Sky",
    .source = "lessons/04_hdr_sky/trace.h",
    .scene = "lessons/04_hdr_sky/scenes/bowling_ball.toml",
    .models = {Feature::direct, Feature::mirror, Feature::partial, Feature::sky},
    .render = renderLesson<Lesson>,
    .inspect = inspectLesson<Lesson>,
};

} // namespace rt::lesson04
