// The one thing that is compiled for each submission: RAYTREE_LESSON is its number, without a leading zero.
#include "tests/grade/wire/student.h"

#include "exercise.h"

#define RAYTREE_JOIN(a, b) a##b
#define RAYTREE_EXERCISE(number) RAYTREE_JOIN(exercise0, number)

rt::grade::Student rt::grade::makeStudent()
{
#if RAYTREE_LESSON == 0
    return {{}, cases::geometrySubject<RAYTREE_EXERCISE(RAYTREE_LESSON)::Geometry>()};
#else
    return {cases::exerciseSubject<RAYTREE_EXERCISE(RAYTREE_LESSON)::Tracer>(), {}};
#endif
}
