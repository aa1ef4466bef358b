#include "tests/grade/package/package.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "tests/grade/package/archive.h"
#include "tests/grade/package/text.h"

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* archives[] = {".tar.gz", ".tgz", ".tar", ".zip"};

bool endsWith(const std::string& name, const std::string& ending)
{
    return name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

/// The ending that makes the entry a submission; empty: none.
std::string endingOf(const std::string& name)
{
    for (const char* ending : archives)
        if (endsWith(name, ending)) return ending;
    return endsWith(name, ".h") ? ".h" : "";
}

/// How a path in a package names the lesson.
enum class Place
{
    no,
    named,  ///< by a number in its path
    unnamed ///< exercise.h, of whichever lesson
};

Place placeOf(std::string path, int lesson)
{
    while (path.rfind("./", 0) == 0) path.erase(0, 2);
    const auto number = fmt::format("{:02}", lesson);
    // At the top or one folder deeper; what the Mac adds to archives is not the student's.
    const std::string top = R"((?:(?!__MACOSX/)[^/]+/)?)";
    const std::regex named(
        fmt::format(R"({}(?:exercise{}\.h|(?:lessons/)?{}(?:_[^/]*)?/exercise\.h))", top, number, number));
    if (std::regex_match(path, named)) return Place::named;
    static const std::regex other(R"((?:[^/]+/)?(?:lessons/)?\d\d(?:_[^/]*)?/exercise\.h)");
    if (std::regex_match(path, other)) return Place::no;
    return std::regex_match(path, std::regex(top + R"(exercise\.h)")) ? Place::unnamed : Place::no;
}

std::string missing(int lesson)
{
    return fmt::format("there is no exercise.h for lesson {:02}", lesson);
}

/// The text to be graded out of those that were found.
void choose(const std::vector<PackedFile>& files, int lesson, Taken& taken)
{
    std::string from;
    for (const auto& file : files)
    {
        std::vector<std::string> remarks;
        std::string text;
        try
        {
            text = normalisedText(file.bytes, remarks);
        }
        catch (const std::runtime_error& error)
        {
            // Whose lesson it is, it cannot say.
            throw Refused(fmt::format("{} is refused: {}", printable(file.path), error.what()));
        }
        const auto says = lessonOf(text);
        if (placeOf(file.path, lesson) == Place::unnamed && says != lesson) continue;
        if (says && *says != lesson)
            throw Refused(
                fmt::format("{} says that it is exercise {:02}, not {:02}", printable(file.path), *says, lesson));
        if (!from.empty() && text != taken.text)
            throw Refused(fmt::format("there are two different files for lesson {:02}: {} and {}", lesson,
                                      printable(from), printable(file.path)));
        if (!from.empty()) continue;
        from = file.path;
        taken.text = text;
        taken.remarks.insert(taken.remarks.end(), remarks.begin(), remarks.end());
    }
    if (from.empty())
    {
        taken.reason = missing(lesson);
        return;
    }
    taken.state = State::graded;
}

} // namespace

std::string studentOf(const std::string& path)
{
    const auto name = fs::path(path).filename().string();
    std::error_code ignored;
    if (fs::symlink_status(path, ignored).type() == fs::file_type::directory) return name;
    return name.substr(0, name.size() - endingOf(name).size());
}

std::vector<Submission> listSubmissions(const std::string& directory)
{
    std::vector<Submission> all;
    std::error_code error;
    for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error))
    {
        const auto name = entry->path().filename().string();
        if (name[0] == '.') continue;
        std::error_code ignored;
        const bool isFolder = fs::symlink_status(entry->path(), ignored).type() == fs::file_type::directory;
        if (!isFolder && endingOf(name).empty()) continue;
        all.push_back({studentOf(entry->path().string()), entry->path().string()});
    }
    if (error) throw std::runtime_error(fmt::format("{} cannot be read: {}", directory, error.message()));
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    std::set<std::string> students;
    for (const auto& one : all)
        if (!students.insert(one.student).second)
            throw std::runtime_error(
                fmt::format("{} has two submissions of {}; please keep one", directory, printable(one.student)));
    return all;
}

Taken takeExercise(const Submission& submission, int lesson)
{
    Taken taken;
    try
    {
        const auto isWanted = [&](const std::string& path) { return placeOf(path, lesson) != Place::no; };
        std::error_code ignored;
        const auto type = fs::symlink_status(submission.path, ignored).type();
        const auto ending = endingOf(fs::path(submission.path).filename().string());
        if (type == fs::file_type::symlink) throw Refused("the submission is a link");
        if (type == fs::file_type::directory)
            choose(filesInFolder(submission.path, isWanted, taken.remarks), lesson, taken);
        else if (ending == ".h")
        {
            // The student's name stands for the lesson's, unless the file says otherwise.
            const auto bytes = bytesOf(submission.path);
            std::vector<std::string> notYet;
            const auto says = lessonOf(normalisedText(bytes, notYet));
            if (says && *says != lesson)
                taken.reason = missing(lesson);
            else
                choose({{fmt::format("exercise{:02}.h", lesson), bytes}}, lesson, taken);
        }
        else
            choose(filesInArchive(submission.path, isWanted, taken.remarks), lesson, taken);
    }
    catch (const std::exception& error)
    {
        taken = {State::refused, error.what(), "", taken.remarks};
    }
    return taken;
}

} // namespace rt::grade
