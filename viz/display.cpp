#include "viz/display.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>
#include <X11/Xlib.h>

namespace rt::viz
{

namespace
{

constexpr const char* guard = "RAYTREE_UNDER_XVFB";

bool isInPath(const std::string& program)
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

} // namespace

bool hasDisplay()
{
    Display* display = XOpenDisplay(nullptr);
    if (!display) return false;
    int opcode = 0, event = 0, error = 0;
    const bool openGl = XQueryExtension(display, "GLX", &opcode, &event, &error);
    XCloseDisplay(display);
    return openGl;
}

void restartWithDisplay(char** argv, int width, int height)
{
    if (std::getenv(guard) || !isInPath("xvfb-run") || !isInPath("Xvfb")) return;
    setenv(guard, "1", 1);
    std::string program = argv[0];
    std::error_code error;
    if (const auto self = std::filesystem::read_symlink("/proc/self/exe", error); !error) program = self.string();
    // -noreset: otherwise Xvfb signals xvfb-run when the last client leaves, which sometimes disturbs its cleaning up.
    const auto screen = fmt::format("-screen 0 {}x{}x24 -noreset", width, height);
    std::vector<const char*> arguments{"xvfb-run", "-a", "-s", screen.c_str(), program.c_str()};
    for (char** argument = argv + 1; *argument; ++argument) arguments.push_back(*argument);
    arguments.push_back(nullptr);
    execvp(arguments[0], const_cast<char**>(arguments.data()));
    unsetenv(guard);
}

} // namespace rt::viz
