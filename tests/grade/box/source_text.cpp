#include "tests/grade/box/source_text.h"

#include <map>
#include <regex>
#include <set>

#include <fmt/format.h>

namespace rt::grade
{

namespace
{

std::string joinedLines(const std::string& text)
{
    std::string joined;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        // The compiler joins lines even if blanks follow the backslash.
        if (text[i] == '\\')
        {
            const auto next = text.find_first_not_of(" \t\r\f\v", i + 1);
            if (next != std::string::npos && text[next] == '\n')
            {
                i = next;
                continue;
            }
        }
        joined += text[i];
    }
    return joined;
}

bool isWord(char c)
{
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Where a literal that starts at `from` ends, one past its last quote.
std::size_t endOfLiteral(const std::string& text, std::size_t from)
{
    const char quote = text[from];
    if (quote == '"' && from > 0 && text[from - 1] == 'R')
    {
        const auto open = text.find('(', from);
        if (open == std::string::npos) return text.size();
        const auto close = text.find(")" + text.substr(from + 1, open - from - 1) + "\"", open);
        return close == std::string::npos ? text.size() : close + (open - from) + 1;
    }
    for (auto i = from + 1; i < text.size() && text[i] != '\n'; ++i)
    {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == quote)
            return i + 1;
    }
    return text.size();
}

/// By the id of each todo("id"): the code of the innermost block that it stands in.
std::map<std::string, std::string> blocksOfTodos(const std::string& raw)
{
    const auto text = joinedLines(raw), code = codeOnly(raw); // of one length; in `code` the ids are blank
    const std::string mark = "todo(\"";
    std::map<std::string, std::string> blocks;
    for (auto at = code.find(mark); at != std::string::npos; at = code.find(mark, at + 1))
    {
        const auto name = at + mark.size(), nameEnd = text.find('"', name);
        int depth = 0;
        std::size_t from = at, to = at;
        while (from > 0 && depth >= 0) depth += code[--from] == '}' ? 1 : code[from] == '{' ? -1 : 0;
        for (depth = 0; to < code.size() && depth >= 0; ++to) depth += code[to] == '{' ? 1 : code[to] == '}' ? -1 : 0;
        if (nameEnd != std::string::npos)
            blocks[text.substr(name, nameEnd - name)] = squeezed(code.substr(from, to - from));
    }
    return blocks;
}

} // namespace

std::string codeOnly(const std::string& raw)
{
    std::string text = joinedLines(raw);
    const auto blank = [&](std::size_t from, std::size_t to) {
        for (; from < std::min(to, text.size()); ++from)
            if (text[from] != '\n') text[from] = ' ';
    };
    for (std::size_t i = 0; i < text.size();)
    {
        std::size_t end = i + 1;
        if (text.compare(i, 2, "//") == 0)
            blank(i, end = std::min(text.find('\n', i), text.size()));
        else if (text.compare(i, 2, "/*") == 0)
        {
            const auto close = text.find("*/", i + 2);
            blank(i, end = close == std::string::npos ? text.size() : close + 2);
        }
        else if (text[i] == '"' || (text[i] == '\'' && (i == 0 || !isWord(text[i - 1])))) // not 1'000
        {
            end = endOfLiteral(text, i);
            blank(i + 1, end - 1);
        }
        i = end;
    }
    return text;
}

std::string squeezed(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        const bool isBlank = c == ' ' || (c >= '\t' && c <= '\r');
        const bool wasBlank = !result.empty() && (result.back() == ' ' || result.back() == '\n');
        if (isBlank && wasBlank)
        {
            if (c == '\n') result.back() = '\n';
        }
        else
            result += c == '\n' ? '\n' : isBlank ? ' ' : c;
    }
    return result;
}

std::vector<std::string> remarksOn(const std::string& text, int lesson)
{
    const auto code = squeezed(codeOnly(text));
    std::set<std::string> names = {"glm"};
    static const std::regex alias(R"(namespace\s+(\w{1,40})\s*=\s*(?:::\s*)?glm\s*;)");
    constexpr std::size_t mostNames = 8;
    for (std::sregex_iterator found(code.begin(), code.end(), alias), end; found != end && names.size() < mostNames;
         ++found)
        names.insert((*found)[1]);
    std::vector<std::string> remarks;
    for (const char* function : {"reflect", "refract"})
        for (const auto& space : names)
            if (std::regex_search(code, std::regex(fmt::format(R"(\b{}\s*::\s*{}\b)", space, function))))
            {
                remarks.push_back(fmt::format("glm::{} is used", function));
                break;
            }
    static const std::regex all(R"(using\s+namespace\s+(?:::\s*)?glm\b)");
    if (std::regex_search(code, all)) remarks.push_back("using namespace glm: its reflect and refract may be used");
    static const std::regex asked(R"(\b(occluded|intersect)\s*\(([^;]{0,200});)");
    for (std::sregex_iterator found(code.begin(), code.end(), asked), end; lesson == 1 && found != end; ++found)
        if (const std::string arguments = (*found)[2]; arguments.find("*this") == std::string::npos)
        {
            remarks.push_back(
                fmt::format("scene.{} is asked without *this as its last argument: in lesson 01 the formulas are "
                            "yours, the scene has none of its own",
                            std::string((*found)[1])));
            break;
        }
    return remarks;
}

std::vector<std::string> todosLeft(const std::string& text, const std::string& handedOut)
{
    const auto written = blocksOfTodos(text), original = blocksOfTodos(handedOut);
    std::vector<std::string> ids;
    for (const auto& [id, block] : written)
        if (const auto at = original.find(id); at != original.end() && at->second != block) ids.push_back(id);
    return ids;
}

} // namespace rt::grade
