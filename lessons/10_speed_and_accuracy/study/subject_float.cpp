#include "subject_of.h"

namespace rt::lesson10
{

std::unique_ptr<Subject> floatSubject(const SceneDescription& scene, const Setting& setting)
{
    return subjectOf<float, Haines<double>>(scene, setting);
}

} // namespace rt::lesson10
