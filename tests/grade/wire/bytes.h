// Numbers as bytes and back. Both ways have the same face, so that one list of fields serves both. For the student's
// process too: core headers and the standard library only.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "common/base/image.h"

namespace rt::grade
{

/// Bytes that are not what they should be: one sentence without a full stop.
struct FrameError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

inline constexpr std::size_t longestText = 4096;   ///< bytes of one name or message
inline constexpr int largestPictureSide = 1 << 14; ///< pixels

static_assert(std::endian::native == std::endian::little,
              "both ends are the same machine, and frames are little-endian");

class Writer;
class Reader;
template <class Wire, class T>
void carry(Wire& wire, T& value);

/// Appends values to `bytes`. Throws FrameError if a text is too long.
class Writer
{
public:
    static constexpr bool reads = false;
    std::string bytes;

    template <class Plain>
    void plain(const Plain& value)
    {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    }
    void flag(bool value) { plain(std::uint8_t(value)); }
    void text(const std::string& value)
    {
        if (value.size() > longestText)
            throw FrameError("a text is longer than " + std::to_string(longestText) + " bytes");
        plain(std::uint32_t(value.size()));
        bytes += value;
    }
    template <class Enum>
    void choice(Enum value, Enum)
    {
        plain(std::uint8_t(value));
    }
    template <class T>
    void list(const std::vector<T>& values)
    {
        plain(std::uint32_t(values.size()));
        for (const auto& value : values) carry(*this, value);
    }
    template <class T>
    void optional(const std::optional<T>& value)
    {
        flag(value.has_value());
        if (value) carry(*this, *value);
    }
    void image(const Image& value)
    {
        plain(std::int32_t(value.width));
        plain(std::int32_t(value.height));
        for (const auto& pixel : value.pixels)
            for (int i = 0; i < 3; ++i) plain(pixel[i]);
    }
};

/// How many bytes a T has at least: those of an empty one.
template <class T>
std::size_t leastBytes()
{
    Writer writer;
    const T value{};
    carry(writer, value);
    return writer.bytes.size();
}

/// Takes values off the front. Total: throws FrameError, whatever the bytes are, and allocates no more than a small
/// multiple of them.
class Reader
{
public:
    static constexpr bool reads = true;
    explicit Reader(std::string_view bytes) : left(bytes) {}

    template <class Plain>
    void plain(Plain& value)
    {
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
    }
    void flag(bool& value)
    {
        std::uint8_t byte = 0;
        plain(byte);
        if (byte > 1) throw FrameError("a truth value is " + std::to_string(byte) + ", expected 0 or 1");
        value = byte;
    }
    void text(std::string& value)
    {
        std::uint32_t size = 0;
        plain(size);
        if (size > longestText)
            throw FrameError("a text has " + std::to_string(size) + " bytes, at most " + std::to_string(longestText) +
                             " may be");
        value = take(size);
    }
    template <class Enum>
    void choice(Enum& value, Enum last)
    {
        std::uint8_t byte = 0;
        plain(byte);
        if (int(byte) > int(last))
            throw FrameError("a choice is " + std::to_string(byte) + ", expected at most " + std::to_string(int(last)));
        value = Enum(byte);
    }
    template <class T>
    void list(std::vector<T>& values)
    {
        std::uint32_t count = 0;
        plain(count);
        if (count > left.size() / leastBytes<T>())
            throw FrameError("a list of " + std::to_string(count) + " entries does not fit the " +
                             std::to_string(left.size()) + " bytes that are left");
        values.clear();
        values.reserve(count);
        for (std::uint32_t i = 0; i < count; ++i) carry(*this, values.emplace_back());
    }
    template <class T>
    void optional(std::optional<T>& value)
    {
        bool present = false;
        flag(present);
        value.reset();
        if (present) carry(*this, value.emplace());
    }
    void image(Image& value)
    {
        std::int32_t width = 0, height = 0;
        plain(width);
        plain(height);
        if (width < 0 || height < 0 || width > largestPictureSide || height > largestPictureSide)
            throw FrameError("a picture is " + std::to_string(width) + "x" + std::to_string(height) + " pixels");
        const auto count = std::size_t(width) * std::size_t(height);
        if (count > left.size() / (3 * sizeof(double)))
            throw FrameError("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                             " pixels does not fit the " + std::to_string(left.size()) + " bytes that are left");
        value = Image(width, height);
        for (auto& pixel : value.pixels)
            for (int i = 0; i < 3; ++i) plain(pixel[i]);
    }

    /// Nothing may be left.
    void end() const
    {
        if (!left.empty()) throw FrameError(std::to_string(left.size()) + " bytes are too many");
    }

private:
    std::string_view left;

    std::string_view take(std::size_t count)
    {
        if (count > left.size())
            throw FrameError("it ends too early: " + std::to_string(count) + " bytes were expected, " +
                             std::to_string(left.size()) + " are left");
        const auto taken = left.substr(0, count);
        left.remove_prefix(count);
        return taken;
    }
};

namespace detail
{

template <class T>
inline constexpr bool isPlain = std::is_same_v<T, double> || std::is_same_v<T, int>;
template <class T>
inline constexpr bool isList = false;
template <class T>
inline constexpr bool isList<std::vector<T>> = true;
template <class T>
inline constexpr bool isOptional = false;
template <class T>
inline constexpr bool isOptional<std::optional<T>> = true;
template <class T>
inline constexpr bool isPair = false;
template <class A, class B>
inline constexpr bool isPair<std::pair<A, B>> = true;
template <class T>
inline constexpr bool isArray = false;
template <class T, std::size_t size>
inline constexpr bool isArray<std::array<T, size>> = true;

} // namespace detail

/// Writes or reads one value. A Writer takes it as const.
template <class Wire, class T>
void carry(Wire& wire, T& value)
{
    using Value = std::remove_const_t<T>;
    if constexpr (detail::isPlain<Value>)
        wire.plain(value);
    else if constexpr (std::is_same_v<Value, bool>)
        wire.flag(value);
    else if constexpr (std::is_same_v<Value, std::string>)
        wire.text(value);
    else if constexpr (std::is_same_v<Value, Image>)
        wire.image(value);
    else if constexpr (std::is_same_v<Value, Vec3<double>>)
        for (int i = 0; i < 3; ++i) wire.plain(value[i]);
    else if constexpr (std::is_same_v<Value, glm::dvec2>)
        for (int i = 0; i < 2; ++i) wire.plain(value[i]);
    else if constexpr (detail::isList<Value>)
        wire.list(value);
    else if constexpr (detail::isOptional<Value>)
        wire.optional(value);
    else if constexpr (detail::isPair<Value>)
    {
        carry(wire, value.first);
        carry(wire, value.second);
    }
    else if constexpr (detail::isArray<Value>)
        for (auto& one : value) carry(wire, one);
    else
        fields(wire, value);
}

} // namespace rt::grade
