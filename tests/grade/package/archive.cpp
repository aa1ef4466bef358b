#include "tests/grade/package/archive.h"

#include <algorithm>
#include <memory>
#include <sstream>

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "common/program/spawn.h"
#include "tests/grade/package/text.h"

namespace rt::grade
{

namespace
{

using Reader = std::unique_ptr<archive, decltype(&archive_read_free)>;

Reader opened(const Descriptor& file)
{
    Reader reader(::archive_read_new(), &::archive_read_free);
    ::archive_read_support_filter_gzip(reader.get());
    ::archive_read_support_format_zip(reader.get());
    ::archive_read_support_format_tar(reader.get());
    constexpr std::size_t block = 64 << 10;
    if (::archive_read_open_fd(reader.get(), file.fd, block) != ARCHIVE_OK)
        throw Refused("the archive cannot be read: it is neither zip nor tar, or it is damaged");
    return reader;
}

std::string pathOf(archive_entry* entry)
{
    if (const char* raw = ::archive_entry_pathname(entry)) return raw;
    if (const char* utf8 = ::archive_entry_pathname_utf8(entry)) return utf8;
    return "";
}

bool leavesItsFolder(const std::string& path)
{
    if (path.empty()) return false;
    if (path[0] == '/' || path[0] == '\\') return true;
    if (path.size() > 1 && path[1] == ':') return true; // C:
    std::string parts = path;
    std::replace(parts.begin(), parts.end(), '\\', '/');
    std::istringstream all(parts);
    for (std::string part; std::getline(all, part, '/');)
        if (part == "..") return true;
    return false;
}

bool isOdd(const std::string& path)
{
    constexpr std::size_t longest = 500;
    return path.empty() || path.size() > longest || !isUtf8(path) || std::any_of(path.begin(), path.end(), [](char c) {
               return static_cast<unsigned char>(c) < ' ' || c == '\x7F';
           });
}

std::string contents(archive* reader, archive_entry* entry, const std::string& path)
{
    if (::archive_entry_is_encrypted(entry)) throw Refused(fmt::format("{} is encrypted", printable(path)));
    std::string bytes(largestExercise + 1, '\0');
    std::size_t size = 0;
    while (size < bytes.size())
    {
        const auto got = ::archive_read_data(reader, bytes.data() + size, bytes.size() - size);
        if (got == ARCHIVE_RETRY) continue;
        if (got < 0) throw Refused(fmt::format("{} cannot be unpacked: the archive is damaged", printable(path)));
        if (got == 0) break;
        size += std::size_t(got);
    }
    if (size > largestExercise) throw Refused(fmt::format("{} is larger than 256 KiB", printable(path)));
    bytes.resize(size);
    return bytes;
}

} // namespace

std::vector<PackedFile> filesInArchive(const std::string& path, const std::function<bool(const std::string&)>& isWanted,
                                       std::vector<std::string>& remarks)
{
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat state
    {
    };
    if (file.fd < 0 || ::fstat(file.fd, &state) != 0 || !S_ISREG(state.st_mode))
        throw Refused("the archive is no regular file, or it cannot be opened");
    if (std::size_t(state.st_size) > largestPackage) throw Refused("the archive is larger than 64 MiB");
    const auto reader = opened(file);
    std::vector<PackedFile> files;
    std::size_t expanded = 0;
    constexpr std::size_t mostRemarks = 5;
    const auto remark = [&](const std::string& text) {
        if (remarks.size() < mostRemarks) remarks.push_back(text);
    };
    for (int count = 0;; ++count)
    {
        archive_entry* entry = nullptr;
        const int got = ::archive_read_next_header(reader.get(), &entry);
        if (got == ARCHIVE_EOF) break;
        if (got == ARCHIVE_RETRY) continue;
        if (got < ARCHIVE_WARN) throw Refused("the archive is damaged");
        if (count == mostEntries) throw Refused("the archive has more than 10,000 entries");
        const auto entryPath = pathOf(entry);
        if (leavesItsFolder(entryPath))
            throw Refused(fmt::format("the archive has an entry outside its own folder: {}", printable(entryPath)));
        expanded += std::size_t(std::max<la_int64_t>(::archive_entry_size(entry), 0));
        if (expanded > largestPackage || std::size_t(::archive_filter_bytes(reader.get(), 0)) > 2 * largestPackage)
            throw Refused("the archive is larger than 64 MiB when it is unpacked");
        const bool isLink = ::archive_entry_hardlink(entry) || ::archive_entry_filetype(entry) == AE_IFLNK;
        const bool isFile = ::archive_entry_filetype(entry) == AE_IFREG && !isLink;
        if (::archive_entry_filetype(entry) == AE_IFDIR) continue;
        if (isOdd(entryPath))
        {
            remark(fmt::format("a file with an odd name is passed over: {}", printable(entryPath)));
            continue;
        }
        const bool wanted = isWanted(entryPath);
        if (wanted && !isFile)
            throw Refused(
                fmt::format("{} is {}, not a file", printable(entryPath), isLink ? "a link" : "something special"));
        if (!isFile) remark(fmt::format("a link or special file is passed over: {}", printable(entryPath)));
        if (wanted) files.push_back({entryPath, contents(reader.get(), entry, entryPath)});
    }
    return files;
}

} // namespace rt::grade
