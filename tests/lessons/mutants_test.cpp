// Every known mistake must be caught, and a constant must not pass any group of cases.
#include "tests/lessons/mutants.h"

#include <set>

#include <gtest/gtest.h>

#include "lessons/programs/registry.h"
#include "tests/cases/cases.h"
#include "tests/cases/run_cases.h"

namespace rt::cases
{

namespace
{

TEST(Mutants, AreAllKilled)
{
    int killed = 0, all = 0;
    for (const auto* lesson : lessons())
        for (const auto& mutant : mutants(lesson->number))
        {
            std::set<std::string> passed, failed;
            std::string killers;
            int kills = 0;
            for (const auto& which : casesUpTo(lesson->number))
            {
                if (mutant.endless && !failed.empty()) break;
                const bool fails = !runCase(which, mutant.subject).failures.empty();
                (fails ? failed : passed).insert(which.group);
                if (!fails) continue;
                if (++kills <= 2) killers += fmt::format(" {}_{}", which.group, which.name);
            }
            fmt::print("{:32} {:3} cases fail:{}{}\n", mutant.id, kills, killers, kills > 2 ? " ..." : "");
            EXPECT_GT(kills, 0) << mutant.id << " survives: " << mutant.mistake;
            for (const auto& group : mutant.stub)
                EXPECT_TRUE(failed.contains(group)) << mutant.id << " passes " << group;
            ++all;
            killed += kills > 0;
        }
    fmt::print("{} of {} mutants killed\n", killed, all);
    EXPECT_GE(all, 30);
}

} // namespace

} // namespace rt::cases
