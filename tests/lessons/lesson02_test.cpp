#include "lessons/02_mirrors/trace.h"
#include "solved02.h"
#include "tests/lessons/cases_direct.h"
#include "tests/lessons/cases_mirror.h"
#include "tests/lessons/run_cases.h"

namespace rt::cases
{

namespace
{

struct Lesson
{
    template <class Real, class Recorder>
    using Tracer = lesson02::Tracer<Real, Recorder>;
};

template <class Subject>
void registerAll(const char* subject)
{
    registerCases<Subject>(subject, directCases<Subject>());
    registerCases<Subject>(subject, mirrorCases<Subject>());
}

[[maybe_unused]] const bool registered = [] {
    registerAll<LessonSubject<Lesson, float>>("Lesson02Float");
    registerAll<LessonSubject<Lesson, double>>("Lesson02Double");
    registerAll<ExerciseSubject<solved02::Tracer>>("Solved02");
    return true;
}();

} // namespace

} // namespace rt::cases
