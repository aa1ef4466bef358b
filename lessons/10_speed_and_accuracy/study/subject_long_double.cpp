#include "subject_of.h"

namespace rt::lesson10
{

std::unique_ptr<Subject> longDoubleSubject(const SceneDescription& scene, const Setting& setting)
{
    return subjectOf<long double, Haines<long double>>(scene, setting);
}

} // namespace rt::lesson10
