#include "subject_of.h"

namespace rt::lesson10
{

std::unique_ptr<Subject> floatOnlySubject(const SceneDescription& scene, const Setting& setting)
{
    return subjectOf<float, Haines<float>>(scene, setting);
}

} // namespace rt::lesson10
