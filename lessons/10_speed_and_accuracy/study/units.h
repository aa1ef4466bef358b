// Quantities of the command line.
#pragma once

#include <string>

namespace rt::lesson10
{

/// "100ms", "1.5s", "1.5 s" in seconds, > 0. Throws std::invalid_argument with what was expected.
double parseTime(const std::string& text);

/// "60dB", "60 dB" in dB, > 0. Throws std::invalid_argument with what was expected.
double parseDecibels(const std::string& text);

/// "85.2 ms", "1.30 s": three digits and the unit that suits.
std::string timeText(double seconds);

/// "61.3 dB"; "same bits" if infinite.
std::string decibelText(double decibels);

} // namespace rt::lesson10
