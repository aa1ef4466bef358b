// A script drives the viewer without hands: for pictures that can be repeated, and for tests.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "viz/state/controller.h"

namespace rt::viz
{

struct ScriptCommand
{
    int number = 1; ///< place in the script, from 1
    std::string text;
    std::vector<std::string> words; ///< its name, then its arguments
};

/// Commands stand between semicolons or line ends; # begins a comment; "double quotes" hold a word together. Throws
/// std::runtime_error with one sentence that names the command if one of them does not exist or has wrong arguments: a
/// script runs as a whole or not at all.
std::vector<ScriptCommand> parseScript(const std::string& script);

/// One line for each command, for --help.
std::string scriptHelp();

/// True if a command needs a window, thus a display.
bool needsWindow(const std::vector<ScriptCommand>& commands);

/// What a script can do beyond the controller's actions.
struct ScriptHost
{
    Controller& controller;
    std::function<void(const std::string& file)> exportTo{}; ///< a file, or a folder for all formats
    // In a window; coordinates from its upper left corner.
    std::function<void(const std::string& file)> shot{};
    std::function<void(const std::string& key)> key{};
    std::function<void(int x, int y)> click{};
    std::function<void(int fromX, int fromY, int toX, int toY)> drag{};
    std::function<void(int x, int y)> hover{};
    std::function<void(int x, int y, bool forward)> wheel{};
    std::function<void(int width, int height)> resize{};
};

/// Runs them in order. Throws std::runtime_error with one sentence at the first that fails.
void runScript(const std::vector<ScriptCommand>& commands, const ScriptHost& host);

} // namespace rt::viz
