// Known mistakes of lesson 00: each is caught, and by the cases of its own exercise only.
#include <set>

#include <gtest/gtest.h>

#include "lessons/00_geometry/geometry.h"
#include "tests/lessons/lesson00_mutants.h"

namespace rt::cases
{

namespace
{

using namespace lesson00;
using G = Geometry<double>;
const Functions right = functionsOf<G>();

TEST(Mutants00, AreAllKilledByTheCasesOfTheirExercise)
{
    const auto mutants = geometryMutants();
    for (const auto& mutant : mutants)
    {
        auto subject = geometrySubject<G>();
        mutant.make(subject);
        std::set<std::string> failed;
        for (const auto& which : geometryCases())
            if (!runCase(which, subject).failures.empty()) failed.insert(which.group);
        EXPECT_EQ(failed, std::set<std::string>{mutant.group}) << mutant.group << ": " << mutant.mistake;
    }
    EXPECT_GE(mutants.size(), 50u);
}

TEST(Mutants00, OtherCorrectAnswersPass)
{
    auto subject = geometrySubject<G>();
    subject.implicitForm = [](const V2& P, const V2& Q) {
        const auto line = G::implicitForm(P, Q);
        return Implicit{-3 * line.A, -3 * line.B, -3 * line.C};
    };
    subject.normals2 = [](const Implicit& l) { return std::pair(V2(-l.A, -l.B) / 7.0, V2(l.A, l.B) * 3.0); };
    subject.withUnitNormal = [](const Implicit& l) {
        const auto line = right.withUnitNormal(l);
        return Implicit{-line.A, -line.B, -line.C};
    };
    subject.parametricForm = [](const V3& P, const V3& Q) { return Parametric{Q, unit(P - Q)}; };
    subject.normals3 = [](const Parametric& line) {
        const V3 n = right.normals3(line).second;
        return std::pair(-n, unit(n));
    };
    subject.unitNormal = [](const Parametric& line, double angle) { return right.unitNormal(line, 2 - angle); };
    for (const auto& which : geometryCases())
        EXPECT_TRUE(runCase(which, subject).failures.empty()) << which.group << " " << which.name;
}

} // namespace

} // namespace rt::cases
