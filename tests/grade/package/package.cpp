#include "tests/grade/package/package.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <span>

#include <fmt/format.h>

#include "tests/grade/package/archive.h"
#include "tests/grade/package/text.h"

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* archives[] = {".tar.gz", ".tgz", ".tar", ".zip"};
constexpr const char* texts[] = {".h", ".h.txt"};
constexpr const char* unknownArchives[] = {".tar.xz", ".tar.bz2", ".txz", ".rar", ".7z", ".xz", ".bz2", ".gz"};
constexpr const char* asked = "expected a folder, .zip, .tar, .tar.gz, .tgz or .h";

std::string inLowerCase(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return text;
}

/// The one of them that the name ends with, however it is written: .ZIP is .zip. Empty: none.
std::string endingOf(const std::string& name, std::span<const char* const> endings)
{
    for (const std::string ending : endings)
        if (name.size() > ending.size() && inLowerCase(name).ends_with(ending)) return ending;
    return "";
}

/// What systems leave in folders; nobody hands it in.
bool isRubbish(const std::string& name)
{
    static const std::set<std::string> names = {".ds_store", "thumbs.db", "desktop.ini",
                                                "__macosx",  ".git",      ".gitignore"};
    return names.contains(inLowerCase(name)) || name.starts_with("._");
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

/// How far from what was asked for a name may be. Each is tried only if the one before found nothing.
enum class Search
{
    asNamed, ///< exercise.h where it belongs
    asDownloaded, ///< what browsers and course systems make of it: "exercise (1).h", "ann_123_Exercise-1.h.txt", at any depth
    anyHeader ///< whatever its name is, if it says that it is this lesson's
};

bool isWanted(const std::string& path, int lesson, Search search)
{
    if (search == Search::asNamed) return placeOf(path, lesson) != Place::no;
    const auto name = inLowerCase(path.substr(path.rfind('/') + 1));
    if (isRubbish(name) || path.find("__MACOSX/") != std::string::npos || endingOf(name, texts).empty()) return false;
    return search == Search::anyHeader || name.find("exercise") != std::string::npos;
}

std::string missing(int lesson, const std::vector<std::string>& found)
{
    constexpr std::size_t most = 5;
    std::string list = found.empty() ? "nothing" : "";
    for (std::size_t i = 0; i < std::min(found.size(), most); ++i) list += (i ? ", " : "") + printable(found[i]);
    if (found.size() > most) list += fmt::format(" and {} more", found.size() - most);
    return fmt::format("there is no exercise.h for lesson {:02}; found {}, expected exercise.h with namespace "
                       "rt::exercise{:02} in it",
                       lesson, list, lesson);
}

/// The text to be graded out of those that were found.
void choose(const std::vector<PackedFile>& files, int lesson, Search search, Taken& taken)
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
        const bool hasNumber = search == Search::asNamed && placeOf(file.path, lesson) == Place::named;
        if (!hasNumber && says != lesson) continue;
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
    if (from.empty()) return;
    if (search != Search::asNamed) taken.remarks.push_back(fmt::format("{} was taken for exercise.h", printable(from)));
    taken.state = State::graded;
}

using Wanted = std::function<bool(const std::string&)>;
using Files = std::function<std::vector<PackedFile>(const Wanted&, std::vector<std::string>& remarks)>;

/// Looks for the exercise among files, farther and farther from what was asked for. `found`: what else is there.
Taken searched(const Files& filesOf, int lesson, std::vector<std::string>& found)
{
    Taken taken;
    for (const auto search : {Search::asNamed, Search::asDownloaded, Search::anyHeader})
    {
        taken = {};
        found.clear();
        try
        {
            choose(filesOf(
                       [&](const std::string& path) {
                           if (!isRubbish(path.substr(path.rfind('/') + 1))) found.push_back(path);
                           return isWanted(path, lesson, search);
                       },
                       taken.remarks),
                   lesson, search, taken);
        }
        catch (const std::exception&)
        {
            if (search != Search::anyHeader) throw; // some other header may be large, or a link
        }
        if (taken.state == State::graded) break;
    }
    return taken;
}

/// A folder; and if the exercise is not in it, the archives in it, as Moodle's folders have them.
Taken takenFromFolder(const std::string& path, int lesson)
{
    std::vector<std::string> found;
    auto taken = searched([&](const Wanted& wanted, auto& remarks) { return filesInFolder(path, wanted, remarks); },
                          lesson, found);
    const auto inFolder = found;
    for (const auto& name : inFolder)
    {
        if (taken.state == State::graded) break;
        if (endingOf(name, archives).empty()) continue;
        // No link is followed: the walk that found it followed none, and nobody changes the folder now.
        std::vector<std::string> inArchive;
        taken = searched(
            [&](const Wanted& wanted, auto& remarks) { return filesInArchive(path + "/" + name, wanted, remarks); },
            lesson, inArchive);
        for (const auto& one : inArchive) found.push_back(name + ": " + one);
    }
    if (taken.state != State::graded) taken.reason = missing(lesson, found);
    return taken;
}

