#include "subject.h"

#include <ctime>

#include "subject_of.h"

namespace rt::lesson10
{

std::unique_ptr<Subject> prepare(const SceneDescription& scene, const Setting& setting)
{
    switch (setting.scalar)
    {
    case Scalar::floatOnly:
        return floatOnlySubject(scene, setting);
    case Scalar::floating:
        return floatSubject(scene, setting);
    case Scalar::doubled:
        return doubleSubject(scene, setting);
    case Scalar::longDouble:
        break;
    }
    return longDoubleSubject(scene, setting);
}

double threadSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

} // namespace rt::lesson10
