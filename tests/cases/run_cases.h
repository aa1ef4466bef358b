// Runs cases under GoogleTest: one test for each case and subject.
#pragma once

#include <gtest/gtest.h>

#include "common/base/todo.h"
#include "tests/cases/cases.h"

namespace rt::cases
{

/// Runs one case; a case that throws anything but NotAttempted has failed.
inline Check runCase(const Case& which, const Subject& subject)
{
    Check check;
    try
    {
        which.run(check, subject);
    }
    catch (const NotAttempted&)
    {
        throw;
    }
    catch (const std::exception& error)
    {
        check.failures.push_back({"the case ran", "to its end", error.what()});
    }
    return check;
}

class CaseTest : public testing::Test
{
public:
    CaseTest(const Case& one, const Subject& of) : which(one), subject(of) {}

    void TestBody() override
    {
        const Check check = runCase(which, subject);
        EXPECT_GT(check.checked, 0) << "the case checks nothing";
        for (const auto& failure : check.failures)
            ADD_FAILURE() << "Slide: " << which.slide << "\n  " << failure.what << "\n  expected " << failure.expected
                          << "\n  got      " << failure.got;
    }

private:
    Case which;
    Subject subject;
};

/// Registers the cases as GoogleTest tests "suite.Group_Name".
inline void registerCases(const std::string& suite, const Subject& subject, const std::vector<Case>& cases)
{
    for (const auto& which : cases)
        testing::RegisterTest(suite.c_str(), fmt::format("{}_{}", which.group, which.name).c_str(), nullptr, nullptr,
                              __FILE__, __LINE__,
                              [which, subject]() -> testing::Test* { return new CaseTest(which, subject); });
}

/// Registers all that must hold for a lesson, on the lesson in float and double and on its solved exercise.
template <class Lesson, class Solved>
bool registerLesson(const std::string& number)
{
    const auto cases = casesUpTo(Lesson::number);
    registerCases("Lesson" + number + "Float", lessonSubject<Lesson, float>(), cases);
    registerCases("Lesson" + number + "Double", lessonSubject<Lesson, double>(), cases);
    registerCases("Solved" + number, exerciseSubject<Solved>(), cases);
    return true;
}

} // namespace rt::cases
