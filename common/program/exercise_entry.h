// The entry of an exercise program: the same options as the lesson's.
#pragma once

#include "common/program/lesson_entry.h"
#include "common/tree/explain.h"

namespace rt
{

/// An entry with the lesson's facts and the student's tracer.
template <int number, class Tracer>
LessonEntry exerciseEntry(const LessonFacts& lesson, const char* source)
{
    LessonEntry entry{lesson, renderExercise<Tracer>, inspectExercise<number, Tracer>};
    entry.source = source;
    return entry;
}

/// The student's own formulas, for explanations: N.L where there is no phong yet. They may throw NotAttempted.
template <class Tracer>
LectureFormulas exerciseFormulas()
{
    LectureFormulas formulas{};
    formulas.phong = [](const Vec3<double>& L, const Vec3<double>& N, const Vec3<double>&, const Material<double>&) {
        return std::max(0.0, dot(N, L));
    };
    if constexpr (requires { &Tracer::cosSquared2; }) formulas.cosSquared2 = Tracer::cosSquared2;
    if constexpr (requires { &Tracer::fresnel; }) formulas.fresnel = Tracer::fresnel;
    if constexpr (requires { &Tracer::schlick; }) formulas.schlick = Tracer::schlick;
    if constexpr (requires { &Tracer::phong; }) formulas.phong = Tracer::phong;
    return formulas;
}

} // namespace rt
