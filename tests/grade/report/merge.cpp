#include "tests/grade/report/merge.h"

#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "tests/grade/report/results_json.h"
#include "tests/grade/report/text.h"

namespace rt::grade
{

namespace fs = std::filesystem;

namespace
{

/// What two results of the same submission have in common.
std::string verdict(SubmissionResult result)
{
    result.seconds = result.compileSeconds = 0;
    return resultsJson(result);
}

} // namespace

std::vector<std::string> findResults(const std::vector<std::string>& paths)
{
    std::set<std::string> found;
    for (const auto& path : paths)
    {
        std::error_code error;
        if (!fs::is_directory(path, error))
        {
            if (!fs::exists(path, error))
                throw std::runtime_error(path + ": there is no such file, expected a results.json or a folder of them");
            found.insert(fs::path(path).lexically_normal().string());
            continue;
        }
        const auto before = found.size();
        for (const auto& entry : fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied))
            if (entry.path().filename() == "results.json" && entry.is_regular_file())
                found.insert(entry.path().lexically_normal().string());
        // A part of a class may be empty: there were more parts than students.
        if (found.size() == before && !fs::exists(fs::path(path) / "gradebook.csv"))
            throw std::runtime_error(path + ": there is no results.json in this folder, expected those of a class");
    }
    return {found.begin(), found.end()};
}

std::vector<SubmissionResult> readClass(std::span<const std::string> files)
{
    std::map<std::string, std::pair<SubmissionResult, std::string>> known; // by student, with the file
    const std::string* first = nullptr;
    int lesson = 0;
    std::string grader;
    for (const auto& file : files)
    {
        auto result = readResult(file);
        if (!first)
        {
            first = &file;
            lesson = result.lesson;
            grader = result.grader;
        }
        if (result.lesson != lesson)
            throw std::runtime_error(
                fmt::format("{}: it is of lesson {:02} and {} is of lesson {:02}, expected one lesson", file,
                            result.lesson, *first, lesson));
        if (result.grader != grader)
            throw std::runtime_error(
                fmt::format("{}: it is not of the same grader, lesson data and secret as {}, expected "
                            "results of one version; grade one of them again",
                            file, *first));
        const auto student = result.student;
        const auto at = known.find(student);
        if (at == known.end())
            known.emplace(student, std::pair(std::move(result), file));
        else if (verdict(at->second.first) != verdict(result))
            throw std::runtime_error(
                fmt::format("{}: it is of the student \"{}\" and differs from {}, expected one result a "
                            "student; leave one of them out",
                            file, cleanLine(student, 200), at->second.second));
    }
    std::vector<SubmissionResult> results;
    for (auto& [student, one] : known) results.push_back(std::move(one.first));
    return results;
}

} // namespace rt::grade
