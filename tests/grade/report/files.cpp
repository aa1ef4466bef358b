#include "tests/grade/report/files.h"

#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "common/files/text_file.h"
#include "tests/grade/report/class_html.h"
#include "tests/grade/report/gradebook_csv.h"
#include "tests/grade/report/junit_xml.h"
#include "tests/grade/report/report_html.h"
#include "tests/grade/report/text.h"

namespace rt::grade
{

namespace fs = std::filesystem;

namespace
{

void write(const std::string& path, const std::string& text)
{
    std::error_code error;
    fs::create_directories(fs::path(path).parent_path(), error);
    if (error)
        throw std::runtime_error(fmt::format("{}: the folder cannot be made ({}), expected a place to write to",
                                             fs::path(path).parent_path().string(), error.message()));
    writeTextFile(path, text);
}

/// The path as an address: what is not a letter, a digit or one of -._=/ is coded.
std::string address(const std::string& path)
{
    std::string text;
    for (const char c : path)
    {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           std::string_view("-._=/").find(c) != std::string_view::npos;
        text += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return text;
}

} // namespace

std::string reportPath(const std::string& out, const std::string& student)
{
    return out + "/reports/" + pageName(student) + ".html";
}

std::string instructorPath(const std::string& out, const std::string& student)
{
    return out + "/instructor/" + pageName(student) + ".html";
}

std::string resultPath(const std::string& out, const std::string& student)
{
    return out + "/results/" + pageName(student) + "/results.json";
}

void writeReports(const std::string& out, const SubmissionResult& result, HiddenTests hidden)
{
    write(reportPath(out, result.student), reportHtml(result));
    write(instructorPath(out, result.student), instructorHtml(result));
    write(resultPath(out, result.student), resultsJson(result, hidden));
}

void writeMissingInstructorPages(const std::string& out, std::span<const SubmissionResult> results)
{
    for (const auto& result : results)
        if (const auto path = instructorPath(out, result.student); !fs::exists(path))
            write(path, instructorHtml(result));
}

void writeClass(const std::string& out, std::span<const SubmissionResult> results)
{
    const auto linkTo = [&out](auto path) {
        return [&out, path](const std::string& student) {
            return fs::exists(path(out, student)) ? address(path(".", student).substr(2)) : std::string();
        };
    };
    write(out + "/gradebook.csv", gradebookCsv(results));
    write(out + "/junit.xml", junitXml(results));
    write(out + "/class.html", classHtml(results, {linkTo(reportPath), linkTo(instructorPath)}));
}

} // namespace rt::grade
