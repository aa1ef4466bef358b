#include "tests/grade/report/text.h"

#include <cstdint>
#include <iterator>

#include <fmt/format.h>
#include <utf8.h>

namespace rt::grade
{

namespace
{

constexpr char32_t escape = 0x1b, bell = 0x07, replacement = 0xfffd;
constexpr std::size_t longestNote = 64, longestName = 200;

/// Turns what follows around, or is not seen at all, so that text does not read as it stands. (The joiners of scripts
/// and emoji, U+200C and U+200D, are not among them.)
bool isInvisible(char32_t c)
{
    return c == 0x00ad || c == 0x034f || c == 0x061c || c == 0x180e || c == 0x200b || c == 0x200e || c == 0x200f ||
           (c >= 0x202a && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff ||
           (c >= 0xfff9 && c <= 0xfffb) || (c >= 0xe0000 && c <= 0xe0fff);
}

bool isControl(char32_t c)
{
    return c < 0x20 || (c >= 0x7f && c <= 0x9f);
}

/// XML has no way to write U+FFFE and U+FFFF; the others like them are no characters either.
bool isNoCharacter(char32_t c)
{
    return (c & 0xfffe) == 0xfffe || (c >= 0xfdd0 && c <= 0xfdef);
}

/// Behind a terminal's sequence that starts at `at`, which is an escape character. What does not end on its line is not one.
std::size_t behindSequence(std::u32string_view text, std::size_t at)
{
    std::size_t i = at + 1;
    if (i == text.size()) return i;
    const char32_t kind = text[i];
    if (kind == U'[')
    {
        for (++i; i < text.size() && text[i] >= 0x20 && text[i] <= 0x3f;) ++i;
        return i < text.size() && text[i] >= 0x40 && text[i] <= 0x7e ? i + 1 : i;
    }
    if (kind == U']' || kind == U'P' || kind == U'X' || kind == U'^' || kind == U'_')
    {
        for (++i; i < text.size() && text[i] != U'\n' && text[i] != U'\r'; ++i)
        {
            if (text[i] == bell) return i + 1;
            if (text[i] == escape) return i + 1 < text.size() && text[i + 1] == U'\\' ? i + 2 : i;
        }
        return at + 2;
    }
    return kind >= 0x20 && kind <= 0x7e ? i + 1 : i;
}

std::u32string decoded(std::string_view bytes)
{
    const std::string text = repaired(bytes);
    std::u32string points;
    points.reserve(text.size());
    utf8::unchecked::utf8to32(text.begin(), text.end(), std::back_inserter(points));
    return points;
}

std::string clean(std::string_view bytes, std::size_t limit, bool oneLine)
{
    const std::u32string text = decoded(bytes);
    std::string result;
    std::size_t kept = 0; // of result, if it must be cut
    for (std::size_t i = 0; i < text.size() && result.size() <= limit;)
    {
        char32_t c = text[i];
        if (c == escape)
        {
            i = behindSequence(text, i);
            continue;
        }
        ++i;
        if (c == U'\r' && i < text.size() && text[i] == U'\n') continue;
        if (c == U'\r' || c == 0x85 || c == 0x2028 || c == 0x2029) c = U'\n';
        if (oneLine && (c == U'\n' || c == U'\t')) c = U' ';
        if ((isControl(c) && c != U'\n' && c != U'\t') || isInvisible(c)) continue;
        if (isNoCharacter(c)) c = replacement;
        utf8::unchecked::append(c, std::back_inserter(result));
        if (result.size() + longestNote <= limit) kept = result.size();
    }
    if (result.size() <= limit) return result;
    result.resize(kept);
    return result + fmt::format("{}[cut here, of {} bytes]", oneLine ? ' ' : '\n', bytes.size());
}

} // namespace

std::string repaired(std::string_view bytes)
{
    std::string result;
    utf8::replace_invalid(bytes.begin(), bytes.end(), std::back_inserter(result), replacement);
    return result;
}

std::string cleanText(std::string_view bytes, std::size_t limit)
{
    return clean(bytes, limit, false);
}

std::string cleanLine(std::string_view bytes, std::size_t limit)
{
    return clean(bytes, limit, true);
}

std::string pageName(std::string_view student)
{
    std::string name;
    const auto coded = [&](std::string_view bytes) {
        for (const char c : bytes) name += fmt::format("={:02X}", static_cast<unsigned char>(c));
    };
    for (auto at = student.begin(); at != student.end();)
    {
        auto next = at;
        char32_t c = 0;
        bool bad = false;
        try
        {
            c = utf8::next(next, student.end());
        }
        catch (const utf8::exception&)
        {
            bad = true;
            next = at + 1;
        }
        const bool plain = (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || (c >= U'0' && c <= U'9') ||
                           c == U'_' || ((c == U'-' || c == U'.') && !name.empty());
        const bool visible = c > 0xa0 && !isInvisible(c) && !isNoCharacter(c) && c != 0x2028 && c != 0x2029;
        const std::string_view bytes(&*at, std::size_t(next - at));
        if (!bad && (plain || visible))
            name += bytes;
        else
            coded(bytes);
        at = next;
    }
    if (name.empty()) return "=";
    if (name.size() <= longestName) return name;
    // FNV-1a: no secret is at stake, two long names must only differ.
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : student) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    name.resize(longestName - 24);
    return repaired(name) + fmt::format("=x{:016x}", hash);
}

} // namespace rt::grade
