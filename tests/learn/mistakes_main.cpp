// What known mistakes answer to the public cases, as files for `learn` and for hand-outs: grade_mistakes DIR
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "common/files/text_file.h"
#include "common/program/guarded_main.h"
#include "tests/grade/questions/manifest.h"
#include "tests/grade/questions/mistakes.h"

namespace
{

int run(int argc, char** argv)
{
    if (argc != 2)
    {
        std::cerr << "usage: grade_mistakes DIR\n";
        return 2;
    }
    std::filesystem::create_directories(argv[1]);
    for (const int lesson : rt::grade::exerciseLessons())
        rt::writeTextFile(fmt::format("{}/{:02}.json", argv[1], lesson), rt::grade::mistakesJson(lesson));
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    return rt::guarded(argv, [&] { return run(argc, argv); });
}
