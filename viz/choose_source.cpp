#include "viz/choose_source.h"

#include <charconv>
#include <filesystem>

#include <fmt/format.h>

#include "common/image.h"
#include "common/program.h"
#include "lessons/registry.h"
#include "viz/tracer_source.h"

namespace rt::viz
{

namespace
{

namespace fs = std::filesystem;

std::optional<int> numberAfter(const std::string& what, const std::string& key)
{
    if (!what.starts_with(key)) return std::nullopt;
    int number = 0;
    const char* end = what.data() + what.size();
    const auto [rest, error] = std::from_chars(what.data() + key.size(), end, number);
    if (error != std::errc() || rest != end || number < 0 || number > 1024)
        throw std::runtime_error(fmt::format("--compare {}: expected {}N with a number from 0 to 1024", what, key));
    return number;
}

TreeSource exerciseOf(const LessonEntry& lesson)
{
    const auto program = fs::read_symlink("/proc/self/exe").parent_path() / fmt::format("exercise{:02}", lesson.number);
    if (!fs::exists(program))
        throw std::runtime_error(fmt::format("--compare exercise: {} is not built; ./raytree exercise {} builds it",
                                             program.string(), lesson.number));
    return tracerSource("'" + program.string() + "'");
}

TreeSource otherSource(const Session& session, const std::string& what, const LessonEntry& lesson, Precision precision)
{
    if (what == "exercise") return exerciseOf(lesson);
    if (what == "schlick" || what == "exact")
    {
        const auto model = what == "exact" ? FresnelModel::exact : FresnelModel::schlick;
        return with(session.source, what, [model](SceneDescription& scene) { scene.trace.fresnel = model; });
    }
    for (const auto other : {Precision::floating, Precision::doubled, Precision::longDouble})
        if (what == name(other))
        {
            auto source = lessonSource(lesson, other);
            source.title = what;
            return source;
        }
    if (const auto depth = numberAfter(what, "depth="))
        return with(session.source, what, [depth](SceneDescription& scene) { scene.trace.maxDepth = *depth; });
    if (const auto number = numberAfter(what, "lesson="))
    {
        if (const auto* found = findLesson(*number)) return lessonSource(*found, precision);
        throw std::runtime_error(fmt::format("--compare {}: {}", what, whyNoLesson(*number)));
    }
    if (fs::path(what).extension() == ".json")
    {
        try
        {
            return fileSource(rayTreeFromJson(readTextFile(what)), what);
        }
        catch (const std::exception& error)
        {
            throw std::runtime_error(fmt::format("--compare {}: {}", what, error.what()));
        }
    }
    if (what.find_first_of("/ ") != std::string::npos) return tracerSource(what);
    throw std::runtime_error(fmt::format("--compare {}: expected exercise, exact, schlick, float, double, long-double, "
                                         "depth=N, lesson=N, a file that ends in .json, or a program's path",
                                         what));
}

} // namespace

std::string whyNoLesson(int number)
{
    std::string known;
    for (const auto* lesson : lessons()) known += fmt::format("{}{}", known.empty() ? "" : ", ", lesson->number);
    const auto start = fmt::format("{:02}_", number);
    std::error_code none;
    for (const auto& folder : fs::directory_iterator(projectFile("lessons"), none))
        if (auto name = folder.path().filename().string(); name.starts_with(start))
        {
            name.erase(0, start.size());
            std::replace(name.begin(), name.end(), '_', ' ');
            return fmt::format(
                "lesson {0} ({1}) is a {2} without a tracer to step through: ./raytree lesson {0} shows it; "
                "the viewer has {3}",
                number, name, number == 0 ? "tutorial" : "study", known);
        }
    return fmt::format("there is no lesson {}; there are {}", number, known);
}

void compareWith(Session& session, const std::string& what, const LessonEntry& lesson, Precision precision)
{
    session.other = otherSource(session, what, lesson, precision);
}

} // namespace rt::viz
