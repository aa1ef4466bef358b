#include "tests/grade/digest.h"

#include <gtest/gtest.h>

namespace rt::grade
{

namespace
{

// Test vectors of FIPS 180-2 and RFC 4231.
TEST(Digest, IsSha256)
{
    EXPECT_EQ(sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Digest, IsKeyedAsRfc2104Says)
{
    const auto hash = hmacSha256("Jefe", "what do ya want for nothing?");
    std::string hex;
    for (const unsigned char byte : hash)
        for (const int digit : {byte >> 4, byte & 15}) hex += "0123456789abcdef"[digit];
    EXPECT_EQ(hex, "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
}

} // namespace

} // namespace rt::grade
