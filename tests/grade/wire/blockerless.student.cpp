// For the tests: exercise 01, solved, in a kit whose shapes.h has lost its formulas. Its recorder finds no blockers.
#include "solved01.h"
#include "tests/grade/wire/student.h"

rt::grade::Student rt::grade::makeStudent()
{
    Student student{cases::exerciseSubject<solved01::Tracer>(), {}};
    student.tracer.tree = [full = student.tracer.tree](const SceneDescription& scene, const cases::V& origin,
                                                       const cases::V& direction) {
        RayTree tree = full(scene, origin, direction);
        for (auto& shadow : tree.shadows) shadow.blocker.reset();
        return tree;
    };
    return student;
}
