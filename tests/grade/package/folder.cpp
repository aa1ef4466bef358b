#include <memory>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "common/program/spawn.h"
#include "tests/grade/package/archive.h"
#include "tests/grade/package/text.h"

namespace rt::grade
{

namespace
{

constexpr int deepest = 8; ///< downloads/homework/course/lessons/06_fresnel/exercise.h

/// Nothing is opened by a path of more than one name, so that no link on the way is followed.
std::string readAt(int folder, const char* name, const std::string& shown)
{
    // Not blocking, as a pipe would.
    const Descriptor file(::openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat state
    {
    };
    if (file.fd < 0 || ::fstat(file.fd, &state) != 0)
        throw Refused(fmt::format("{} is a link, or it cannot be opened", printable(shown)));
    if (!S_ISREG(state.st_mode)) throw Refused(fmt::format("{} is not a file", printable(shown)));
    std::string bytes(largestExercise + 1, '\0');
    std::size_t size = 0;
    while (size < bytes.size())
    {
        const auto got = ::read(file.fd, bytes.data() + size, bytes.size() - size);
        if (got < 0) throw Refused(fmt::format("{} cannot be read", printable(shown)));
        if (got == 0) break;
        size += std::size_t(got);
    }
    if (size > largestExercise) throw Refused(fmt::format("{} is larger than 256 KiB", printable(shown)));
    bytes.resize(size);
    return bytes;
}

struct CloseFolder
{
    void operator()(DIR* folder) const { ::closedir(folder); }
};

struct Walk
{
    const std::function<bool(const std::string&)>& isWanted;
    std::vector<std::string>& remarks;
    std::vector<PackedFile> files;
    int entries = 0;

    void folder(int fd, const std::string& path, int depth)
    {
        const std::unique_ptr<DIR, CloseFolder> list(::fdopendir(fd));
        if (!list)
        {
            ::close(fd);
            return;
        }
        while (const dirent* entry = ::readdir(list.get()))
        {
            const std::string name = entry->d_name;
            if (name == "." || name == "..") continue;
            if (++entries > mostEntries) throw Refused("the folder has more than 10,000 entries");
            const auto full = path.empty() ? name : path + "/" + name;
            struct stat state
            {
            };
            if (::fstatat(::dirfd(list.get()), name.c_str(), &state, AT_SYMLINK_NOFOLLOW) != 0) continue;
            if (S_ISDIR(state.st_mode))
            {
                const int inner = depth < deepest ? ::openat(::dirfd(list.get()), name.c_str(),
                                                             O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)
                                                  : -1;
                if (inner >= 0) folder(inner, full, depth + 1);
            }
            else if (isWanted(full))
                files.push_back({full, readAt(::dirfd(list.get()), name.c_str(), full)});
        }
    }
};

} // namespace

std::vector<PackedFile> filesInFolder(const std::string& path, const std::function<bool(const std::string&)>& isWanted,
                                      std::vector<std::string>& remarks)
{
    const int fd = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (fd < 0) throw Refused("the folder is a link, or it cannot be opened");
    Walk walk{isWanted, remarks, {}, 0};
    walk.folder(fd, "", 1);
    return walk.files;
}

std::string bytesOf(const std::string& path)
{
    return readAt(AT_FDCWD, path.c_str(), path.substr(path.rfind('/') + 1));
}

} // namespace rt::grade
