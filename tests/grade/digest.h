// SHA-256, alone and keyed, by OpenSSL: names for submissions, and hidden questions that only the course can foresee.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace rt::grade
{

/// 64 hexadecimal digits in lower case. Throws std::runtime_error if OpenSSL refuses.
std::string sha256Hex(std::string_view bytes);

/// HMAC-SHA-256 (RFC 2104). Throws std::runtime_error if OpenSSL refuses.
std::array<unsigned char, 32> hmacSha256(std::string_view key, std::string_view message);

} // namespace rt::grade
