// Writes the reports of made-up classes, for report_test.py to look at: OUT/class, OUT/hostile, OUT/empty.
#include <iostream>

#include "common/program/guarded_main.h"
#include "common/program/program.h"
#include "tests/grade/report/files.h"
#include "tests/grade/report/sample_results.h"

namespace rt::grade
{

namespace
{

void writeAll(const std::string& out, const std::vector<SubmissionResult>& results)
{
    for (const auto& result : results) writeReports(out, result);
    writeClass(out, results);
}

/// Students who did more or less, each in an own way.
std::vector<SubmissionResult> sampleCriterion()
{
    std::vector<SubmissionResult> results = {samples::partial("ada"), samples::full("Søren Łukasz-Ó Conchúir"),
                                             samples::notCompiled("charles"), samples::missing("grace")};
    const char* names[] = {"alan", "barbara", "donald", "edsger", "frances", "john", "kathleen", "niklaus", "tony"};
    for (std::size_t i = 0; i < std::size(names); ++i)
    {
        auto result = samples::partial(names[i]);
        for (std::size_t k = 0; k < result.criteria.size(); ++k)
            if ((i * 5 + k * 3) % 7 < i)
            {
                auto& one = result.criteria[k];
                one.passed = one.cases;
                one.points = one.most;
                one.outcome = Outcome::passed;
                one.example.reset();
                one.pictures.reset();
                one.mistake.clear();
            }
        if (i % 3 == 0) result.sandbox = i == 3 ? "none" : "chroot";
        results.push_back(result);
    }
    return results;
}

} // namespace

} // namespace rt::grade

namespace
{

int run(int argc, char** argv)
{
    using namespace rt;
    if (argc != 2)
    {
        std::cerr << "usage: write_reports OUT\n";
        return exitBadInput;
    }
    const std::string out = argv[1];
    grade::writeAll(out + "/class", grade::sampleCriterion());
    grade::writeAll(out + "/hostile", {grade::samples::hostile(), grade::samples::hostileNotCompiled()});
    grade::writeAll(out + "/empty", {});
    return exitDone;
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
