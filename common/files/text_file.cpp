#include "common/files/text_file.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <unistd.h>

#include "common/base/interrupt.h"

namespace rt
{

namespace fs = std::filesystem;

void replaceFile(const std::string& path, const std::function<void(const std::string&)>& write)
{
    const fs::path target(path);
    const auto temporary =
        (target.parent_path() / fmt::format(".part-{}-{}", getpid(), target.filename().string())).string();
    const auto remove = [&temporary] {
        std::error_code ignored;
        fs::remove(temporary, ignored);
    };
    const UndoAtInterrupt undo(remove);
    try
    {
        write(temporary);
        noteWritten();
        fs::rename(temporary, target);
    }
    catch (const std::exception& error)
    {
        remove();
        throw std::runtime_error(fmt::format("{}: cannot be written: {}", path, error.what()));
    }
}

void writeBytes(const std::string& path, const std::string& bytes)
{
    std::ofstream out(path, std::ios::binary);
    out.write(bytes.data(), std::streamsize(bytes.size()));
    out.close();
    if (!out) throw std::runtime_error("the disk may be full");
}

void checkFolder(const std::string& path)
{
    const auto folder = fs::absolute(path).parent_path();
    if (!fs::is_directory(folder))
        throw std::runtime_error(fmt::format("{}: there is no folder {}", path, folder.string()));
    if (access(folder.c_str(), W_OK) != 0)
        throw std::runtime_error(fmt::format("{}: the folder {} is not writable", path, folder.string()));
    if (fs::is_directory(path)) throw std::runtime_error(fmt::format("{}: is a folder, expected a file", path));
}

void writeTextFile(const std::string& path, const std::string& text)
{
    checkFolder(path);
    replaceFile(path, [&](const std::string& temporary) { writeBytes(temporary, text); });
}

std::string readTextFile(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    // An empty file is a text too, though << fails where there is nothing to pass on.
    const bool isEmpty = in && in.peek() == std::ifstream::traits_type::eof() && !in.bad();
    if (!isEmpty && (!in || !(text << in.rdbuf()))) throw std::runtime_error(fmt::format("{}: cannot be read", path));
    return text.str();
}

} // namespace rt
