// The files that a scene is made of: finding them, reading their bytes, and words for messages about them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "common/base/nearest_word.h"
#include "common/files/scene_file.h"

namespace rt
{

/// Foreign text for a message: without line breaks and other control characters, and not longer than about `most` bytes.
inline std::string onOneLine(std::string_view text, std::size_t most = 60)
{
    std::string result;
    for (const char c : text)
    {
        const auto byte = static_cast<unsigned char>(c);
        const bool startsLetter = (byte & 0xC0) != 0x80;
        if (startsLetter && result.size() >= most) return result + "...";
        if (byte < 0x20 || byte == 0x7F)
            result += fmt::format("\\x{:02x}", byte);
        else
            result += c;
    }
    return result;
}

inline std::string inQuotes(std::string_view text)
{
    return "'" + onOneLine(text) + "'";
}

/// "'a', 'b' or 'c'"; of many words only the first.
inline std::string listed(const std::vector<std::string_view>& words, const char* conjunction)
{
    constexpr std::size_t most = 20;
    std::string result;
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        if (i == most) return result + fmt::format(" {} {} more", conjunction, words.size() - most);
        if (i > 0) result += i + 1 == words.size() ? fmt::format(" {} ", conjunction) : ", ";
        result += inQuotes(words[i]);
    }
    return result;
}

/// ", did you mean 'color'?", or "" if no word is near.
inline std::string didYouMean(std::string_view word, const std::vector<std::string_view>& words)
{
    const auto nearest = nearestWord(word, words);
    return nearest.empty() ? "" : fmt::format(", did you mean {}?", inQuotes(nearest));
}

/// What a file is expected to be.
struct FileKind
{
    const char* words;                     ///< completes the sentence "expected ..."
    std::vector<std::string_view> endings; ///< of the files among which a similar name is sought
    bool mustBeRegular = true;             ///< neither a pipe nor a device
};

/// Throws SceneError, `path: why`, if there is no such file, or it is a folder, or too large, or not regular.
void checkFile(const std::string& path, const FileKind& kind);

struct Text
{
    std::unique_ptr<char[]> bytes;
    std::size_t size = 0;
    operator std::string_view() const { return {bytes.get(), size}; }
};

/// The whole file, after checkFile. Throws SceneError, `path: why`.
Text readText(const std::string& path, const FileKind& kind);

/// Refuses, with its place, what toml++ must not see: bytes that are not UTF-8, and keys of very many names.
void checkTomlText(std::string_view text, const std::string& name);

} // namespace rt
