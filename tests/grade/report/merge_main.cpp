// grade_merge OUT RESULTS...: one gradebook of results that were made apart.
#include <iostream>

#include <fmt/format.h>

#include "common/program/cli.h"
#include "common/program/guarded_main.h"
#include "tests/grade/report/files.h"
#include "tests/grade/report/merge.h"

namespace
{

int run(int argc, char** argv)
{
    using namespace rt;
    CommandLine app("Writes OUT/gradebook.csv, OUT/junit.xml and OUT/class.html of results that were made apart.",
                    "grade_merge");
    std::string out;
    std::vector<std::string> paths;
    app.option("out", out, "folder to write to").required();
    app.option("results", paths, "files results.json, and folders that contain them").required();
    return runMain(app, argc, argv, [&] {
        const auto results = grade::readClass(grade::findResults(paths));
        grade::writeMissingInstructorPages(out, results);
        grade::writeClass(out, results);
        std::cout << fmt::format("{} results: {}/gradebook.csv, {}/junit.xml, {}/class.html\n", results.size(), out,
                                 out, out);
        return int(exitDone);
    });
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
