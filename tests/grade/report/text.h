// Foreign text: what students wrote, printed or named. It is made harmless here once, whatever it is put into afterwards.
#pragma once

#include <string>
#include <string_view>

namespace rt::grade
{

/// Bytes of foreign text that a report shows; the rest is cut off, with a note.
inline constexpr std::size_t textLimit = 4096;

/// Well-formed UTF-8: each malformed sequence becomes U+FFFD. Nothing else is changed.
std::string repaired(std::string_view bytes);

/// Text of several lines that may be shown: well-formed UTF-8 of at most `limit` bytes, the note of a cut included.
/// Control characters, terminal sequences, bidirectional controls and invisible characters are removed; line ends become
/// "\n", tabs stay. Cleaning twice changes nothing.
std::string cleanText(std::string_view bytes, std::size_t limit = textLimit);

/// The same on one line: ends of lines and tabs become spaces.
std::string cleanLine(std::string_view bytes, std::size_t limit = textLimit);

/// A name of a file for the student's pages: letters, digits and anything that is visible and not ASCII stay, other bytes
/// become "=2F". Two students never share one, and none is "", hidden, or longer than 200 bytes.
std::string pageName(std::string_view student);

} // namespace rt::grade
