#include "tests/grade/class_run.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "common/image.h"
#include "tests/grade/digest.h"
#include "tests/grade/report/class_html.h"
#include "tests/grade/report/gradebook.h"
#include "tests/grade/report/instructor_html.h"
#include "tests/grade/report/junit.h"
#include "tests/grade/report/report_html.h"
#include "tests/grade/report/results_json.h"

namespace rt::grade
{

namespace
{

namespace files = std::filesystem;

/// The result that is there already, if it is of the same key.
std::optional<SubmissionResult> earlier(const std::string& path, const std::string& key)
{
    if (!files::exists(path)) return std::nullopt;
    try
    {
        auto result = resultFromJson(readTextFile(path));
        if (result.key == key && result.state != State::graderError) return result;
    }
    catch (const std::exception&)
    {
        // Not one of ours, or of another version: it is made again.
    }
    return std::nullopt;
}

void write(const SubmissionResult& result, const std::string& out)
{
    const auto name = fileNameOf(result.student);
    const auto folder = out + "/results/" + name;
    files::create_directories(folder);
    files::create_directories(out + "/instructor");
    writeTextFile(out + "/instructor/" + name + ".html", instructorHtml(result));
    writeTextFile(folder + "/report.html", reportHtml(result));
    // Last: where it is, the others are.
    writeTextFile(folder + "/results.json", resultsJson(result));
}

std::vector<Submission> partOf(const std::vector<Submission>& all, const Shard& shard)
{
    std::vector<Submission> part;
    for (std::size_t i = std::size_t(shard.part - 1); i < all.size(); i += std::size_t(shard.of))
        part.push_back(all[i]);
    return part;
}

} // namespace

std::string fileNameOf(const std::string& student)
{
    constexpr std::size_t longest = 60;
    std::string name;
    for (const char c : student)
        if ((c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.' || c == '-' || c == '_')
            name += c;
    while (!name.empty() && (name[0] == '.' || name[0] == '-')) name.erase(0, 1);
    name = name.substr(0, longest);
    return name == student ? name : fmt::format("{}{}{}", name, name.empty() ? "" : "_", sha256Hex(student).substr(0, 12));
}

ClassRun gradeClass(const std::vector<Submission>& all, const ClassSetting& setting, const std::atomic<bool>& stop,
                    const std::function<void(const Progress&)>& report)
{
    const auto submissions = partOf(all, setting.shard);
    files::create_directories(setting.out);
    std::vector<std::optional<SubmissionResult>> results(submissions.size());
    ClassRun run;
    std::mutex reporting;
    std::size_t done = 0;
    std::string broken; // why a worker could not go on
    std::atomic<std::size_t> next = 0;

    const auto gradeNumber = [&](std::size_t i, int worker, const std::string& folder) {
        const auto& submission = submissions[i];
        const auto taken = takeExercise(submission, setting.setting.lesson);
        const auto path = setting.out + "/results/" + fileNameOf(submission.student) + "/results.json";
        auto result = setting.resume ? earlier(path, keyOf(setting.setting, taken)) : std::nullopt;
        const bool kept = result.has_value();
        if (!result)
        {
            result = gradeOne(submission, taken, setting.setting, worker, folder, stop);
            if (stop) return;
            write(*result, setting.out);
        }
        const std::lock_guard lock(reporting);
        ++(kept ? run.kept : run.graded);
        run.graderErrors = run.graderErrors || result->state == State::graderError;
        results[i] = std::move(result);
        report({++done, submissions.size(), &*results[i], kept});
    };
    const auto work = [&](int worker) {
        try
        {
            const Scratch folder;
            for (std::size_t i; !stop && (i = next++) < submissions.size();) gradeNumber(i, worker, folder.path);
        }
        catch (const std::exception& error)
        {
            const std::lock_guard lock(reporting);
            broken = error.what();
            next = submissions.size();
        }
    };
    {
        std::vector<std::jthread> workers;
        for (int worker = 0; worker < setting.jobs; ++worker) workers.emplace_back(work, worker);
    }
    if (!broken.empty()) throw std::runtime_error(broken);
    run.interrupted = stop;
    for (auto& result : results)
        if (result) run.results.push_back(std::move(*result));
    return run;
}

void writeClass(const std::vector<SubmissionResult>& results, const std::string& out)
{
    writeTextFile(out + "/gradebook.csv", gradebookCsv(results));
    writeTextFile(out + "/junit.xml", junitXml(results));
    writeTextFile(out + "/class.html", classHtml(results));
}

} // namespace rt::grade
