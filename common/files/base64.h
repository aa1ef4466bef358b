// Bytes as text (RFC 4648), for files that hold binary data in text.
#pragma once

#include <string>
#include <string_view>

namespace rt
{

inline std::string base64(std::string_view bytes)
{
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        const auto byte = [&](std::size_t k) {
            return i + k < bytes.size() ? unsigned(static_cast<unsigned char>(bytes[i + k])) : 0U;
        };
        const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t k = 0; k < 4; ++k) text += k <= bytes.size() - i ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

} // namespace rt
