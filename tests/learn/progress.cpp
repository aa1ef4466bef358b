#include "tests/learn/progress.h"

#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/files/text_file.h"

namespace rt::grade
{

namespace
{

constexpr int progressVersion = 1;
constexpr std::array<const char*, 3> names{"not attempted", "wrong", "right"};

Progress parse(const std::string& text)
{
    const auto json = nlohmann::json::parse(text);
    if (const int found = json.at("version").get<int>(); found != progressVersion)
        throw std::runtime_error(fmt::format("it has version {}, and this program knows {}", found, progressVersion));
    Progress progress;
    progress.current = json.at("current").get<std::string>();
    for (const auto& [id, standing] : json.at("exercises").items())
    {
        const auto name = standing.get<std::string>();
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) throw std::runtime_error(fmt::format("\"{}\" is no state of an exercise", name));
        progress.exercises[id] = Standing(found - names.begin());
    }
    return progress;
}

} // namespace

Standing Progress::of(const std::string& id) const
{
    const auto found = exercises.find(id);
    return found == exercises.end() ? Standing::notAttempted : found->second;
}

Progress loadProgress(const std::string& path, std::string& notice)
{
    if (!std::filesystem::exists(path)) return {};
    std::string reason;
    try
    {
        return parse(readTextFile(path));
    }
    catch (const nlohmann::json::exception&)
    {
        reason = "it is not what this program writes";
    }
    catch (const std::exception& error)
    {
        reason = error.what();
    }
    std::error_code failed;
    std::filesystem::rename(path, path + ".broken", failed);
    notice = fmt::format("{} could not be used ({}): {}, and progress starts afresh", path, reason,
                         failed ? "it stays" : "it is now called " + path + ".broken");
    return {};
}

void saveProgress(const std::string& path, const Progress& progress)
{
    nlohmann::ordered_json json{
        {"version", progressVersion}, {"current", progress.current}, {"exercises", nlohmann::json::object()}};
    for (const auto& [id, standing] : progress.exercises) json["exercises"][id] = names[std::size_t(standing)];
    writeTextFile(path, json.dump(1) + "\n");
}

} // namespace rt::grade