Taken takenFromArchive(const std::string& path, int lesson)
{
    std::vector<std::string> found;
    auto taken = searched([&](const Wanted& wanted, auto& remarks) { return filesInArchive(path, wanted, remarks); },
                          lesson, found);
    if (taken.state != State::graded) taken.reason = missing(lesson, found);
    return taken;
}

Taken takenFromText(const std::string& path, int lesson)
{
    Taken taken;
    // The student's name stands for the lesson's, unless the file says otherwise.
    const auto bytes = bytesOf(path);
    const auto name = fs::path(path).filename().string();
    std::vector<std::string> notYet;
    const auto says = lessonOf(normalisedText(bytes, notYet));
    if (says && *says != lesson)
        taken.reason = missing(lesson, {fmt::format("{}, which says that it is exercise {:02}", name, *says)});
    else
        choose({{fmt::format("exercise{:02}.h", lesson), bytes}}, lesson, Search::asNamed, taken);
    return taken;
}

} // namespace

std::string studentOf(const std::string& path)
{
    const auto name = fs::path(path).filename().string();
    std::error_code ignored;
    if (fs::symlink_status(path, ignored).type() == fs::file_type::directory) return name;
    for (const std::span<const char* const> endings :
         {std::span<const char* const>(archives), {texts}, {unknownArchives}})
        if (const auto ending = endingOf(name, endings); !ending.empty())
            return name.substr(0, name.size() - ending.size());
    const auto dot = name.rfind('.');
    return dot == 0 || dot == std::string::npos ? name : name.substr(0, dot);
}

std::vector<Submission> listSubmissions(const std::string& directory)
{
    std::vector<Submission> all, others; // what can be opened, and what has a row all the same
    std::error_code error;
    for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error))
    {
        const auto path = entry->path().string(), name = entry->path().filename().string();
        if (isRubbish(name)) continue;
        std::error_code ignored;
        const bool isFolder = fs::symlink_status(path, ignored).type() == fs::file_type::directory;
        const bool canBeOpened = isFolder || !endingOf(name, archives).empty() || !endingOf(name, texts).empty();
        (canBeOpened ? all : others).push_back({studentOf(path), path});
    }
    if (error) throw std::runtime_error(fmt::format("{} cannot be read: {}", directory, error.message()));
    const auto byPath = [](const auto& a, const auto& b) { return a.path < b.path; };
    std::sort(all.begin(), all.end(), byPath);
    std::set<std::string> students;
    for (const auto& one : all)
        if (!students.insert(one.student).second)
            throw std::runtime_error(
                fmt::format("{} has two submissions of {}; please keep one", directory, printable(one.student)));
    std::sort(others.begin(), others.end(), byPath);
    for (auto& one : others)
    {
        // ann.pdf beside ann.zip is no second submission of hers; it is said all the same that it was not graded.
        if (students.contains(one.student)) one.student = fs::path(one.path).filename().string();
        while (!students.insert(one.student).second) one.student += "'"; // a folder may be called ann.pdf, too
        all.push_back(one);
    }
    std::sort(all.begin(), all.end(), byPath);
    return all;
}

Taken takeExercise(const Submission& submission, int lesson)
{
    const auto name = fs::path(submission.path).filename().string();
    std::error_code ignored;
    const auto type = fs::symlink_status(submission.path, ignored).type();
    try
    {
        if (type == fs::file_type::symlink)
            throw Refused(fmt::format("the submission is a link; found {}, {}", printable(name), asked));
        if (type == fs::file_type::directory) return takenFromFolder(submission.path, lesson);
        if (!endingOf(name, texts).empty()) return takenFromText(submission.path, lesson);
        if (!endingOf(name, archives).empty()) return takenFromArchive(submission.path, lesson);
        if (const auto ending = endingOf(name, unknownArchives); !ending.empty())
            throw Refused(fmt::format("{} archives cannot be opened; found {}, {}", ending, printable(name), asked));
        return {State::missing, missing(lesson, {name}), "", {}};
    }
    catch (const std::exception& error)
    {
        return {State::refused, error.what(), "", {}};
    }
}

} // namespace rt::grade
