#include "tests/grade/grade_one.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "common/files/text_file.h"
#include "tests/grade/box/compile.h"
#include "tests/grade/box/source_text.h"
#include "tests/grade/digest.h"
#include "tests/grade/wire/remote.h"

namespace rt::grade
{

namespace
{

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Lengths stand before texts: no two lists run together to the same bytes.
std::string hashOf(const std::vector<std::string>& parts)
{
    std::string all;
    for (const auto& part : parts) all += fmt::format("{}:{}", part.size(), part);
    return sha256Hex(all);
}

std::string handedOut(int lesson)
{
    for (const auto& folder : std::filesystem::directory_iterator(RAYTREE_SOURCE_DIR "/lessons"))
        if (folder.path().filename().string().starts_with(fmt::format("{:02}_", lesson)))
            return readTextFile(folder.path().string() + "/exercise.h");
    return "";
}

/// Could another content of unset memory explain a wrong public answer? Not where two runs differ: that they do for another
/// reason.
bool mayBeUninitialised(const Answers& answers)
{
    const auto has = [&answers](Outcome outcome) {
        return std::any_of(answers.criteria.begin(), answers.criteria.end(),
                           [outcome](const CriterionResult& one) { return !one.hidden && one.outcome == outcome; });
    };
    return has(Outcome::wrong) && !has(Outcome::notDeterministic);
}

/// Of exercises that count as not attempted though code was written for them.
void remarkOnTodos(SubmissionResult& result, const std::string& text)
{
    for (const auto& id : todosLeft(text, handedOut(result.lesson)))
        if (std::any_of(result.criteria.begin(), result.criteria.end(), [&](const CriterionResult& one) {
                return !one.hidden && one.exercise == id && one.outcome == Outcome::notAttempted;
            }))
            result.remarks.push_back(fmt::format(
                "your code for {} stands beside todo(\"{}\"), which still ends it: delete that line", id, id));
}

} // namespace

std::string graderHash()
{
    std::vector<std::string> all;
    for (const char* file : {"/proc/self/exe", GRADE_KIT "/rest/runner.o", GRADE_KIT "/compiler"})
        all.push_back(sha256Hex(readTextFile(file)));
    return hashOf(all);
}

std::string graderKey(const Setting& setting)
{
    return hashOf({setting.grader, std::to_string(setting.lesson), setting.secret.course, setting.secret.term,
                   name(setting.sandbox), fmt::format("{}", setting.limits.cpuSeconds)});
}

std::string keyOf(const Setting& setting, const Taken& taken)
{
    return hashOf({graderKey(setting), name(taken.state), taken.reason, taken.text});
}

SubmissionResult gradeOne(const Submission& submission, const Taken& taken, const Setting& setting, int worker,
                          const std::string& folder, const std::atomic<bool>& stop)
{
    const auto start = Clock::now();
    SubmissionResult result;
    result.student = submission.student;
    result.lesson = setting.lesson;
    result.key = keyOf(setting, taken);
    result.grader = graderKey(setting);
    result.sandbox = name(setting.sandbox);
    result.state = taken.state;
    result.reason = taken.reason;
    result.remarks = taken.remarks;
    if (taken.state != State::graded) return result;
    const auto failed = [&result](const char* why) {
        result.state = State::graderError;
        result.reason = why;
        result.criteria.clear();
    };
    try
    {
        const Box box{setting.sandbox, worker};
        const auto compiled = compileSubmission(box, setting.lesson, taken.text, folder);
        result.compileSeconds = compiled.cpuSeconds;
        result.remarks.insert(result.remarks.end(), compiled.remarks.begin(), compiled.remarks.end());
        if (!compiled.ok)
        {
            result.state = State::notCompiled;
            result.reason = compiled.reason;
            result.compilerErrors = compiled.errors;
            result.seconds = secondsSince(start);
            return result;
        }
        const auto ask = [&](Remote& remote, const AskOptions& options) {
            return gradeCandidate(
                setting.lesson, [&] { return remote.afresh(); }, setting.secret, options);
        };
        AskOptions options;
        options.stop = &stop;
        Remote remote(box, compiled.program, setting.lesson, setting.limits);
        auto answers = ask(remote, options);
        result.studentText = remote.text();
        if (mayBeUninitialised(answers))
        {
            const auto zero = compileSubmission(box, setting.lesson, taken.text, folder, Fill::zero);
            // Classes of numbers tell it as well as pictures do, and students are told nothing that depends on the secret.
            options.twice = options.mistakes = options.pictures = options.hidden = false;
            if (zero.ok)
            {
                Remote other(box, zero.program, setting.lesson, setting.limits);
                if (const auto remark = uninitialised(answers, ask(other, options))) answers.remarks.push_back(*remark);
            }
        }
        result.criteria = std::move(answers.criteria);
        result.remarks.insert(result.remarks.end(), answers.remarks.begin(), answers.remarks.end());
        remarkOnTodos(result, taken.text);
    }
    catch (const Interrupted&)
    {
        // The caller knows.
    }
    catch (const std::exception& error)
    {
        failed(error.what());
    }
    catch (const GraderError& error)
    {
        failed(error.what());
    }
    result.seconds = secondsSince(start);
    return result;
}

} // namespace rt::grade
