#include "lessons/01_direct_illumination/trace.h"
#include "solved01.h"
#include "tests/lessons/cases_direct.h"
#include "tests/lessons/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    template <class Real, class Recorder>
    using Tracer = lesson01::Tracer<Real, Recorder>;
};

template <class Subject>
void registerAll(const char* subject)
{
    registerCases<Subject>(subject, directCases<Subject>());
}

[[maybe_unused]] const bool registered = [] {
    registerAll<LessonSubject<Lesson, float>>("Lesson01Float");
    registerAll<LessonSubject<Lesson, double>>("Lesson01Double");
    registerAll<ExerciseSubject<solved01::Tracer>>("Solved01");
    return true;
}();

} // namespace

} // namespace rt::cases
