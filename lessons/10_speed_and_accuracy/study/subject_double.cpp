#include "subject_of.h"

namespace rt::lesson10
{

std::unique_ptr<Subject> doubleSubject(const SceneDescription& scene, const Setting& setting)
{
    return subjectOf<double, Haines<double>>(scene, setting);
}

} // namespace rt::lesson10
