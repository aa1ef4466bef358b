// What a case tells about a lesson or an exercise. Cases do not stop at the first failure, and they know nothing of
// GoogleTest: the same ones run on lessons, on solved exercises, on mutants, and grade students.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "common/base/vec.h"

namespace rt::cases
{

struct Failure
{
    std::string what; ///< the quantity, as in "R of D = unit(1, -1, 0), N = (0, 1, 0)"
    std::string expected;
    std::string got;
};

inline std::string text(double x)
{
    return fmt::format("{:.9g}", x);
}

inline std::string text(const Vec3<double>& v)
{
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}

class Check
{
public:
    std::vector<Failure> failures;
    int checked = 0; ///< a case that checks nothing is itself an error

    /// |got - expected| <= tolerance * max(1, |expected|); NaN and infinity are never near.
    void near(const std::string& what, double expected, double got, double tolerance)
    {
        ++checked;
        if (!(std::isfinite(got) && std::abs(got - expected) <= tolerance * std::max(1.0, std::abs(expected))))
            failures.push_back({what, text(expected), text(got)});
    }

    template <std::floating_point Real>
    void near(const std::string& what, const Vec3<double>& expected, const Vec3<Real>& got, double tolerance)
    {
        ++checked;
        const Vec3<double> g(got);
        const double scale = std::max({1.0, std::abs(expected.x), std::abs(expected.y), std::abs(expected.z)});
        const Vec3<double> d = abs(g - expected);
        if (!(isFinite(g) && d.x <= tolerance * scale && d.y <= tolerance * scale && d.z <= tolerance * scale))
            failures.push_back({what, text(expected), text(g)});
    }

    template <class Value>
    void equal(const std::string& what, const Value& expected, const Value& got)
    {
        ++checked;
        if (!(expected == got)) failures.push_back({what, fmt::format("{}", expected), fmt::format("{}", got)});
    }

    void that(const std::string& what, bool holds)
    {
        ++checked;
        if (!holds) failures.push_back({what, "true", "false"});
    }
};

/// In the order in which they are tried.
enum class Kind
{
    knownValue,
    property,
    treeShape,
    picture
};

struct Subject;

/// One thing that is true of a lesson, of a solved exercise and, hopefully, of a student's.
struct Case
{
    const char* group; ///< "Reflect": cases of one group are worth points together
    const char* name;  ///< a true sentence in camel case: "KeepsTheAngleToTheNormal"
    const char* slide; ///< heading of the lecture
    Kind kind;
    void (*run)(Check&, const Subject&);
};

} // namespace rt::cases
