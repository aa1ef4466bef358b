// Runs cases under GoogleTest: one test for each case and subject.
#pragma once

#include <gtest/gtest.h>

#include "common/todo.h"
#include "tests/lessons/check.h"

namespace rt::cases
{

/// Runs one case; a case that throws anything but NotAttempted has failed.
template <class Subject>
Check runCase(const Case<Subject>& which)
{
    Check check;
    try
    {
        which.run(check);
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

template <class Subject>
class CaseTest : public testing::Test
{
public:
    explicit CaseTest(const Case<Subject>& one) : which(one) {}

    void TestBody() override
    {
        const Check check = runCase(which);
        EXPECT_GT(check.checked, 0) << "the case checks nothing";
        for (const auto& failure : check.failures)
            ADD_FAILURE() << "Slide: " << which.slide << "\n  " << failure.what << "\n  expected " << failure.expected
                          << "\n  got      " << failure.got;
    }

private:
    Case<Subject> which;
};

/// Registers the cases as GoogleTest tests "subject.Group_Name".
template <class Subject>
void registerCases(const std::string& subject, const std::vector<Case<Subject>>& cases)
{
    for (const auto& which : cases)
        testing::RegisterTest(subject.c_str(), fmt::format("{}_{}", which.group, which.name).c_str(), nullptr, nullptr, __FILE__,
                              __LINE__, [which]() -> testing::Test* { return new CaseTest<Subject>(which); });
}

} // namespace rt::cases
