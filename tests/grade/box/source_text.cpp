#include "tests/grade/box/source_text.h"

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

std::string unsafeToCompile(const std::string& text)
{
    const std::string tail = ", which is refused where bubblewrap cannot run";
    constexpr std::size_t longest = 1000;
    std::size_t length = 0;
    for (const char c : joinedLines(text))
        if ((length = c == '\n' ? 0 : length + 1) > longest)
            return "exercise.h has a line of more than 1000 characters" + tail;
    const auto code = codeOnly(text);
    static const std::regex assembler(R"(\b(asm|__asm|__asm__)\b)"), pasting("##|%:%:"),
        digraph(R"((^|\n)[ \t]*(%:|\?\?=))");
    if (std::regex_search(code, assembler)) return "exercise.h contains assembler" + tail;
    if (std::regex_search(code, pasting)) return "exercise.h joins words with ##" + tail;
    if (std::regex_search(code, digraph)) return "exercise.h writes %: for #" + tail;
    // A raw string may hold what looks like a directive; refusing it is simpler than being right about it.
    static const std::regex directive(R"((^|\n)[ \t\f\v]*#[ \t\f\v]*([a-z_]*)([^\n]*))");
    // The name between quotes is blanked in `code`, so the text without comments only is asked for it.
    const auto lines = joinedLines(text);
    for (std::sregex_iterator found(code.begin(), code.end(), directive), end; found != end; ++found)
    {
        const std::string word = (*found)[2];
        if (word == "embed" || word == "import" || word == "include_next" || word == "pragma")
        {
            if (word == "pragma" && std::regex_match((*found)[3].str(), std::regex(R"(\s+once\s*)"))) continue;
            return fmt::format("exercise.h contains #{}{}", word, tail);
        }
    }
    static const std::regex include(R"(#[ \t\f\v]*include\b([^\n]*))");
    static const std::regex plain(
        R"(\s*(?:"(?:common|lessons)/[\w/]+\.h"|<(?:glm/)?\w+(?:/\w+)*(?:\.h|\.hpp)?>)\s*(?://.*|/\*.*)?)");
    for (std::sregex_iterator found(lines.begin(), lines.end(), include), end; found != end; ++found)
        if (!std::regex_match((*found)[1].str(), plain))
            return "exercise.h includes a file that is neither ours nor the standard library's" + tail;
    // `# /* */ include` is not seen above; in `code` its comment is blank.
    static const std::regex any(R"(#[ \t\f\v]*include\b)");
    const auto count = [&](const std::string& where) {
        return std::distance(std::sregex_iterator(where.begin(), where.end(), any), std::sregex_iterator());
    };
    if (count(code) > count(lines)) return "exercise.h hides an #include" + tail;
    return "";
}

} // namespace rt::grade
