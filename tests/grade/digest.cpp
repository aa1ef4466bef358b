#include "tests/grade/digest.h"

#include <stdexcept>

#include <openssl/evp.h>
#include <openssl/hmac.h>

namespace rt::grade
{

std::string sha256Hex(std::string_view bytes)
{
    std::array<unsigned char, 32> hash{};
    if (EVP_Digest(bytes.data(), bytes.size(), hash.data(), nullptr, EVP_sha256(), nullptr) != 1)
        throw std::runtime_error("OpenSSL refuses to compute SHA-256");
    std::string hex;
    for (const unsigned char byte : hash)
        for (const int digit : {byte >> 4, byte & 15}) hex += "0123456789abcdef"[digit];
    return hex;
}

std::array<unsigned char, 32> hmacSha256(std::string_view key, std::string_view message)
{
    std::array<unsigned char, 32> hash{};
    const auto* bytes = reinterpret_cast<const unsigned char*>(message.data());
    if (!HMAC(EVP_sha256(), key.data(), int(key.size()), bytes, message.size(), hash.data(), nullptr))
        throw std::runtime_error("OpenSSL refuses to compute HMAC-SHA-256");
    return hash;
}

} // namespace rt::grade
