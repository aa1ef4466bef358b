// The source text of a tracer, as lines with the colours of their words.
#pragma once

#include <string>
#include <vector>

namespace rt::viz
{

enum class Ink
{
    plain,
    keyword,
    type,
    literal,
    comment,
    instrument ///< a call of the recorder: it only watches
};

/// A piece of one colour; pieces lie side by side and cover the line.
struct InkedText
{
    Ink ink = Ink::plain;
    std::string text;

    bool operator==(const InkedText&) const = default;
};

struct Listing
{
    std::string source;             ///< as the tree names it
    std::vector<std::string> lines; ///< valid UTF-8 without control characters; tabs are spaces
    std::vector<std::vector<InkedText>> inked;
    std::string missing; ///< why there are no lines; empty: there are
};

/// Each line without strings and comments, which are blanks: what can hold braces and names.
std::vector<std::string> codeOf(const Listing& listing);

/// Is it "// SOLUTION ...", "// END" or "// EXERCISE ...": a mark for make_exercises.py, which says nothing to readers?
bool isExerciseMark(const std::string& line);

/// First and last line, counted from 1.
struct LineRange
{
    int first = 1, last = 0;

    bool contains(int line) const { return line >= first && line <= last; }
};

/// The file `source` within the folder `root`. The name may come from anybody: files outside of the folder, of other kinds
/// than .h, .hpp and .cpp, or larger than 1 MiB are not read. Never throws; `missing` says in one sentence what is wrong.
Listing readListing(const std::string& source, const std::string& root);

/// The text of a tree's source; empty where readListing would refuse it.
std::string listingText(const std::string& source);

/// The same from text.
Listing listingOf(const std::string& text);

/// The function around a line, its head and its braces included; empty outside of functions.
LineRange functionAround(const Listing& listing, int line);

/// A row of a pane that shows a listing: a line, or the rest of one that is too long.
struct CodeRow
{
    int line = 0;
    bool isContinued = false;
    std::size_t column = 0;             ///< where its text begins
    std::vector<InkedText> pieces = {}; ///< without the blanks before that
};

/// All lines but exercises' marks, in rows of so many columns. `indent` columns of blanks are left out where a line has
/// them. What is too long goes on below, further in.
std::vector<CodeRow> codeRows(const Listing& listing, std::size_t columns, std::size_t indent = 0);

/// Which `count` rows to show so that the line is seen with what is around it in its function, and `also` (0: none) if
/// there is room for both. Returns the first one's place.
int firstShown(const std::vector<CodeRow>& rows, const LineRange& function, int line, int count, int also = 0);

} // namespace rt::viz
