#include "tests/grade/box/compiler_messages.h"

#include <regex>
#include <sstream>

#include <fmt/format.h>

namespace rt::grade
{

namespace
{

std::string without(std::string text, const std::vector<std::string>& folders)
{
    for (const auto& folder : folders)
        for (std::size_t place = 0; (place = text.find(folder + "/", place)) != std::string::npos;)
            text.erase(place, folder.size() + 1);
    return text;
}

bool contains(const std::string& line, const char* what)
{
    return line.find(what) != std::string::npos;
}

} // namespace

std::vector<std::string> errorsIn(const std::string& output, const std::vector<std::string>& ours)
{
    constexpr std::size_t most = 20, mostAbout = 4, longest = 1000;
    std::vector<std::string> errors, before;
    std::size_t about = 0;
    std::istringstream lines(without(output, ours));
    for (std::string line; std::getline(lines, line);)
    {
        line = line.substr(0, longest);
        const bool isHere = line.rfind("exercise.h:", 0) == 0;
        if (contains(line, "error: ") || contains(line, "undefined reference") || contains(line, "multiple definition"))
        {
            if (errors.size() == most) break;
            // An error in one of our files is told with the place that led there.
            std::string told = line;
            if (!isHere)
                for (const auto& one : before) told += "\n" + one;
            errors.push_back(told);
            before.clear();
            about = 0;
        }
        else if (isHere && contains(line, "required from") && before.size() < mostAbout)
            before.push_back(line);
        else if (isHere && contains(line, "note: ") && !errors.empty() && about++ < mostAbout)
            errors.back() += "\n" + line;
    }
    return errors;
}

std::string reasonIn(const std::string& all, int lesson)
{
    // std::regex recurses once a character: short lines only.
    constexpr std::size_t longest = 500, mostLines = 2000;
    std::string output;
    std::istringstream lines(all);
    std::size_t count = 0;
    for (std::string line; count < mostLines && std::getline(lines, line); ++count)
        output += line.substr(0, longest) + "\n";

    const std::string space = fmt::format("exercise{:02}", lesson), tracer = lesson == 0 ? "Geometry" : "Tracer";
    const auto matches = [&](const std::string& pattern, std::smatch& found) {
        return std::regex_search(output, found, std::regex(pattern));
    };
    std::smatch found;
    // Only messages about our files: what is missing in theirs, the compiler says best itself.
    const std::string ours = R"((?:^|\n)(?!exercise\.h|/source/exercise\.h)[^\n:]*tests/[^\n:]*:\d+:\d+: error: )";
    if (matches(ours + "(?:'" + space +
                    "' (?:has not been declared|does not name|was not declared|is not a)|'rt::" + space + "' has not)",
                found))
        return fmt::format("exercise.h has no namespace rt::{}", space);
    if (matches(ours + "'" + tracer + "' is not a member of '(?:rt::)?" + space + "'", found) ||
        matches(ours + "(?:invalid use of )?incomplete type '(?:struct |class )?rt::" + space + "::" + tracer + "'",
                found))
        return fmt::format("exercise.h defines no struct {} in namespace rt::{}", tracer, space);
    if (matches(ours + "'(\\w+)' is not a member of 'rt::" + space + "::" + tracer + "'", found) ||
        matches(ours + "'(?:struct |class )?rt::" + space + "::" + tracer + "' has no member named '(\\w+)'", found))
        return fmt::format("there is no function {}", found[1].str());
    if (matches("multiple definition of [`']main'", found) || matches("redefinition of 'int main\\(", found))
        return "exercise.h defines main, which is ours";
    if (matches("multiple definition of [`']([^'\n]*)'", found))
        return fmt::format("exercise.h defines {}, which is defined already", found[1].str());
    if (matches("undefined reference to [`']([^'\n]*)'", found))
        return fmt::format("{} is declared, but defined nowhere", found[1].str());
    if (matches("template instantiation depth exceeds", found)) return "templates in exercise.h are nested too deeply";
    if (matches("constexpr' (?:evaluation|loop iteration|evaluation operation) |-fconstexpr-", found))
        return "exercise.h makes the compiler compute too long";
    if (matches("out of memory allocating|virtual memory exhausted|std::bad_alloc|cannot allocate memory", found))
        return "compiling exercise.h needs too much memory";
    return "exercise.h does not compile";
}

} // namespace rt::grade
