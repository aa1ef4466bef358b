// Whatever encoding an editor wrote: UTF-8 with LF.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt::grade
{

/// Without byte order mark, lines ended by LF; UTF-16 with a mark and Latin-1 are converted, which `remarks` then says. Throws
/// std::runtime_error with one sentence if it is no text: it has zero bytes.
std::string normalisedText(std::string_view bytes, std::vector<std::string>& remarks);

bool isUtf8(std::string_view text);

/// For a sentence: control characters and bytes that are no UTF-8 become '?', and it is cut at 100 bytes.
std::string printable(std::string_view name);

/// Which lesson the file says it belongs to, by "// Exercise 06" in its first lines or by `exercise06` after `namespace`.
std::optional<int> lessonOf(const std::string& text);

} // namespace rt::grade
