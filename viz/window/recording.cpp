#include "viz/window/recording.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <vtkCommand.h>

#include "common/files/text_file.h"

namespace rt::viz
{

namespace
{
const std::string windowMark = "# Window ";
}

std::string tidyRecording(const std::string& recording, const WindowPlace& window)
{
    std::istringstream lines(recording);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
    {
        const bool isKey = line.starts_with("Key") || line.starts_with("Char");
        if (line.starts_with("TimerEvent") || line.starts_with("RenderEvent") || line.starts_with("ExitEvent"))
            continue;
        if (isKey && (line.ends_with(" q") || line.ends_with(" Q"))) continue;
        kept += line + "\n";
        if (line.starts_with("# StreamVersion"))
            kept += fmt::format("{}{}x{} scale {}\n", windowMark, window.width, window.height, window.scale);
    }
    return kept;
}

std::optional<WindowPlace> checkRecording(const std::string& file)
{
    const auto fail = [&](std::size_t line, const std::string& expected) {
        throw std::runtime_error(fmt::format("{}:{}: expected {}", file, line, expected));
    };
    std::istringstream lines(readTextFile(file));
    std::size_t number = 1;
    std::string line;
    if (!std::getline(lines, line) || !line.starts_with("# StreamVersion"))
        fail(number, "\"# StreamVersion\", with which a recording of --record begins");
    std::optional<WindowPlace> window;
    while (std::getline(lines, line))
    {
        ++number;
        if (line.starts_with(windowMark))
        {
            std::istringstream said(line.substr(windowMark.size()));
            char by = 0;
            std::string word;
            WindowPlace place;
            said >> place.width >> by >> place.height >> word >> place.scale;
            const bool isGood = said && by == 'x' && word == "scale" && place.width >= 1 && place.height >= 1 &&
                                std::max(place.width, place.height) <= largestWindow && place.scale >= smallestScale &&
                                place.scale <= largestScale;
            if (!isGood) fail(number, "\"# Window WxH scale S\", the size of the window that was recorded");
            window = place;
            continue;
        }
        std::istringstream words(line);
        std::string event, keySym;
        int x = 0, y = 0, modifiers = 0, keyCode = 0, repeats = 0;
        words >> event >> x >> y >> modifiers >> keyCode >> repeats >> keySym;
        if (!words || vtkCommand::GetEventIdFromString(event.c_str()) == vtkCommand::NoEvent)
            fail(number, "an event of VTK, its place, modifiers, key code, repeats and the key's name");
    }
    return window;
}

} // namespace rt::viz
