#include "common/files/scene_text.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace rt
{

namespace
{

namespace fs = std::filesystem;

/// ", did you mean 'glass.toml'?", from the files of that kind in the folder of `path`.
std::string similarFile(const fs::path& path, const FileKind& kind)
{
    constexpr std::size_t most = 10000;
    std::vector<std::string> names;
    std::error_code error;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end && names.size() < most;
         entry.increment(error))
        if (std::ranges::count(kind.endings, entry->path().extension().string()))
            names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    return didYouMean(path.filename().string(), {names.begin(), names.end()});
}

[[noreturn]] void refuse(const std::string& path, const std::string& why)
{
    throw SceneError(fmt::format("{}: {}", path, why));
}

[[noreturn]] void refuseAsTooLarge(const std::string& path)
{
    refuse(path, fmt::format("too large, expected at most {} MiB", largestSceneFile >> 20));
}

[[noreturn]] void failAt(std::string_view text, std::size_t offset, const std::string& name, std::string_view sentence)
{
    const auto before = text.substr(0, offset);
    const auto lineStart = before.rfind('\n') + 1; // npos + 1 is 0, the first line
    const auto startsLetter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    throw SceneError(fmt::format(
        "{}:{}:{}: {}", name, 1 + std::count(before.begin(), before.end(), '\n'),
        1 + std::count_if(before.begin() + std::ptrdiff_t(lineStart), before.end(), startsLetter), sentence));
}

/// toml++ 3.3 notices, but gives the place of the letter before, which may be on another line.
void refuseOtherThanUtf8(std::string_view text, const std::string& name)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    for (std::size_t i = 0; i < text.size();)
    {
        const unsigned first = byte(i), second = byte(i + 1);
        const std::size_t length = first < 0x80   ? 1
                                   : first < 0xC2 ? 0
                                   : first < 0xE0 ? 2
                                   : first < 0xF0 ? 3
                                   : first < 0xF5 ? 4
                                                  : 0;
        // Neither longer than need be, nor half of a surrogate pair, nor beyond U+10FFFF.
        bool good = length > 0 && !(first == 0xE0 && second < 0xA0) && !(first == 0xED && second > 0x9F) &&
                    !(first == 0xF0 && second < 0x90) && !(first == 0xF4 && second > 0x8F);
        for (std::size_t k = 1; k < length; ++k) good = good && (byte(i + k) & 0xC0) == 0x80;
        if (!good) failAt(text, i, name, fmt::format("byte {:#04x} is not UTF-8, expected TOML in UTF-8", first));
        i += length;
    }
}

/// How many times, from the dot at `i` on, a name and one more dot follow. Bare names and both kinds of quoted ones count.
int dotsInChain(std::string_view text, std::size_t i, int most)
{
    const auto skipWhile = [&](auto isSkipped) {
        while (i < text.size() && isSkipped(text[i])) ++i;
    };
    const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
    const auto isBare = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };

    int dots = 0;
    while (i < text.size() && text[i] == '.' && dots < most)
    {
        ++dots;
        ++i;
        skipWhile(isBlank);
        if (i >= text.size()) break;
        if (const char quote = text[i]; quote == '"' || quote == '\'')
        {
            for (++i; i < text.size() && text[i] != quote && text[i] != '\n'; ++i)
                if (quote == '"' && text[i] == '\\') ++i;
            ++i;
        }
        else if (isBare(text[i]))
            skipWhile(isBare);
        else
            break;
        skipWhile(isBlank);
    }
    return dots;
}

/// toml++ 3.3 limits how deep values nest, but not how many names a key joins by dots, and each of them costs it stack:
/// `a.a.a` and so on for some ten thousand names would end the process. No scene joins more than three. Every dot is
/// tried, whatever it means where it stands, so that this need not know TOML.
void refuseLongKeys(std::string_view text, const std::string& name)
{
    constexpr int mostDots = 16;
    for (std::size_t dot = text.find('.'); dot != text.npos; dot = text.find('.', dot + 1))
        if (dotsInChain(text, dot, mostDots) == mostDots)
            failAt(text, dot, name, fmt::format("more than {} names are joined by dots, expected at most 3", mostDots));
}

} // namespace

void checkFile(const std::string& path, const FileKind& kind)
{
    std::error_code error;
    const auto type = fs::status(path, error).type();
    if (type == fs::file_type::not_found) refuse(path, "no such file" + similarFile(path, kind));
    if (type == fs::file_type::directory) refuse(path, fmt::format("this is a folder, expected {}", kind.words));
    if (type == fs::file_type::none) refuse(path, fmt::format("cannot be opened: {}", error.message()));
    if (type == fs::file_type::regular)
    {
        if (fs::file_size(path, error) > largestSceneFile && !error) refuseAsTooLarge(path);
    }
    else if (kind.mustBeRegular)
        refuse(path, fmt::format("not a regular file, expected {}", kind.words));
}

Text readText(const std::string& path, const FileKind& kind)
{
    checkFile(path, kind);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) refuse(path, fmt::format("cannot be opened: {}", std::strerror(errno)));
    std::setvbuf(file.get(), nullptr, _IONBF, 0);

    // Few and large steps, and memory that is not cleared first: the limit is reached well within a second. At most one
    // byte more than the limit is read: size and kind of a file may lie, as those of /dev/zero do.
    Text text;
    for (std::size_t room = std::size_t(1) << 16; text.size <= largestSceneFile; room *= 16)
    {
        room = std::min(room, largestSceneFile + 1);
        auto larger = std::make_unique_for_overwrite<char[]>(room);
        std::copy_n(text.bytes.get(), text.size, larger.get());
        text.bytes = std::move(larger);
        errno = 0;
        const std::size_t before = text.size;
        text.size += std::fread(text.bytes.get() + text.size, 1, room - text.size, file.get());
        const auto* zero = static_cast<const char*>(std::memchr(text.bytes.get() + before, 0, text.size - before));
        if (zero)
            refuse(path, fmt::format("not a text file, byte {} is zero; expected {}, at most {} MiB",
                                     zero - text.bytes.get() + 1, kind.words, largestSceneFile >> 20));
        if (std::ferror(file.get())) refuse(path, fmt::format("cannot be read: {}", std::strerror(errno)));
        if (text.size < room) return text;
    }
    refuseAsTooLarge(path);
}

void checkTomlText(std::string_view text, const std::string& name)
{
    refuseOtherThanUtf8(text, name);
    refuseLongKeys(text, name);
}

} // namespace rt
