// Text within HTML, SVG and XML.
#pragma once

#include <string>
#include <string_view>

namespace rt
{

/// Text that stands for itself between tags and in quoted values of attributes: none of it is markup.
inline std::string escapedMarkup(std::string_view text)
{
    std::string result;
    result.reserve(text.size() + text.size() / 16);
    for (const char c : text) switch (c)
        {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += c;
        }
    return result;
}

} // namespace rt
