#include "tests/grade/package/text.h"

#include <regex>
#include <stdexcept>

#include "tests/grade/box/source_text.h"

namespace rt::grade
{

namespace
{

using Byte = unsigned char;

void appendUtf8(std::string& to, char32_t c)
{
    if (c < 0x80)
        to += char(c);
    else if (c < 0x800)
        to += {char(0xC0 | (c >> 6)), char(0x80 | (c & 0x3F))};
    else if (c < 0x10000)
        to += {char(0xE0 | (c >> 12)), char(0x80 | ((c >> 6) & 0x3F)), char(0x80 | (c & 0x3F))};
    else
        to += {char(0xF0 | (c >> 18)), char(0x80 | ((c >> 12) & 0x3F)), char(0x80 | ((c >> 6) & 0x3F)),
               char(0x80 | (c & 0x3F))};
}

/// Without its mark.
std::string fromUtf16(std::string_view bytes, bool bigEnd)
{
    std::string text;
    const auto unit = [&](std::size_t i) {
        const auto first = Byte(bytes[i]), second = Byte(bytes[i + 1]);
        return char32_t(bigEnd ? first << 8 | second : second << 8 | first);
    };
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
    {
        char32_t c = unit(i);
        const bool isHigh = c >= 0xD800 && c < 0xDC00, isLow = c >= 0xDC00 && c < 0xE000;
        if (isHigh && i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000)
        {
            c = 0x10000 + ((c - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
            i += 2;
        }
        else if (isHigh || isLow)
            c = 0xFFFD;
        appendUtf8(text, c);
    }
    return text;
}

/// How many bytes the character at i has; 0: it is none.
std::size_t characterAt(std::string_view text, std::size_t i)
{
    const auto first = Byte(text[i]);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || i + length > text.size()) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((Byte(text[i + k]) & 0xC0) != 0x80) return 0;
    const auto second = Byte(text[i + 1]);
    const bool isOverlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool isOutside = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
    return isOverlong || isOutside ? 0 : length;
}

} // namespace

bool isUtf8(std::string_view text)
{
    for (std::size_t i = 0; i < text.size();)
    {
        const auto length = characterAt(text, i);
        if (length == 0) return false;
        i += length;
    }
    return true;
}

std::string printable(std::string_view name)
{
    constexpr std::size_t longest = 100;
    std::string text;
    for (std::size_t i = 0; i < name.size() && text.size() < longest;)
    {
        const auto length = characterAt(name, i);
        const bool isControl =
            Byte(name[i]) < ' ' || name[i] == '\x7F' || (Byte(name[i]) == 0xC2 && Byte(name[i + 1]) < 0xA0);
        text += length == 0 || isControl ? "?" : std::string(name.substr(i, length));
        i += length == 0 ? 1 : length;
    }
    return text;
}

std::string normalisedText(std::string_view bytes, std::vector<std::string>& remarks)
{
    std::string text;
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    {
        text = fromUtf16(bytes.substr(2), bytes[0] == '\xFE');
        remarks.push_back("the file was in UTF-16 and has been converted to UTF-8");
    }
    else
    {
        if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
        if (bytes.find('\0') == std::string_view::npos && !isUtf8(bytes))
        {
            for (const char c : bytes) appendUtf8(text, Byte(c));
            remarks.push_back("the file was not in UTF-8; it has been read as Latin-1");
        }
        else
            text = bytes;
    }
    if (text.find('\0') != std::string::npos) throw std::runtime_error("it has zero bytes: it is no text");
    std::string lines;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
        lines += text[i] == '\r' ? '\n' : text[i];
    }
    if (!lines.empty() && lines.back() != '\n') lines += '\n';
    return lines;
}

std::optional<int> lessonOf(const std::string& text)
{
    std::smatch found;
    const auto code = squeezed(codeOnly(text));
    static const std::regex space(R"(\bnamespace\s(?:rt\s?::\s?)?exercise(\d\d)\b)");
    if (std::regex_search(code, found, space)) return std::stoi(found[1]);
    constexpr std::size_t first = 500;
    const auto start = text.substr(0, first);
    static const std::regex comment(R"((?:^|\n)//\s*[Ee]xercise\s(\d\d)\b)");
    if (std::regex_search(start, found, comment)) return std::stoi(found[1]);
    return std::nullopt;
}

} // namespace rt::grade
