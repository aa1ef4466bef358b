// Files written whole or not at all, and texts read as a whole.
#pragma once

#include <functional>
#include <string>

namespace rt
{

/// Throws std::runtime_error with one sentence if no file of any kind can be written there: its folder is missing or not
/// writable, or the path is itself a folder. Call it before long work.
void checkFolder(const std::string& path);

/// Writes text whole or not at all (a temporary file in the same folder, then a rename). Throws std::runtime_error.
void writeTextFile(const std::string& path, const std::string& text);

/// Reads a whole text file. Throws std::runtime_error with one sentence.
std::string readTextFile(const std::string& path);

/// Calls write(temporary), a path beside `path` with the same ending, and gives the file its name. If `write` throws, or the
/// program is interrupted, nothing is left. Throws std::runtime_error.
void replaceFile(const std::string& path, const std::function<void(const std::string&)>& write);

/// Throws std::runtime_error if not all bytes can be written.
void writeBytes(const std::string& path, const std::string& bytes);

} // namespace rt
