#include "tests/grade/class_run.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "common/files/text_file.h"
#include "tests/grade/box/temporary_folder.h"
#include "tests/grade/report/files.h"

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
        auto result = readResult(path);
        if (result.key == key && result.state != State::graderError) return result;
    }
    catch (const std::exception&)
    {
        // Not one of ours, or of another version: it is made again.
    }
    return std::nullopt;
}

/// The scenes of failing pictures as files that the reports name: reports/scenes/06-glass.toml. They are the same for all.
void writeScenes(SubmissionResult& result, const std::string& out)
{
    for (auto& one : result.criteria)
    {
        if (!one.pictures || one.pictures->scene.empty()) continue;
        std::string words = one.name.starts_with("picture: ") ? one.name.substr(9) : one.name;
        std::replace(words.begin(), words.end(), ' ', '-');
        const auto name = fmt::format("{:02}-{}.toml", result.lesson, words);
        files::create_directories(out + "/reports/scenes");
        writeTextFile(out + "/reports/scenes/" + name, one.pictures->scene);
        auto& command = one.pictures->command;
        if (const auto at = command.find("SCENE"); at != std::string::npos) command.replace(at, 5, "scenes/" + name);
    }
}

std::vector<Submission> partOf(const std::vector<Submission>& all, const Shard& shard)
{
    std::vector<Submission> part;
    for (std::size_t i = std::size_t(shard.part - 1); i < all.size(); i += std::size_t(shard.of))
        part.push_back(all[i]);
    return part;
}

} // namespace

std::size_t countOf(const std::vector<Submission>& all, const Shard& shard)
{
    return partOf(all, shard).size();
}

ClassRun gradeClass(const std::vector<Submission>& all, const ClassSetting& setting, const std::atomic<bool>& stop,
                    const std::function<void(const ClassProgress&)>& report)
{
    const auto submissions = partOf(all, setting.shard);
    std::vector<std::optional<SubmissionResult>> results(submissions.size());
    ClassRun run;
    run.of = submissions.size();
    std::mutex reporting;
    std::size_t done = 0;
    std::string broken; // why a worker could not go on
    std::atomic<std::size_t> next = 0;

    const auto gradeNumber = [&](std::size_t i, int worker, const std::string& folder) {
        const auto& submission = submissions[i];
        const auto taken = takeExercise(submission, setting.setting.lesson);
        const auto path = resultPath(setting.out, submission.student);
        auto result = setting.resume ? earlier(path, keyOf(setting.setting, taken)) : std::nullopt;
        const bool kept = result.has_value();
        if (!result)
        {
            result = gradeOne(submission, taken, setting.setting, worker, folder, stop);
            if (stop) return;
            writeScenes(*result, setting.out);
            writeReports(setting.out, *result, setting.hidden);
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
            const TemporaryFolder folder;
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

} // namespace rt::grade
