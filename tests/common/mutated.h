// Texts with a few random faults, for readers that are to survive anything.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace rt
{

/// The text with 1 to `mostChanges` changes: bytes replaced, up to `longest` of them removed or repeated, a token put in,
/// the end cut off.
inline std::string mutated(std::string text, std::mt19937& random, const std::vector<std::string>& tokens,
                           std::size_t mostChanges, std::size_t longest)
{
    const auto below = [&](std::size_t n) { return std::size_t(random()) % n; };
    for (std::size_t changes = 1 + below(mostChanges); changes > 0 && !text.empty(); --changes)
    {
        const std::size_t at = below(text.size()), length = below(std::min(longest, text.size() - at) + 1);
        switch (below(6))
        {
        case 0:
            text[at] = char(random());
            break;
        case 1:
            text[at] = char(text[at] ^ (1 << below(8)));
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(below(text.size()), text.substr(at, length));
            break;
        case 4:
            text.insert(at, tokens[below(tokens.size())]);
            break;
        default:
            text.resize(at);
            break;
        }
    }
    return text;
}

} // namespace rt
