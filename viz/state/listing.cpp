#include "viz/state/listing.h"
#include "common/program/program.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace rt::viz
{

namespace
{

constexpr std::uintmax_t largestFile = 1 << 20; // bytes
constexpr std::size_t mostLines = 20000, longestLine = 400;

constexpr std::array keywords{"auto",     "break",    "case",     "class",     "concept",  "const",    "constexpr",
                              "continue", "default",  "do",       "else",      "enum",     "explicit", "false",
                              "for",      "if",       "inline",   "namespace", "noexcept", "nullptr",  "operator",
                              "private",  "public",   "requires", "return",    "sizeof",   "static",   "struct",
                              "switch",   "template", "this",     "throw",     "true",     "typename", "using",
                              "virtual",  "void",     "while"};
constexpr std::array types{"bool",  "char",  "double", "float", "int",  "long", "unsigned", "Color", "Hit",
                           "Light", "Point", "Ray",    "Real",  "vec3", "Vec3", "Scene",    "std"};

bool isWordStart(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

template <class Words>
bool contains(const Words& words, std::string_view word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Bytes of the UTF-8 character at `i`; 0 if there is none.
std::size_t characterAt(std::string_view text, std::size_t i)
{
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(k < text.size() ? text[k] : 0); };
    const unsigned char first = byte(i);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xC2 && first < 0xE0 ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((byte(i + k) & 0xC0) != 0x80) return 0;
    return length;
}

std::string cleaned(std::string_view line)
{
    std::string clean;
    for (std::size_t i = 0; i < line.size() && clean.size() < longestLine;)
    {
        const auto length = characterAt(line, i);
        if (line[i] == '\t')
            clean.append(4 - clean.size() % 4, ' ');
        else if (length == 0 || (length == 1 && (line[i] < 0x20 || line[i] == 0x7F)))
            clean += '?';
        else
            clean += line.substr(i, length);
        i += std::max<std::size_t>(length, 1);
    }
    return clean;
}

/// Appends to the line's last piece if it has the same colour. Blanks have any colour.
void add(std::vector<InkedText>& pieces, Ink ink, std::string_view text)
{
    const bool isBlank = text.find_first_not_of(' ') == std::string_view::npos;
    if (!pieces.empty() && (isBlank || pieces.back().ink == ink))
        pieces.back().text += text;
    else
        pieces.push_back({isBlank ? Ink::plain : ink, std::string(text)});
}

std::vector<InkedText> inkedLine(const std::string& line, bool& inComment)
{
    std::vector<InkedText> pieces;
    const auto text = std::string_view(line).find_first_not_of(' ');
    if (!inComment && text != std::string::npos && line.compare(text, 4, "rec.") == 0) return {{Ink::instrument, line}};
    if (!inComment && text != std::string::npos && line[text] == '#') return {{Ink::keyword, line}};
    for (std::size_t i = 0; i < line.size();)
    {
        std::size_t end = i + 1;
        Ink ink = Ink::plain;
        if (inComment || line.compare(i, 2, "/*") == 0)
        {
            const auto close = line.find("*/", inComment ? i : i + 2);
            inComment = close == std::string::npos;
            end = inComment ? line.size() : close + 2;
            ink = Ink::comment;
        }
        else if (line.compare(i, 2, "//") == 0)
        {
            end = line.size();
            ink = Ink::comment;
        }
        else if (line[i] == '"' || (line[i] == '\'' && (i == 0 || !isDigit(line[i - 1]))))
        {
            while (end < line.size() && line[end] != line[i]) end += line[end] == '\\' ? 2 : 1;
            end = std::min(end + 1, line.size());
            ink = Ink::literal;
        }
        else if (isWordStart(line[i]))
        {
            while (end < line.size() && (isWordStart(line[end]) || isDigit(line[end]))) ++end;
            const auto word = std::string_view(line).substr(i, end - i);
            ink = contains(keywords, word) ? Ink::keyword : contains(types, word) ? Ink::type : Ink::plain;
        }
        else if (isDigit(line[i]))
        {
            while (end < line.size() && (isWordStart(line[end]) || isDigit(line[end]) || line[end] == '.')) ++end;
            ink = Ink::literal;
        }
        add(pieces, ink, std::string_view(line).substr(i, end - i));
        i = end;
    }
    return pieces;
}

struct SourceText
{
    std::string text, missing;
};

std::string whyNotReadable(const std::filesystem::path& file, const std::filesystem::path& root)
{
    namespace fs = std::filesystem;
    std::error_code error;
    const auto extension = file.extension();
    if (extension != ".h" && extension != ".hpp" && extension != ".cpp") return "it is not a C++ file";
    const auto [left, right] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    if (left != root.end()) return "it lies outside of the project's folder";
    if (!fs::is_regular_file(file, error)) return "it is not a file";
    if (fs::file_size(file, error) > largestFile || error) return "it is larger than 1 MiB";
    return "";
}

SourceText readSource(const std::string& source, const std::string& root)
{
    namespace fs = std::filesystem;
    const SourceText unknown{"", "No source is known for this tree."};
    // A name with a zero byte would be cut off there.
    if (source.empty() || source.find('\0') != std::string::npos) return unknown;
    try
    {
        const auto folder = fs::canonical(root);
        std::error_code error;
        const auto file = fs::canonical(folder / source, error);
        auto why = error ? "there is no such file" : whyNotReadable(file, folder);
        if (why.empty())
        {
            std::ifstream in(file, std::ios::binary);
            std::string text(std::size_t(fs::file_size(file)), ' ');
            if (in.read(text.data(), std::streamsize(text.size()))) return {text, ""};
            why = "it cannot be read";
        }
        return {"", "No source can be shown for " + cleaned(source) + ": " + why + "."};
    }
    catch (const std::exception&) // a name too long, a folder that vanished, no memory
    {
        return unknown;
    }
}

/// The line without strings and comments: what can hold braces.
std::string code(const std::vector<InkedText>& pieces)
{
    std::string text;
    for (const auto& piece : pieces)
        text +=
            piece.ink == Ink::comment || piece.ink == Ink::literal ? std::string(piece.text.size(), ' ') : piece.text;
    return text;
}

/// Does the text before a brace open something that holds functions?
bool holdsFunctions(const std::string& head)
{
    for (std::size_t i = 0; i < head.size();)
    {
        if (!isWordStart(head[i]))
        {
            ++i;
            continue;
        }
        auto end = i;
        while (end < head.size() && (isWordStart(head[end]) || isDigit(head[end]))) ++end;
        const auto word = head.substr(i, end - i);
        // "const Hit& f(struct Ray ray) {" opens a function all the same.
        if (contains(std::array{"namespace", "struct", "class", "union", "enum", "extern"}, word)) return true;
        if (end < head.size() && head[end] == '(' && word != "template") return false;
        i = end;
    }
    return false;
}

} // namespace

Listing listingOf(const std::string& text)
{
    Listing listing;
    bool inComment = false;
    for (std::size_t start = 0; start < text.size() && listing.lines.size() < mostLines;)
    {
        const auto end = std::min(text.find('\n', start), text.size());
        auto line = std::string_view(text).substr(start, end - start);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        listing.lines.push_back(cleaned(line));
        listing.inked.push_back(inkedLine(listing.lines.back(), inComment));
        start = end + 1;
    }
    if (listing.lines.empty()) listing.missing = "The source is empty.";
    return listing;
}

Listing readListing(const std::string& source, const std::string& root)
{
    const auto [text, missing] = readSource(source, root);
    Listing listing;
    if (missing.empty())
        listing = listingOf(text);
    else
        listing.missing = missing;
    listing.source = cleaned(source);
    return listing;
}

std::string listingText(const std::string& source)
{
    return readSource(source, projectFile("")).text;
}

std::vector<std::string> codeOf(const Listing& listing)
{
    std::vector<std::string> lines;
    for (const auto& pieces : listing.inked) lines.push_back(code(pieces));
    return lines;
}

LineRange functionAround(const Listing& listing, int line)
{
    struct Block
    {
        bool holds = false;
        int headLine = 1;
    };
    std::vector<Block> open;
    std::string head;
    int headLine = 0; // 0: none has begun
    LineRange found;
    std::size_t functions = 0; // blocks of `open` that hold functions, before the first one that does not
    for (std::size_t i = 0; i < listing.inked.size(); ++i)
    {
        const int number = int(i) + 1;
        for (const char c : code(listing.inked[i]))
        {
            if (c == '{')
            {
                const bool holds = functions == open.size() && holdsFunctions(head);
                open.push_back({holds, headLine ? headLine : number});
                if (holds) ++functions;
            }
            else if (c == '}' && !open.empty())
            {
                const Block closed = open.back();
                open.pop_back();
                if (closed.holds)
                    --functions;
                else if (open.size() == functions)
                {
                    found = {closed.headLine, number};
                    if (found.contains(line)) return found;
                }
            }
            if (c == '{' || c == '}' || c == ';')
            {
                head.clear();
                headLine = 0;
                continue;
            }
            if (c != ' ' && headLine == 0) headLine = number;
            head += c;
        }
        head += ' ';
    }
    return {1, 0};
}

} // namespace rt::viz
