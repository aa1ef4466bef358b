#include "units.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rt::lesson10
{

namespace
{

/// A finite number greater than 0 and what follows it, spaces between them left out.
std::pair<double, std::string> quantity(const std::string& text, const char* expected)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !(value > 0 && std::isfinite(value)))
        throw std::invalid_argument(fmt::format("expected {}, got \"{}\"", expected, text));
    const auto unit = text.find_first_not_of(' ', std::size_t(end - text.data()));
    return {value, unit == std::string::npos ? "" : text.substr(unit)};
}

} // namespace

double parseTime(const std::string& text)
{
    constexpr const char* expected = "a time greater than 0 in ms or s, as in 100ms";
    const auto [value, unit] = quantity(text, expected);
    if (unit == "ms" && value / 1000 > 0) return value / 1000;
    if (unit == "s") return value;
    throw std::invalid_argument(fmt::format("expected {}, got \"{}\"", expected, text));
}

double parseDecibels(const std::string& text)
{
    constexpr const char* expected = "a number greater than 0 in dB, as in 60dB";
    const auto [value, unit] = quantity(text, expected);
    if (unit != "dB") throw std::invalid_argument(fmt::format("expected {}, got \"{}\"", expected, text));
    return value;
}

std::string timeText(double seconds)
{
    const double ms = seconds * 1e3;
    if (ms >= 999.5) return fmt::format("{:.2f} s", seconds);
    return fmt::format("{:.{}f} ms", ms, ms >= 99.95 ? 0 : ms >= 9.995 ? 1 : 2);
}

std::string decibelText(double decibels)
{
    return std::isinf(decibels) ? "same bits" : fmt::format("{:.1f} dB", decibels);
}

} // namespace rt::lesson10
