#include "lessons/programs/formulas.h"

#include "lessons/08_phong/trace.h"

namespace rt
{

const LectureFormulas& lectureFormulas()
{
    using Lesson = lesson08::Tracer<double>; // its functions of lesson 06 have the same text
    static constexpr LectureFormulas formulas{Lesson::cosSquared2, Lesson::fresnel, Lesson::schlick, Lesson::phong};
    return formulas;
}

} // namespace rt
