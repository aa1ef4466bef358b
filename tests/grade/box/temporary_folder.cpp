#include "tests/grade/box/temporary_folder.h"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace rt::grade
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* prefix = "raytree-box-";

fs::path base()
{
    std::error_code error;
    const auto system = fs::temp_directory_path(error);
    return error ? "/tmp" : system;
}

int openFolder(const std::string& path)
{
    return ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

bool isAbandoned(int folder)
{
    constexpr std::time_t soonLocked = 60; // seconds: between its making and its locking nobody holds a folder
    struct stat status;
    return ::fstat(folder, &status) == 0 && status.st_uid == ::geteuid() &&
           std::time(nullptr) - status.st_mtime > soonLocked && ::flock(folder, LOCK_EX | LOCK_NB) == 0;
}

} // namespace

TemporaryFolder::TemporaryFolder()
{
    path = (base() / fmt::format("{}XXXXXX", prefix)).string();
    if (!::mkdtemp(path.data()))
        throw std::runtime_error(fmt::format("a temporary folder cannot be made in {}", base().string()));
    lock = openFolder(path);
    ::flock(lock, LOCK_EX | LOCK_NB);
    constexpr mode_t enter = 0711;
    ::chmod(path.c_str(), enter);
}

TemporaryFolder::~TemporaryFolder()
{
    remove();
    if (lock >= 0) ::close(lock);
}

void TemporaryFolder::remove() const
{
    // Of programs that have just been killed one may still write.
    constexpr int tries = 20;
    std::error_code error;
    for (int i = 0; i < tries; ++i)
    {
        fs::remove_all(path, error);
        if (!error) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

int removeAbandonedFolders()
{
    int removed = 0;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(base(), error))
    {
        if (!entry.path().filename().string().starts_with(prefix)) continue;
        const int folder = openFolder(entry.path());
        if (folder < 0) continue;
        if (isAbandoned(folder))
        {
            fs::remove_all(entry.path(), error);
            removed += !error;
        }
        ::close(folder);
    }
    return removed;
}

} // namespace rt::grade
