#include "viz/recording.h"

#include <sstream>

#include <fmt/format.h>
#include <vtkCommand.h>

#include "common/image.h"

namespace rt::viz
{

std::string tidyRecording(const std::string& recording)
{
    std::istringstream lines(recording);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
    {
        const bool isKey = line.starts_with("Key") || line.starts_with("Char");
        if (line.starts_with("TimerEvent") || line.starts_with("RenderEvent")) continue;
        if (isKey && (line.ends_with(" q") || line.ends_with(" Q"))) continue;
        kept += line + "\n";
    }
    return kept;
}

void checkRecording(const std::string& file)
{
    const auto fail = [&](std::size_t line, const std::string& expected) {
        throw std::runtime_error(fmt::format("{}:{}: expected {}", file, line, expected));
    };
    std::istringstream lines(readTextFile(file));
    std::size_t number = 1;
    std::string line;
    if (!std::getline(lines, line) || !line.starts_with("# StreamVersion"))
        fail(number, "\"# StreamVersion\", with which a recording of --record begins");
    while (std::getline(lines, line))
    {
        ++number;
        std::istringstream words(line);
        std::string event, keySym;
        int x = 0, y = 0, modifiers = 0, keyCode = 0, repeats = 0;
        words >> event >> x >> y >> modifiers >> keyCode >> repeats >> keySym;
        if (!words || vtkCommand::GetEventIdFromString(event.c_str()) == vtkCommand::NoEvent)
            fail(number, "an event of VTK, its place, modifiers, key code, repeats and the key's name");
    }
}

} // namespace rt::viz
