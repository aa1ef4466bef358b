#include <algorithm>

#include "viz/state/listing.h"
#include "viz/state/node_text.h"

namespace rt::viz
{

namespace
{

constexpr std::size_t hangingIndent = 8; // as clang-format continues a statement

/// Bytes of the text's first `count` characters.
std::size_t bytesOf(const std::string& text, std::size_t count)
{
    std::size_t byte = 0;
    const auto isContinuation = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80; };
    for (std::size_t seen = 0; byte < text.size(); ++byte)
        if (!isContinuation(byte) && seen++ == count) break;
    return byte;
}

/// Where to end a row of at most `room` characters: at a blank, unless that leaves it nearly empty. In bytes.
std::size_t breakOf(const std::string& text, std::size_t room)
{
    const auto limit = bytesOf(text, room);
    const auto blank = text.rfind(' ', limit);
    return blank == std::string::npos || blank < limit / 3 ? limit : blank;
}

/// What stands in bytes [from, to) of the line.
std::vector<InkedText> cut(const std::vector<InkedText>& pieces, std::size_t from, std::size_t to)
{
    std::vector<InkedText> part;
    std::size_t at = 0;
    for (const auto& [ink, text] : pieces)
    {
        const auto begin = std::max(at, from), end = std::min(at + text.size(), to);
        if (begin < end) part.push_back({ink, text.substr(begin - at, end - begin)});
        at += text.size();
    }
    return part;
}

} // namespace

bool isExerciseMark(const std::string& line)
{
    const auto start = line.find_first_not_of(' ');
    if (start == std::string::npos) return false;
    const auto text = std::string_view(line).substr(start);
    const auto isOf = [&](std::string_view mark) {
        return text.starts_with(mark) && (text.size() == mark.size() || text[mark.size()] == ' ');
    };
    return isOf("// SOLUTION") || isOf("// END") || isOf("// EXERCISE:") || isOf("// EXERCISE-FROM");
}

std::vector<CodeRow> codeRows(const Listing& listing, std::size_t columns, std::size_t indent)
{
    columns = std::max<std::size_t>(columns, 16);
    std::vector<CodeRow> rows;
    for (std::size_t i = 0; i < listing.lines.size(); ++i)
    {
        const auto& line = listing.lines[i];
        if (isExerciseMark(line)) continue;
        CodeRow row{.line = int(i) + 1};
        auto start = std::min(line.find_first_not_of(' '), line.size());
        row.column = std::min(start - std::min(start, indent), columns / 2);
        const auto hanging = std::min(row.column + hangingIndent, columns / 2);
        while (characters(line.substr(start)) > columns - row.column)
        {
            const auto end = start + breakOf(line.substr(start), columns - row.column);
            row.pieces = cut(listing.inked[i], start, end);
            rows.push_back(row);
            start = std::min(line.find_first_not_of(' ', end), line.size());
            row.isContinued = true;
            row.column = hanging;
        }
        row.pieces = cut(listing.inked[i], start, line.size());
        if (!row.isContinued || !row.pieces.empty()) rows.push_back(row);
    }
    return rows;
}

int firstShown(const std::vector<CodeRow>& rows, const LineRange& function, int line, int count, int also)
{
    const int all = int(rows.size());
    // A line that is not shown stands where the next one does.
    const auto firstOf = [&](int number) {
        return int(std::lower_bound(rows.begin(), rows.end(), number,
                                    [](const CodeRow& row, int wanted) { return row.line < wanted; }) -
                   rows.begin());
    };
    const auto lastOf = [&](int number) { return std::max(firstOf(number), firstOf(number + 1) - 1); };
    const auto clampToText = [&](int first) { return std::clamp(first, 0, std::max(0, all - count)); };
    const bool isInside = function.contains(line);
    const int head = firstOf(function.first), tail = lastOf(function.last), length = tail - head + 1;
    if (isInside && length <= count) return clampToText(head - std::min(2, (count - length) / 2));
    const int at = firstOf(line), end = lastOf(line);
    int first = at - count * 2 / 5;
    if (isInside) first = std::clamp(first, head, std::max(head, tail - count + 1));
    // Both with a row around them.
    if (also > 0)
    {
        const int upper = std::min(at, firstOf(also)), lower = std::max(end, lastOf(also));
        if (lower - upper + 3 <= count) first = std::clamp(first, lower - count + 2, upper - 1);
    }
    // Of a line in several rows the last one too, if they have room.
    first = std::clamp(first, std::min(at, end - count + 1), at);
    return clampToText(first);
}

} // namespace rt::viz
